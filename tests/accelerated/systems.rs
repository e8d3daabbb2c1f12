//! Systems with loads that depend on the accelerations of bodies, points and joints.

use nalgebra::{Matrix3, Vector2, Vector3, Vector6};
use newton_euler::prelude::*;

use crate::{Random, solve};

rigid_system!(Pair {
    motion: planar,
    bodies: [
        upper {
            mass: 2[kg],
            inertia: 0.1[kg * m ^ 2],
            points: [top = (0, 0.5), low = (0, -0.5)],
            forces: [water = -0.7[kg] * acceleration],
        },
        lower {
            mass: 1[kg],
            inertia: 0.05[kg * m ^ 2],
            points: [top = (0, 0.4), bob = (0.1, -0.4)],
            // it follows the acceleration of the other body
            forces: [wake = (0.3[kg] * upper.low.acceleration()).at(bob)],
            moments: [turned = -0.02[kg * m ^ 2] * upper.angular_acceleration],
        },
    ],
    joints: [
        shoulder = revolute(world(0, 0), upper.top),
        elbow = revolute(upper.low, lower.top),
    ],
    fields: [weight = mass * world(0, -9.81[m / s ^ 2])],
    drives: [rotor = (-0.04[kg * m ^ 2] * elbow.angular_acceleration).on(elbow)],
    outputs: [reactions, balance, mass_matrix, energy],
});

fn cross(w: f64, r: Vector2<f64>) -> Vector2<f64> {
    Vector2::new(-w * r.y, w * r.x)
}

#[test]
fn one_load_follows_the_other_body() {
    let (body, mut random) = (Pair::default(), Random(11));
    for _ in 0..20 {
        let state = PairState {
            shoulder: Hinge {
                angle: 2.0 * random.next(),
                angular_velocity: random.next(),
            },
            elbow: Hinge {
                angle: 2.0 * random.next(),
                angular_velocity: random.next(),
            },
        };
        let (first, second) = (
            state.shoulder.angle,
            state.shoulder.angle + state.elbow.angle,
        );
        let (w, v) = (
            state.shoulder.angular_velocity,
            state.shoulder.angular_velocity + state.elbow.angular_velocity,
        );
        let turned =
            |angle: f64, x: f64, y: f64| nalgebra::Rotation2::new(angle) * Vector2::new(x, y);
        // Newton and Euler, body by body: accelerations of the joints, forces at both of them
        let expected = solve(|x: &Vector6<f64>| {
            let (a, b) = (x[0], x[0] + x[1]);
            let (p, q) = (Vector2::new(x[2], x[3]), Vector2::new(x[4], x[5]));
            let of = |rate: f64, w: f64, r: Vector2<f64>| cross(rate, r) - r * w * w;
            let (g1, low) = (turned(first, 0.0, -0.5), turned(first, 0.0, -1.0));
            let (g2, bob) = (turned(second, 0.0, -0.4), turned(second, 0.1, -0.8));
            let (a1, of_low) = (of(a, w, g1), of(a, w, low));
            let a2 = of_low + of(b, v, g2);
            let weight = Vector2::new(0.0, -9.81);
            let wake = of_low * 0.3;
            let first = p - q + weight * 2.0 - a1 * 0.7 - a1 * 2.0;
            let second = q + weight + wake - a2;
            let rotor = -0.04 * x[1];
            let about_1 = -g1.perp(&p) - (low - g1).perp(&q) - rotor - 0.1 * a;
            let about_2 = -g2.perp(&q) + (bob - g2).perp(&wake) + rotor - 0.02 * a - 0.05 * b;
            Vector6::new(first.x, first.y, second.x, second.y, about_1, about_2)
        });
        let found = body.acceleration(0.0, &state, &());
        assert!(
            (found.shoulder - expected[0]).abs() < 1e-13,
            "{} {expected}",
            found.shoulder
        );
        assert!((found.elbow - expected[1]).abs() < 1e-13);
        let carried = body.reactions(0.0, &state, &());
        assert!((carried.shoulder.force - Vector2::new(expected[2], expected[3])).amax() < 1e-12);
        assert!((carried.elbow.force - Vector2::new(expected[4], expected[5])).amax() < 1e-12);
        let residuals = body.residual(0.0, &state, &found, &carried, &());
        assert!(residuals.upper.force.amax() + residuals.upper.moment.abs() < 1e-12);
        assert!(residuals.lower.force.amax() + residuals.lower.moment.abs() < 1e-12);
    }
}

rigid_system!(Armed {
    bodies: [arm {
        mass: 2[kg],
        inertia: principal(0.2, 0.3, 0.1)[kg * m ^ 2],
        points: [p = (0.1, 0.2, 0.3)],
    }],
    joints: [turn = revolute(world(0, 0, 0), arm.p, body(1, 2, 2)).armature(0.4[kg * m ^ 2])],
    fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
    drives: [motor = _.on(turn)],
    outputs: [inverse],
});

