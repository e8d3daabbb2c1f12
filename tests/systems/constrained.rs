//! Constraints across bodies: beside joints that hold the same, beside closed forms, and by laws.

use newton_euler::prelude::*;

use super::compare::{Listed, Random, close};

/// Two arms on joints, and the same held by constraints: an arm on the ground, the other one on it.
mod arms {
    use newton_euler::prelude::*;

    macro_rules! arms {
        ($name:ident, [$($joints:tt)*], [$($constraints:tt)*]) => {
            rigid_system!($name {
                motion: planar,
                inputs: [push[N * m]],
                bodies: [
                    upper {
                        mass: 1.2[kg],
                        inertia: 0.04[kg * m ^ 2],
                        points: [hinge = (-0.28, 0.02)[m], tip = (0.32, -0.01)[m]],
                    },
                    lower {
                        mass: 0.8[kg],
                        inertia: 0.015[kg * m ^ 2],
                        points: [hinge = (-0.22, 0.03)[m], end = (0.2, 0)[m]],
                        forces: [drag = (-0.4[N * s / m] * end.velocity()).at(end)],
                        moments: [motor = push],
                    },
                ],
                joints: [$($joints)*],
                $($constraints)*
                fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
                outputs: [energy, reactions, balance],
            });
        };
    }

    arms!(
        Jointed,
        [
            shoulder = revolute(world(0.1, 0.2), upper.hinge),
            elbow = revolute(upper.tip, lower.hinge),
        ],
        []
    );
    arms!(
        Kept,
        [shoulder = revolute(world(0.1, 0.2), upper.hinge), away = free(lower)],
        [constraints: [elbow = upper.tip.position() - lower.hinge.position()],]
    );
    arms!(
        Free,
        [first = free(upper), second = free(lower)],
        [constraints: [
            shoulder = upper.hinge.position() - world(0.1, 0.2)[m],
            elbow = lower.hinge.velocity() - upper.tip.velocity(),
        ],]
    );
}

#[test]
fn constraints_hold_as_joints_do() {
    let mut numbers = Random::new(11);
    for _ in 0..20 {
        let mut number = || 2.0 * numbers.number();
        let start = arms::JointedState {
            shoulder: Hinge {
                angle: number(),
                angular_velocity: number(),
            },
            elbow: Hinge {
                angle: number(),
                angular_velocity: number(),
            },
        };
        let input = arms::JointedInput { push: number() };
        let (jointed, kept) = (arms::Jointed::default(), arms::Kept::default());
        let found = jointed.acceleration(0.0, &start, &input);
        let held = jointed.reactions(0.0, &start, &input);
        // the same state, with the lower arm free
        let turn = |angle: f64, x: f64, y: f64| {
            let (s, c) = angle.sin_cos();
            nalgebra::Vector2::new(c * x - s * y, s * x + c * y)
        };
        let across = |v: nalgebra::Vector2<f64>| nalgebra::Vector2::new(-v.y, v.x);
        let angle = start.shoulder.angle + start.elbow.angle;
        let rate = start.shoulder.angular_velocity + start.elbow.angular_velocity;
        let reach = turn(start.shoulder.angle, 0.6, -0.03);
        let from_hinge = turn(angle, 0.22, -0.03);
        let place = nalgebra::Vector2::new(0.1, 0.2) + reach + from_hinge;
        let velocity = start.shoulder.angular_velocity * across(reach) + rate * across(from_hinge);
        let state = arms::KeptState {
            shoulder: start.shoulder,
            away: Planar {
                position: place,
                angle,
                velocity,
                angular_velocity: rate,
            },
        };
        let other = kept.acceleration(0.0, &state, &arms::KeptInput { push: input.push });
        close(
            "shoulder",
            &[other.shoulder],
            &[found.shoulder],
            30.0,
            1e-11,
        );
        let sum = found.shoulder + found.elbow;
        close("lower", &[other.away.angular], &[sum], 30.0, 1e-11);
        let loads = kept.reactions(0.0, &state, &arms::KeptInput { push: input.push });
        let force = held.shoulder.force;
        close(
            "shoulder",
            loads.shoulder.force.as_slice(),
            force.as_slice(),
            30.0,
            1e-11,
        );
        // the constraint pushes the upper arm, the joint the lower one
        let elbow = [-loads.elbow_x, -loads.elbow_y];
        close("elbow", &elbow, held.elbow.force.as_slice(), 30.0, 1e-11);
        let input_kept = arms::KeptInput { push: input.push };
        let left = kept.residual(0.0, &state, &other, &loads, &input_kept);
        close("upper", left.upper.force.as_slice(), &[0.0; 2], 30.0, 1e-12);
        close("upper", &left.upper.moment.list(), &[0.0], 30.0, 1e-12);
        close("lower", left.lower.force.as_slice(), &[0.0; 2], 30.0, 1e-12);
        close("lower", &left.lower.moment.list(), &[0.0], 30.0, 1e-12);
        assert!(kept.check(0.0, &state, &input_kept).is_ok());

        // and both free
        let center = nalgebra::Vector2::new(0.1, 0.2) + turn(start.shoulder.angle, 0.28, -0.02);
        let arm = turn(start.shoulder.angle, 0.28, -0.02);
        let state = arms::FreeState {
            first: Planar {
                position: center,
                angle: start.shoulder.angle,
                velocity: start.shoulder.angular_velocity * across(arm),
                angular_velocity: start.shoulder.angular_velocity,
            },
            second: state.away,
        };
        let free = arms::Free::default();
        let input = arms::FreeInput { push: input.push };
        let other = free.acceleration(0.0, &state, &input);
        close(
            "first",
            &[other.first.angular],
            &[found.shoulder],
            30.0,
            1e-11,
        );
        close("second", &[other.second.angular], &[sum], 30.0, 1e-11);
        let loads = free.reactions(0.0, &state, &input);
        let shoulder = [loads.shoulder_x, loads.shoulder_y];
        close(
            "shoulder",
            &shoulder,
            held.shoulder.force.as_slice(),
            30.0,
            1e-11,
        );
        let elbow = [loads.elbow_x, loads.elbow_y];
        close("elbow", &elbow, held.elbow.force.as_slice(), 30.0, 1e-11);
        let left = free.residual(0.0, &state, &other, &loads, &input);
        close("upper", left.upper.force.as_slice(), &[0.0; 2], 30.0, 1e-12);
        close("upper", &left.upper.moment.list(), &[0.0], 30.0, 1e-12);
        close("lower", &left.lower.moment.list(), &[0.0], 30.0, 1e-12);
    }
}

