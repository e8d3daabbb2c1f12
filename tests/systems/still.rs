//! Systems in which nothing moves by itself: welded structures, and arms whose joints are all
//! driven. At any time they have loads, energy and momentum, but they have no motion to integrate.

use nalgebra::{Vector2, Vector3};
use newton_euler::Dual;
use newton_euler::prelude::*;

use super::compare::{Random, close};

// a column with a beam: what the welds carry, by hand
rigid_system!(Crane::<T> {
    motion: planar,
    params: [mass_of_load = 40[kg], reach = 3[m]],
    inputs: [wind[N]],
    bodies: [
        column {
            mass: 100[kg],
            inertia: 80[kg * m ^ 2],
            points: [foot = (0, -2)[m], top = (0, 2)[m]],
            forces: [push = world(wind, 0)],
        },
        beam {
            mass: 30[kg],
            inertia: 20[kg * m ^ 2],
            points: [root = (-1, 0)[m], tip = (reach - 1[m], 0[m])],
            forces: [load = (mass_of_load * world(0, -10[m / s ^ 2])).at(tip)],
        },
    ],
    joints: [
        foot = weld(world(0, 0), column.foot),
        corner = weld(column.top, beam.root),
    ],
    fields: [weight = mass * world(0, -10[m / s ^ 2])],
    outputs: [reactions, balance, energy, momentum],
});

#[test]
fn a_column_with_a_beam() {
    let (crane, state) = (Crane::<f64>::default(), CraneState::default());
    let input = CraneInput { wind: 70.0 };
    let loads = crane.reactions(0.0, &state, &input);
    close(
        "corner",
        loads.corner.force.as_slice(),
        &[0.0, 700.0],
        1e3,
        1e-15,
    );
    close(
        "corner",
        &[loads.corner.moment],
        &[300.0 + 1200.0],
        1e3,
        1e-15,
    );
    close(
        "foot",
        loads.foot.force.as_slice(),
        &[-70.0, 1700.0],
        1e3,
        1e-15,
    );
    close("foot", &[loads.foot.moment], &[1500.0 + 140.0], 1e3, 1e-15);
    let rest = crane.residual(0.0, &state, &(), &loads, &input);
    for wrench in [rest.column, rest.beam] {
        close("rest", wrench.force.as_slice(), &[0.0; 2], 1e3, 1e-15);
        close("rest", &[wrench.moment], &[0.0], 1e3, 1e-15);
    }
    let potential = crane.potential_energy(0.0, &state, &input);
    close(
        "energy",
        &[potential],
        &[1000.0 * 2.0 + 300.0 * 4.0],
        1e3,
        1e-15,
    );
    assert_eq!(crane.kinetic_energy(&state).to_bits(), 0);
    assert_eq!(crane.linear_momentum(&state), Vector2::zeros());
}

// how the moment at the foot changes with the reach
#[test]
fn a_slope_by_a_parameter() {
    let params = CraneParams {
        mass_of_load: Dual::from(40.0),
        reach: Dual::variable(3.0, 0),
    };
    let crane = Crane::<Dual<f64, 1>>::new(params).unwrap();
    let input = CraneInput {
        wind: Dual::from(70.0),
    };
    let found = crane.reactions(Dual::from(0.0), &CraneState::default(), &input);
    close(
        "slope",
        &found.foot.moment.derivatives,
        &[400.0],
        1e3,
        1e-15,
    );
}

/// Two systems of the same arm: one that moves as it is told, one with drives to be found.
macro_rules! arms {
    ($($joint:ident($carrier:expr, $carried:expr, $along:expr, $kind:ident) $value:expr, $drive:ident;)*) => {
        rigid_system!(Told {
            inputs: [reach[m].moving],
            bodies: [
                turret { mass: 4[kg], inertia: principal(0.1, 0.12, 0.2), points: [p = (0.1, 0, 0.3)] },
                upper { mass: 2[kg], inertia: tensor { xx: 0.1, yy: 0.08, zz: 0.05, xy: 0.01, yz: -0.01, zx: 0 }, points: [p = (0, 0, -0.2), q = (0, 0.1, 0.4)] },
                hand { mass: 0.7[kg], inertia: principal(0.01, 0.02, 0.015), points: [p = (0.1, 0, 0)], forces: [load = world(1[N], -2[N], 3[N])] },
            ],
            joints: [$($joint = $kind($carrier, $carried, $along).driven($value)),*],
            fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
            outputs: [reactions, energy, momentum, balance],
        });
        rigid_system!(Asked {
            bodies: [
                turret { mass: 4[kg], inertia: principal(0.1, 0.12, 0.2), points: [p = (0.1, 0, 0.3)] },
                upper { mass: 2[kg], inertia: tensor { xx: 0.1, yy: 0.08, zz: 0.05, xy: 0.01, yz: -0.01, zx: 0 }, points: [p = (0, 0, -0.2), q = (0, 0.1, 0.4)] },
                hand { mass: 0.7[kg], inertia: principal(0.01, 0.02, 0.015), points: [p = (0.1, 0, 0)], forces: [load = world(1[N], -2[N], 3[N])] },
            ],
            joints: [$($joint = $kind($carrier, $carried, $along)),*],
            drives: [$($drive = _.on($joint)),*],
            fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
            outputs: [inverse, energy, momentum],
        });
    };
}
arms! {
    slew(world(0, 0, 0), turret.G, body(0, 0, 1), revolute) 0.4[rad] * (2[rad / s] * t).sin(), first;
    lift(turret.p, upper.p, body(1, 0, 0), revolute) 0.7[rad / s] * t, second;
    slide(upper.q, hand.p, body(0, 0.6, 0.8), prismatic) reach, third;
}

