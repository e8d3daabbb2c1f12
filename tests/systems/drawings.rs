//! Systems that are drawn in the pose with zero coordinates.

use nalgebra::Vector3;
use newton_euler::prelude::*;

use super::compare::{Jointed, Listed, Random, close};
use super::described::{Ur5, Ur5Input, Ur5State};

rigid_system!(DrawnUr5 {
    drawing: zero_pose,
    inputs: [
        drives_1[N * m],
        drives_2[N * m],
        drives_3[N * m],
        drives_4[N * m],
        drives_5[N * m],
        drives_6[N * m],
    ],
    bodies: [
        shoulder {
            mass: 3.7[kg],
            inertia: principal(0.010267495893, 0.010267495893, 0.00666)[kg * m ^ 2]
                .at((0, 0, 0.089159)[m]),
        },
        upper_arm {
            mass: 8.393[kg],
            inertia: principal(0.0151074, 0.22689067591, 0.22689067591)[kg * m ^ 2]
                .at((0.28, 0.13585, 0.089159)[m]),
        },
        forearm {
            mass: 2.275[kg],
            inertia: principal(0.004095, 0.049443313556, 0.049443313556)[kg * m ^ 2]
                .at((0.675, 0.01615, 0.089159)[m]),
        },
        first {
            mass: 1.219[kg],
            inertia: principal(0.111172755531, 0.111172755531, 0.21942)[kg * m ^ 2]
                .at((0.81725, 0.01615, 0.089159)[m]),
        },
        second {
            mass: 1.219[kg],
            inertia: principal(0.111172755531, 0.111172755531, 0.21942)[kg * m ^ 2]
                .at((0.81725, 0.10915, 0.089159)[m]),
        },
        third {
            mass: 0.1879[kg],
            inertia: principal(0.0171364731454, 0.0171364731454, 0.033822)[kg * m ^ 2]
                .at((0.81725, 0.10915, -0.005491)[m]),
        },
    ],
    joints: [
        pan = revolute(world, shoulder, (0, 0, 1)).at((0, 0, 0.089159)[m]),
        lift = revolute(shoulder, upper_arm, (0, 1, 0)).at((0, 0.13585, 0.089159)[m]),
        elbow = revolute(upper_arm, forearm, (0, 1, 0)).at((0.425, 0.01615, 0.089159)[m]),
        wrist_1 = revolute(forearm, first, (0, 1, 0)).at((0.81725, 0.01615, 0.089159)[m]),
        wrist_2 = revolute(first, second, (0, 0, -1)).at((0.81725, 0.10915, 0.089159)[m]),
        wrist_3 = revolute(second, third, (0, 1, 0)).at((0.81725, 0.10915, -0.005491)[m]),
    ],
    fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
    drives: [
        a = drives_1.on(pan),
        b = drives_2.on(lift),
        c = drives_3.on(elbow),
        d = drives_4.on(wrist_1),
        e = drives_5.on(wrist_2),
        f = drives_6.on(wrist_3),
    ],
    outputs: [energy, reactions],
});

#[test]
fn an_arm_with_points_and_drawn() {
    let mut numbers = Random::new(1);
    for _ in 0..50 {
        let [pan, lift, elbow, wrist_1, wrist_2, wrist_3]: [Hinge; 6] =
            [0; 6].map(|_| Jointed::random(&mut numbers));
        let [drives_1, drives_2, drives_3, drives_4, drives_5, drives_6] =
            [0; 6].map(|_| 10.0 * numbers.number());
        let (written, drawn) = (Ur5::default(), DrawnUr5::default());
        let state = Ur5State {
            pan,
            lift,
            elbow,
            wrist_1,
            wrist_2,
            wrist_3,
        };
        let drawn_state = DrawnUr5State {
            pan,
            lift,
            elbow,
            wrist_1,
            wrist_2,
            wrist_3,
        };
        let input = Ur5Input {
            drives_1,
            drives_2,
            drives_3,
            drives_4,
            drives_5,
            drives_6,
        };
        let drawn_input = DrawnUr5Input {
            drives_1,
            drives_2,
            drives_3,
            drives_4,
            drives_5,
            drives_6,
        };
        let a = written.acceleration(0.0, &state, &input);
        let b = drawn.acceleration(0.0, &drawn_state, &drawn_input);
        let [a, b] = [
            [a.pan, a.lift, a.elbow, a.wrist_1, a.wrist_2, a.wrist_3],
            [b.pan, b.lift, b.elbow, b.wrist_1, b.wrist_2, b.wrist_3],
        ];
        close("acceleration", &b, &a, 1.0, 1e-12);
        let loads = written.reactions(0.0, &state, &input);
        let found = drawn.reactions(0.0, &drawn_state, &drawn_input);
        close("reaction", &found.pan.list(), &loads.pan.list(), 1.0, 1e-12);
        close(
            "reaction",
            &found.elbow.list(),
            &loads.elbow.list(),
            1.0,
            1e-12,
        );
        close(
            "reaction",
            &found.wrist_3.list(),
            &loads.wrist_3.list(),
            100.0,
            1e-12,
        );
        let energies = [
            [
                written.kinetic_energy(&state),
                drawn.kinetic_energy(&drawn_state),
            ],
            [
                written.potential_energy(0.0, &state, &input),
                drawn.potential_energy(0.0, &drawn_state, &drawn_input),
            ],
        ];
        for [written, drawn] in energies {
            close("energy", &[drawn], &[written], 1.0, 1e-12);
        }
    }
}