/// A motor turns a drum by a pair of gears; the drum lifts a load by a rack.
mod gears {
    use newton_euler::prelude::*;

    rigid_system!(Hoist {
        motion: planar,
        params: [ratio = 4.5, radius = 0.08[m]],
        inputs: [torque[N * m]],
        bodies: [
            motor {
                mass: 0.5[kg],
                inertia: 0.0002[kg * m ^ 2]
            },
            drum {
                mass: 3[kg],
                inertia: 0.02[kg * m ^ 2]
            },
            load {
                mass: 12[kg],
                inertia: 0.1[kg * m ^ 2]
            },
        ],
        joints: [
            shaft = revolute(world(0, 0), motor.G),
            axle = revolute(world(0.2, 0), drum.G),
            lift = prismatic(world(0.28, -1), load.G, body(0, 1)),
        ],
        drives: [motor_torque = torque.on(shaft)],
        constraints: [
            mesh = shaft.angle + ratio * axle.angle,
            rope = lift.position - radius * axle.angle,
        ],
        fields: [weight = mass * world(0, -9.81[m / s ^ 2])],
        outputs: [energy, reactions],
    });

    rigid_system!(Driven {
        motion: planar,
        params: [speed = 2[rad / s ^ 2]],
        bodies: [
            wheel {
                mass: 0.5[kg],
                inertia: 0.002[kg * m ^ 2]
            },
            drum {
                mass: 3[kg],
                inertia: 0.02[kg * m ^ 2]
            },
        ],
        joints: [
            shaft = revolute(world(0, 0), wheel.G).driven(speed * t * t / 2),
            axle = revolute(world(0.2, 0), drum.G),
        ],
        constraints: [mesh = shaft.angle + 3 * axle.angle],
        potentials: [coil = 0.7[N * m] * shaft.angle.powi(2) / 2],
        outputs: [reactions],
    });
}

#[test]
fn gears_and_racks() {
    let hoist = gears::Hoist::default();
    let input = gears::HoistInput { torque: 1.3 };
    let rate = 0.7;
    let state = gears::HoistState {
        shaft: Hinge {
            angle: -4.5 * 0.3,
            angular_velocity: -4.5 * rate,
        },
        axle: Hinge {
            angle: 0.3,
            angular_velocity: rate,
        },
        lift: Slide {
            position: 0.08 * 0.3,
            velocity: 0.08 * rate,
        },
    };
    hoist.check(0.0, &state, &input).unwrap();
    // (J_motor n^2 + J_drum + m r^2) drum'' = -n torque - m g r
    let inertia = 0.0002 * 4.5 * 4.5 + 0.02 + 12.0 * 0.08 * 0.08;
    let drum = (-4.5 * 1.3 - 12.0 * 9.81 * 0.08) / inertia;
    let found = hoist.acceleration(0.0, &state, &input);
    close("axle", &[found.axle], &[drum], 1.0, 1e-13);
    close("shaft", &[found.shaft], &[-4.5 * drum], 1.0, 1e-13);
    close("lift", &[found.lift], &[0.08 * drum], 1.0, 1e-13);
    let loads = hoist.reactions(0.0, &state, &input);
    close(
        "mesh",
        &[loads.mesh],
        &[-4.5 * drum * 0.0002 - 1.3],
        1.0,
        1e-12,
    );
    close(
        "rope",
        &[loads.rope],
        &[12.0 * (0.08 * drum + 9.81)],
        1.0,
        1e-12,
    );
    // a gear pushes axles apart or not: as a pair of moments it does not
    assert_eq!(loads.axle.moment, 0.0 + loads.axle.moment);

    let driven = gears::Driven::default();
    let state = gears::DrivenState {
        axle: Hinge {
            angle: -1.0 / 3.0,
            angular_velocity: -2.0 / 3.0,
        },
    };
    let found = driven.acceleration(1.0, &state, &());
    close("axle", &[found.axle], &[-2.0 / 3.0], 1.0, 1e-14);
    let loads = driven.reactions(1.0, &state, &());
    let mesh = 0.02 * (-2.0 / 3.0) / 3.0;
    close("mesh", &[loads.mesh], &[mesh], 1.0, 1e-14);
    // the drive turns the wheel, winds the coil and pushes the gear
    let drive = 0.002 * 2.0 + 0.7 * 1.0 - mesh;
    close("drive", &[loads.shaft_drive], &[drive], 1.0, 1e-13);
}