// the drives, energies and momenta that the motion has are those that inverse dynamics finds for it
#[test]
fn an_arm_that_moves_as_it_is_told() {
    let (told, asked, still) = (Told::default(), Asked::default(), ToldState::default());
    let mut numbers = Random::new(17);
    for _ in 0..20 {
        let [t, reach, reach_rate, reach_acceleration] = [0; 4].map(|_| numbers.number());
        let input = ToldInput {
            reach,
            reach_rate,
            reach_acceleration,
        };
        let (sine, cosine) = (2.0 * t).sin_cos();
        let state = AskedState {
            slew: Hinge {
                angle: 0.4 * sine,
                angular_velocity: 0.8 * cosine,
            },
            lift: Hinge {
                angle: 0.7 * t,
                angular_velocity: 0.7,
            },
            slide: Slide {
                position: reach,
                velocity: reach_rate,
            },
        };
        let acceleration = AskedAcceleration {
            slew: -1.6 * sine,
            lift: 0.0,
            slide: reach_acceleration,
        };
        let needed = asked.inverse(t, &state, &acceleration, &());
        let found = told.reactions(t, &still, &input);
        close(
            "drives",
            &[found.slew_drive, found.lift_drive, found.slide_drive],
            &[needed.first, needed.second, needed.third],
            30.0,
            1e-14,
        );
        let energies = [
            told.kinetic_energy(t, &still, &input),
            told.potential_energy(t, &still, &input),
        ];
        let expected = [
            asked.kinetic_energy(&state),
            asked.potential_energy(t, &state, &()),
        ];
        close("energies", &energies, &expected, 10.0, 1e-14);
        let momentum: Vector3<f64> = told.angular_momentum_about_pole(t, &still, &input);
        let expected = asked.angular_momentum_about_pole(t, &state);
        close(
            "momentum",
            momentum.as_slice(),
            expected.as_slice(),
            10.0,
            1e-14,
        );
        let rest = told.residual(t, &still, &(), &found, &input);
        for wrench in [rest.turret, rest.upper, rest.hand] {
            close("rest", wrench.force.as_slice(), &[0.0; 3], 30.0, 1e-14);
            close("rest", wrench.moment.as_slice(), &[0.0; 3], 30.0, 1e-14);
        }
    }
}

// two links in the plane: the torques of Lagrange's equations, by hand
rigid_system!(TwoLinks {
    motion: planar,
    bodies: [
        upper {
            mass: 2[kg],
            inertia: 0.05[kg * m ^ 2],
            points: [p = (-0.3, 0)[m], q = (0.3, 0)[m]]
        },
        lower {
            mass: 1[kg],
            inertia: 0.02[kg * m ^ 2],
            points: [p = (-0.2, 0)[m]]
        },
    ],
    joints: [
        shoulder = revolute(world(0, 0), upper.p).driven((1.5[rad / s] * t).sin()),
        elbow = revolute(upper.q, lower.p).driven((1[rad / s ^ 2] * t * t).cos()),
    ],
    fields: [weight = mass * world(0, -9.81[m / s ^ 2])],
    outputs: [reactions],
});