rigid_system!(Fed {
    bodies: [arm {
        mass: 2[kg],
        inertia: principal(0.2, 0.3, 0.1)[kg * m ^ 2],
        points: [p = (0.1, 0.2, 0.3)],
    }],
    joints: [turn = revolute(world(0, 0, 0), arm.p, body(1, 2, 2))],
    fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
    drives: [
        motor = _.on(turn),
        rotor = (-0.4[kg * m ^ 2] * turn.angular_acceleration).on(turn),
    ],
    outputs: [inverse],
});

/// A drive that resists the acceleration is an armature.
#[test]
fn a_drive_follows_its_joint() {
    let state = ArmedState {
        turn: Hinge {
            angle: 0.7,
            angular_velocity: 1.3,
        },
    };
    let (armed, fed) = (Armed::default(), Fed::default());
    let expected = armed.acceleration(0.0, &state, &()).turn;
    let same = FedState { turn: state.turn };
    assert!((fed.acceleration(0.0, &same, &()).turn - expected).abs() < 1e-14);
    let given = [ArmedAcceleration { turn: 2.0 }.turn; 1];
    let expected = armed
        .inverse(0.0, &state, &ArmedAcceleration { turn: given[0] }, &())
        .motor;
    let found = fed
        .inverse(0.0, &same, &FedAcceleration { turn: given[0] }, &())
        .motor;
    assert!((found - expected).abs() < 1e-14);
}

rigid_system!(Hull {
    bodies: [hull {
        mass: 12[kg],
        inertia: tensor {
            xx: 0.8,
            yy: 1.1,
            zz: 1.7,
            xy: 0,
            yz: 0,
            zx: 0.12
        }[kg * m ^ 2],
        points: [fin = (0.3, -0.2, 0.1)],
        forces: [
            added = -body(
                1[kg] * acceleration.in_body().x,
                9[kg] * acceleration.in_body().y,
                0
            ),
            at_fin = (-0.6[kg] * fin.acceleration()).at(fin),
        ],
        moments: [turned = -0.5[kg * m ^ 2] * angular_acceleration],
    }],
    joints: [floats = free(hull)],
    fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
});

rigid_body!(Alone {
    motion: spatial,
    mass: 12[kg],
    inertia: tensor {
        xx: 0.8,
        yy: 1.1,
        zz: 1.7,
        xy: 0,
        yz: 0,
        zx: 0.12
    }[kg * m ^ 2],
    points: [fin = (0.3, -0.2, 0.1)],
    fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
    forces: [
        added = -body(
            1[kg] * acceleration.in_body().x,
            9[kg] * acceleration.in_body().y,
            0
        ),
        at_fin = (-0.6[kg] * fin.acceleration()).at(fin),
    ],
    moments: [turned = -0.5[kg * m ^ 2] * angular_acceleration],
});

#[test]
fn a_free_body_of_a_system_is_a_body_alone() {
    let (hull, alone, mut random) = (Hull::default(), Alone::default(), Random(12));
    for _ in 0..20 {
        let floats = random.spatial();
        let found = hull.acceleration(0.0, &HullState { floats }, &()).floats;
        let expected = alone.acceleration(0.0, &floats, &());
        assert!((found.linear - expected.linear).amax() < 1e-13);
        assert!((found.angular - expected.angular).amax() < 1e-13);
    }
}

/// A chain of joints of many kinds, its last body in water or pushed by hand.
macro_rules! chain {
    ($name:ident [$($inputs:tt)*] [$($force:tt)*] [$($moment:tt)*]) => {
        rigid_system!($name {
            inputs: [$($inputs)*],
            bodies: [
                a {
                    mass: 1.3[kg],
                    inertia: principal(0.3, 0.4, 0.5)[kg * m ^ 2],
                    points: [p = (0.1, -0.2, 0.3), q = (-0.2, 0.4, 0.15)],
                },
                b {
                    mass: 0.7[kg],
                    inertia: principal(0.3, 0.35, 0.25)[kg * m ^ 2],
                    points: [p = (0.25, 0.1, -0.1), q = (0, -0.3, 0.2)],
                },
                c {
                    mass: 0.9[kg],
                    inertia: principal(0.12, 0.2, 0.16)[kg * m ^ 2],
                    points: [p = (-0.1, 0.2, 0.3), q = (0.3, 0.1, 0)],
                },
                d {
                    mass: 0.4[kg],
                    inertia: principal(0.05, 0.06, 0.04)[kg * m ^ 2],
                    points: [p = (0.1, 0.12, 0.2), tip = (0.1, 0.2, -0.3)],
                    forces: [water = ($($force)*).at(tip)],
                    moments: [turned = $($moment)*],
                },
            ],
            joints: [
                cross = universal(world(0, 0, 0), a.p, body(1, 0, 0), body(0, 3, 4)),
                nut = screw(a.q, b.p, body(3, 0, -4), 0.15[m]),
                ball = spherical(b.q, c.p),
                both = cylindrical(c.q, d.p, body(2, -1, 2)),
            ],
            fields: [weight = mass * world(0.3, -0.2, -9.81[m / s ^ 2])],
            outputs: [balance, reactions],
        });
    };
}
chain!(Wet [] [-0.5[kg] * tip.acceleration()] [-0.03[kg * m ^ 2] * angular_acceleration]);
chain!(Dry [force = world(_, _, _)[N], torque = world(_, _, _)[N * m]] [force] [torque]);