// parts, points, moments of inertia about points, copies, ground, loads and a body that does not turn,
// in a drawing and without one
rigid_system!(Drawn {
    drawing: zero_pose,
    params: [height = 0.3[m]],
    bodies: [
        cart {
            mass: 3[kg].at((0.1, 0, height))
        },
        arm {
            inertia: compose([
                sphere(0.1[m]).mass(2[kg]).at((0.2, 0.3, 0.1)),
                cylinder(0.05[m], 0.4[m]).mass(1[kg]).at((0.2, 0.3, 0.4)),
            ]),
            points: [tip = (0.2, 0.3, 0.6)],
            forces: [wind = world(1, 2, 3)[N].at(tip)],
        },
        pole {
            mass: 1.5[kg],
            inertia: principal(0.5, 0.4, 0.3)[kg * m ^ 2]
                .about((0.2, 0.3, 0.6)[m])
                .at((0.1, 0.3, 0.8)[m]),
            points: [end = (0.1, 0.3, 1)[m]],
        },
        wheel {
            copies: [a = body(1, 0, 0), b = body(0, 1, 0)],
            mass: 0.4[kg],
            inertia: disc(0.1[m]).at((0.1, 0.3, 1)[m]),
        },
        float {
            mass: 2[kg],
            inertia: principal(0.1, 0.2, 0.25)[kg * m ^ 2].at((5, 5, 5)[m]),
            points: [eye = (5, 5.1, 5)],
        },
    ],
    joints: [
        rail = prismatic(world, cart, (1, 0, 0)).at((0, 0, height)),
        swing = universal(cart, arm, (0, 1, 0), (1, 0, 0)).at((0.1, 0.2, height)),
        ball = spherical(arm, pole).at((0.2, 0.3, 0.6)[m]),
        spin_a = revolute(pole, wheel_a, (1, 0, 0)).at((0.1, 0.3, 1)[m]),
        spin_b = cylindrical(pole, wheel_b, (0, 1, 0)).at((0.1, 0.3, 1)[m]),
        flight = free(float),
    ],
    fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
    forces: [spring = (3[N]).between(pole.end, float.eye)],
    potentials: [tie = 10[N / m] * (arm.tip.position() - world(1, 1, 1)[m]).norm_squared()],
    outputs: [energy],
});
rigid_system!(WithPoints {
    params: [height = 0.3[m]],
    bodies: [
        cart {
            mass: 3[kg],
            points: [rail_ = (-0.1, 0, 0), hook = (0, 0.2, 0)]
        },
        arm {
            inertia: compose([
                sphere(0.1[m]).mass(2[kg]),
                cylinder(0.05[m], 0.4[m]).mass(1[kg]).at((0, 0, 0.3)),
            ]),
            points: [pin = (-0.1, -0.1, height - 0.1[m]), tip = (0, 0, 0.5)],
            forces: [wind = world(1, 2, 3)[N].at(tip)],
        },
        pole {
            mass: 1.5[kg],
            inertia: principal(0.5, 0.4, 0.3)[kg * m ^ 2].about(pin),
            points: [pin = (0.1, 0, -0.2)[m], end = (0, 0, 0.2)[m]],
        },
        wheel {
            copies: [a = body(1, 0, 0), b = body(0, 1, 0)],
            mass: 0.4[kg],
            inertia: disc(0.1[m]),
        },
        float {
            mass: 2[kg],
            inertia: principal(0.1, 0.2, 0.25)[kg * m ^ 2],
            points: [eye = (0, 0.1, 0)],
        },
    ],
    joints: [
        rail = prismatic(world(0, 0, height), cart.rail_, body(1, 0, 0)),
        swing = universal(cart.hook, arm.pin, body(0, 1, 0), body(1, 0, 0)),
        ball = spherical(arm.tip, pole.pin),
        spin_a = revolute(pole.end, wheel_a.G, body(1, 0, 0)),
        spin_b = cylindrical(pole.end, wheel_b.G, body(0, 1, 0)),
        flight = free(float),
    ],
    fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
    forces: [spring = (3[N]).between(pole.end, float.eye)],
    potentials: [tie = 10[N / m] * (arm.tip.position() - world(1, 1, 1)[m]).norm_squared()],
    outputs: [energy],
});