#[test]
fn torques_of_two_links() {
    let (links, still) = (TwoLinks::default(), TwoLinksState::default());
    for step in 0..10 {
        let t = 0.3 * f64::from(step);
        let (a, a1, a2) = (
            (1.5 * t).sin(),
            1.5 * (1.5 * t).cos(),
            -2.25 * (1.5 * t).sin(),
        );
        let (b, b1) = ((t * t).cos(), -2.0 * t * (t * t).sin());
        let b2 = -2.0 * (t * t).sin() - 4.0 * t * t * (t * t).cos();
        // l1 = 0.6, c1 = 0.3, c2 = 0.2
        let (m2, c2, l1, g) = (1.0, 0.2, 0.6, 9.81);
        let coupling = m2 * l1 * c2;
        let m22 = 0.02 + m2 * c2 * c2;
        let m12 = m22 + coupling * b.cos();
        let m11 = 0.05 + 2.0 * 0.09 + m2 * l1 * l1 + m22 + 2.0 * coupling * b.cos();
        let weight_2 = m2 * g * c2 * (a + b).cos();
        let weight_1 = (2.0 * 0.3 + m2 * l1) * g * a.cos() + weight_2;
        let h = coupling * b.sin();
        let expected = [
            m11 * a2 + m12 * b2 - h * (2.0 * a1 * b1 + b1 * b1) + weight_1,
            m12 * a2 + m22 * b2 + h * a1 * a1 + weight_2,
        ];
        let found = links.reactions(t, &still, &());
        close(
            "torques",
            &[found.shoulder_drive, found.elbow_drive],
            &expected,
            30.0,
            1e-14,
        );
    }
}

// a truss of three bars on a pin and a roller, by the method of joints
rigid_system!(Truss {
    motion: planar,
    inputs: [load_x[N], load_y[N]],
    bodies: [
        bottom {
            mass: 1[kg],
            inertia: 1[kg * m ^ 2],
            points: [a = (-2, 0)[m], b = (2, 0)[m]]
        },
        left {
            mass: 1[kg],
            inertia: 1[kg * m ^ 2],
            points: [a = (-0.5, -1.5)[m], c = (0.5, 1.5)[m]],
            forces: [load = world(load_x, load_y).at(c)],
        },
        right {
            mass: 1[kg],
            inertia: 1[kg * m ^ 2],
            points: [b = (1.5, -1.5)[m], c = (-1.5, 1.5)[m]]
        },
        roller {
            mass: 1[kg],
            inertia: 1[kg * m ^ 2]
        },
    ],
    joints: [
        pin = revolute(world(0, 0), bottom.a),
        a = revolute(bottom.a, left.a),
        b = revolute(bottom.b, right.b),
        c = revolute(left.c, right.c),
        roll = prismatic(world(4, 0), roller.G, body(1, 0)),
        support = revolute(roller.G, bottom.b),
    ],
    outputs: [reactions],
});

#[test]
fn a_truss_by_the_method_of_joints() {
    let (truss, state) = (Truss::default(), TrussState::default());
    truss.check(0.0, &state, &TrussInput::default()).unwrap();
    let mut numbers = Random::new(5);
    for _ in 0..10 {
        let [x, y] = [0; 2].map(|_| 100.0 * numbers.number());
        let found = truss.reactions(
            0.0,
            &state,
            &TrussInput {
                load_x: x,
                load_y: y,
            },
        );
        // corners (0, 0), (4, 0) and (1, 3), the load at the last one; tensions of the bars
        let (left, right) = (
            [1.0 / 10_f64.sqrt(), 3.0 / 10_f64.sqrt()],
            [-0.5_f64.sqrt(), 0.5_f64.sqrt()],
        );
        // left * s + right * r = load
        let determinant = left[0] * right[1] - left[1] * right[0];
        let s = (x * right[1] - y * right[0]) / determinant;
        let r = (left[0] * y - left[1] * x) / determinant;
        let on_left = [-s * left[0], -s * left[1]];
        close("left", found.a.force.as_slice(), &on_left, 100.0, 1e-13);
        let on_right = [-r * right[0], -r * right[1]];
        close("right", found.b.force.as_slice(), &on_right, 100.0, 1e-13);
        close(
            "top",
            found.c.force.as_slice(),
            &[r * right[0], r * right[1]],
            100.0,
            1e-13,
        );
        // what is pushed to the right at the top lifts the pin and presses on the roller
        let up = (3.0 * x - y) / 4.0;
        close("roller", &[found.roll.force.y], &[up], 100.0, 1e-13);
        close(
            "pin",
            found.pin.force.as_slice(),
            &[-x, -y - up],
            100.0,
            1e-13,
        );
    }
}

rigid_system!(Shelf {
    motion: planar,
    bodies: [board {
        mass: 4[kg],
        inertia: rod(1[m]),
        points: [left = (-0.5, 0)[m], right = (0.5, 0)[m]],
    }],
    joints: [
        wall = weld(world(0, 2)[m], board.left),
        post = weld(world(1, 2)[m], board.right),
    ],
    fields: [weight = mass * world(0, -9.81[m / s ^ 2])],
    outputs: [energy],
});

/// It is held more than once, so its reactions are not determined, but its energy is.
#[test]
fn a_structure_that_is_held_twice_has_an_energy() {
    let (shelf, state) = (Shelf::default(), Still::default());
    let energy = shelf.potential_energy(0.0, &state, &());
    assert!((energy - 4.0 * 9.81 * 2.0).abs() < 1e-13);
}