type Rotation3 = nalgebra::Rotation3<f64>;

/// Where the tip of the last body is, and how that body is turned, after a time of even acceleration.
fn place(state: &DryState, rates: &DryAcceleration, t: f64) -> (Vector3<f64>, Rotation3) {
    let moved = |x: f64, v: f64, a: f64| x + v * t + a * t * t / 2.0;
    let about = |x: f64, y: f64, z: f64, angle: f64| {
        Rotation3::from_axis_angle(&nalgebra::Unit::new_normalize(Vector3::new(x, y, z)), angle)
    };
    let DryState {
        cross,
        nut,
        ball,
        both,
    } = state;
    let [first, second] = [
        moved(cross.angle_1, cross.angular_velocity_1, rates.cross.x),
        moved(cross.angle_2, cross.angular_velocity_2, rates.cross.y),
    ];
    let a = about(1.0, 0.0, 0.0, first) * about(0.0, 3.0, 4.0, second);
    let at_a = a * -Vector3::new(0.1, -0.2, 0.3);
    let nut = moved(nut.angle, nut.angular_velocity, rates.nut);
    let b = a * about(3.0, 0.0, -4.0, nut);
    let along = Vector3::new(0.6, 0.0, -0.8) * (0.15 * nut);
    let at_b =
        at_a + a * (Vector3::new(-0.2, 0.4, 0.15) + along) - b * Vector3::new(0.25, 0.1, -0.1);
    let turn = ball.angular_velocity * t + rates.ball * (t * t / 2.0);
    let c = b * ball.attitude.to_rotation_matrix() * Rotation3::new(turn);
    let at_c = at_b + b * Vector3::new(0.0, -0.3, 0.2) - c * Vector3::new(-0.1, 0.2, 0.3);
    let angle = moved(both.angle, both.angular_velocity, rates.both.angular);
    let slid = moved(both.position, both.velocity, rates.both.linear);
    let d = c * about(2.0, -1.0, 2.0, angle);
    let along = Vector3::new(2.0, -1.0, 2.0) * (slid / 3.0);
    let at_d = at_c + c * (Vector3::new(0.3, 0.1, 0.0) + along) - d * Vector3::new(0.1, 0.12, 0.2);
    (at_d + d * Vector3::new(0.1, 0.2, -0.3), d)
}

/// The water is a force and a moment by hand, which follow the second differences of the motion.
#[test]
fn a_chain_in_space() {
    let (wet, dry, mut random) = (Wet::default(), Dry::default(), Random(13));
    for _ in 0..10 {
        let hinge = |random: &mut Random| Hinge {
            angle: random.next(),
            angular_velocity: random.next(),
        };
        let state = DryState {
            cross: Universal {
                angle_1: random.next(),
                angle_2: random.next(),
                angular_velocity_1: random.next(),
                angular_velocity_2: random.next(),
            },
            nut: hinge(&mut random),
            ball: Rotation {
                attitude: random.attitude(),
                angular_velocity: random.vector(),
            },
            both: Cylinder {
                position: random.next(),
                angle: random.next(),
                velocity: random.next(),
                angular_velocity: random.next(),
            },
        };
        let DryState {
            cross,
            nut,
            ball,
            both,
        } = state;
        let found = wet.acceleration(
            0.0,
            &WetState {
                cross,
                nut,
                ball,
                both,
            },
            &(),
        );
        let whole = WetState {
            cross,
            nut,
            ball,
            both,
        };
        let carried = wet.reactions(0.0, &whole, &());
        let left = wet.residual(0.0, &whole, &found, &carried, &());
        for residual in [left.a, left.b, left.c, left.d] {
            assert!(residual.force.amax() + residual.moment.amax() < 1e-12);
        }
        let rates = DryAcceleration {
            cross: found.cross,
            nut: found.nut,
            ball: found.ball,
            both: found.both,
        };
        let h = 2e-3;
        let at = |number: f64| place(&state, &rates, number * h);
        let weights = [
            (-2.0, -1.0),
            (-1.0, 16.0),
            (0.0, -30.0),
            (1.0, 16.0),
            (2.0, -1.0),
        ];
        let mut acceleration = Vector3::zeros();
        let mut turned = Matrix3::zeros();
        for (number, weight) in weights {
            let (tip, rotation) = at(number);
            acceleration += tip * (weight / (12.0 * h * h));
            turned += rotation.matrix() * (weight / (12.0 * h * h));
        }
        // R^T R'' = [alpha] + [w]^2
        let body = at(0.0).1.inverse().matrix() * turned;
        let skew = (body - body.transpose()) / 2.0;
        let angular = Vector3::new(skew[(2, 1)], skew[(0, 2)], skew[(1, 0)]);
        let input = DryInput {
            force: acceleration * -0.5,
            torque: at(0.0).1 * angular * -0.03,
        };
        let expected = dry.acceleration(0.0, &state, &input);
        assert!(
            (found.cross - expected.cross).amax() < 1e-6,
            "{} {}",
            found.cross,
            expected.cross
        );
        assert!((found.nut - expected.nut).abs() < 1e-6);
        assert!((found.ball - expected.ball).amax() < 1e-6);
        assert!((found.both.linear - expected.both.linear).abs() < 1e-6);
        assert!((found.both.angular - expected.both.angular).abs() < 1e-6);
    }
}