#[test]
fn all_that_can_be_drawn() {
    let mut numbers = Random::new(2);
    for _ in 0..50 {
        let height = 0.3 + 0.1 * numbers.number();
        let drawn = Drawn::new(DrawnParams { height }).unwrap();
        let written = WithPoints::new(WithPointsParams { height }).unwrap();
        let (rail, swing, ball) = (
            Jointed::random(&mut numbers),
            Jointed::random(&mut numbers),
            Jointed::random(&mut numbers),
        );
        let (spin_a, spin_b, mut flight): (_, _, Spatial) = (
            Jointed::random(&mut numbers),
            Jointed::random(&mut numbers),
            Jointed::random(&mut numbers),
        );
        flight.position += Vector3::new(20.0, 0.0, 0.0);
        let state = DrawnState {
            rail,
            swing,
            ball,
            spin_a,
            spin_b,
            flight,
        };
        let other = WithPointsState {
            rail,
            swing,
            ball,
            spin_a,
            spin_b,
            flight,
        };
        let (a, b) = (
            drawn.acceleration(0.0, &state, &()),
            written.acceleration(0.0, &other, &()),
        );
        let list = |lists: [Vec<f64>; 6]| lists.concat();
        let a = list([
            a.rail.list(),
            a.swing.list(),
            a.ball.list(),
            a.spin_a.list(),
            a.spin_b.list(),
            a.flight.list(),
        ]);
        let b = list([
            b.rail.list(),
            b.swing.list(),
            b.ball.list(),
            b.spin_a.list(),
            b.spin_b.list(),
            b.flight.list(),
        ]);
        close("acceleration", &a, &b, 1.0, 1e-12);
        let (a, b) = (
            drawn.kinetic_energy(&state) + drawn.potential_energy(0.0, &state, &()),
            written.kinetic_energy(&other) + written.potential_energy(0.0, &other, &()),
        );
        close("energy", &[a], &[b], 1.0, 1e-12);
    }
}

rigid_system!(Flat {
    motion: planar,
    drawing: zero_pose,
    bodies: [
        upper {
            mass: 1.2[kg],
            inertia: 0.04[kg * m ^ 2].at((1.28, 2)[m])
        },
        lower {
            mass: 0.8[kg],
            inertia: 0.015[kg * m ^ 2].at((1.82, 2)[m])
        },
    ],
    joints: [
        shoulder = revolute(world, upper).at((1, 2)[m]),
        elbow = prismatic(upper, lower, (1, 0)).at((1.6, 2)[m]),
    ],
    outputs: [energy],
});

#[test]
fn a_drawing_in_the_plane() {
    let state = FlatState {
        shoulder: Hinge {
            angle: 0.7,
            angular_velocity: 2.0,
        },
        elbow: Slide {
            position: 0.1,
            velocity: 0.3,
        },
    };
    let kinetic = Flat::default().kinetic_energy(&state);
    // by hand: distances from the shoulder
    let (first, second) = (1.2 * 0.28 * 0.28 + 0.04, 0.8 * 0.92 * 0.92 + 0.015);
    let expected = (first + second) * 4.0 / 2.0 + 0.8 * 0.3 * 0.3 / 2.0;
    close("energy", &[kinetic], &[expected], 0.0, 1e-14);
}