rigid_system!(Loop {
    motion: planar,
    inputs: [torque[N * m]],
    bodies: [
        crank {
            mass: 1[kg],
            inertia: 0.02[kg * m ^ 2],
            points: [a = (-0.1, 0), b = (0.1, 0)]
        },
        coupler {
            mass: 2[kg],
            inertia: 0.2[kg * m ^ 2],
            points: [a = (-0.5, 0), b = (0.5, 0)],
            forces: [water = -1.5[kg] * acceleration],
        },
        rocker {
            mass: 1.5[kg],
            inertia: 0.1[kg * m ^ 2],
            points: [b = (0, 0.3), c = (0, -0.3)]
        },
    ],
    joints: [
        o = revolute(world(0, 0), crank.a),
        a = revolute(crank.b, coupler.a),
        b = revolute(coupler.b, rocker.b),
        c = revolute(world(0.9, -0.3), rocker.c),
    ],
    drives: [motor = torque.on(o)],
    outputs: [balance, reactions],
});

/// A loop of which one body is in water: it is as if that body had more mass, without weight.
#[test]
fn a_loop() {
    let body = Loop::default();
    let mut state = LoopState {
        o: Hinge {
            angle: 0.4,
            angular_velocity: 1.0,
        },
        a: Hinge {
            angle: -0.2,
            angular_velocity: 0.3,
        },
        b: Hinge {
            angle: 0.1,
            angular_velocity: -0.6,
        },
    };
    let input = LoopInput { torque: 2.0 };
    body.project(0.0, &mut state, &input).unwrap();
    let found = body.acceleration(0.0, &state, &input);
    let heavy = Heavy::default();
    let LoopState { o, a, b } = state;
    let expected = heavy.acceleration(0.0, &HeavyState { o, a, b }, &HeavyInput { torque: 2.0 });
    assert!(
        (found.o - expected.o).abs() < 1e-11 * expected.o.abs(),
        "{found:?} {expected:?}"
    );
    assert!((found.a - expected.a).abs() < 1e-11 * expected.a.abs());
    assert!((found.b - expected.b).abs() < 1e-11 * expected.b.abs());
    let carried = body.reactions(0.0, &state, &input);
    let residual = body.residual(0.0, &state, &found, &carried, &input);
    assert!(residual.coupler.force.amax() < 1e-10 && residual.coupler.moment.abs() < 1e-10);
}

rigid_system!(Heavy {
    motion: planar,
    inputs: [torque[N * m]],
    bodies: [
        crank {
            mass: 1[kg],
            inertia: 0.02[kg * m ^ 2],
            points: [a = (-0.1, 0), b = (0.1, 0)]
        },
        coupler {
            mass: 3.5[kg],
            inertia: 0.2[kg * m ^ 2],
            points: [a = (-0.5, 0), b = (0.5, 0)],
        },
        rocker {
            mass: 1.5[kg],
            inertia: 0.1[kg * m ^ 2],
            points: [b = (0, 0.3), c = (0, -0.3)]
        },
    ],
    joints: [
        o = revolute(world(0, 0), crank.a),
        a = revolute(crank.b, coupler.a),
        b = revolute(coupler.b, rocker.b),
        c = revolute(world(0.9, -0.3), rocker.c),
    ],
    drives: [motor = torque.on(o)],
});
