//! Constraints between bodies, compared with joints that hold the same directions, with closed
//! forms, and with laws.

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
        let (force, pin) = (held.shoulder.force, loads.shoulder.force);
        close("pin", pin.as_slice(), force.as_slice(), 30.0, 1e-11);
        // the constraint pushes the upper arm, the joint the lower one
        let elbow = [-loads.elbow_x, -loads.elbow_y];
        close("elbow", &elbow, held.elbow.force.as_slice(), 30.0, 1e-11);
        let input_kept = arms::KeptInput { push: input.push };
        let left = kept.residual(0.0, &state, &other, &loads, &input_kept);
        close("upper", left.upper.force.as_slice(), &[0.0; 2], 30.0, 1e-12);
        close("upper", &left.upper.moment.list(), &[0.0], 30.0, 1e-12);
        close("lower", left.lower.force.as_slice(), &[0.0; 2], 30.0, 1e-12);
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

/// A crate slides on a cart with friction that follows what the cart carries it with.
mod friction {
    use newton_euler::prelude::*;

    rigid_system!(Cart {
        motion: planar,
        params: [mu = 0.3],
        bodies: [
            cart {
                mass: 3[kg],
                points: [top = (0, 0.2)[m]]
            },
            load {
                mass: 5[kg],
                inertia: 0.4[kg * m ^ 2],
                points: [left = (-0.3, -0.25)[m], right = (0.4, -0.25)[m]],
            },
        ],
        joints: [
            track = prismatic(world(0, 0), cart.G, body(1, 0)),
            away = free(load)
        ],
        constraints: [
            first = load.left.position().in_world().y - cart.top.position().in_world().y,
            second = load.right.position().in_world().y - cart.top.position().in_world().y,
        ],
        drives: [drag = (mu * (first + second)).on(track)],
        fields: [weight = mass * world(0, -9.8[m / s ^ 2])],
        forces: [],
        outputs: [reactions, balance],
    });

    rigid_system!(Brake {
        motion: planar,
        params: [mu = 0.4, radius = 0.2[m]],
        bodies: [
            drum {
                mass: 2[kg],
                inertia: 0.05[kg * m ^ 2]
            },
            shoe {
                mass: 0.5[kg],
                inertia: 0.01[kg * m ^ 2],
                points: [hinge = (-0.4, 0)[m], pad = (0, -0.1)[m]],
                forces: [press = world(0, -30[N]), rub = world(mu * touch, 0).at(pad),],
            },
        ],
        joints: [
            axle = revolute(world(0, 0), drum.G),
            arm = revolute(world(-0.4, 0.3), shoe.hinge),
        ],
        constraints: [touch = shoe.pad.position().in_world().y - radius],
        moments: [friction = moment(mu * radius * touch).on(drum)],
        outputs: [reactions, inverse],
        drives: [motor = _.on(axle)],
    });
}

#[test]
fn friction_follows_what_keeps_a_constraint() {
    let cart = friction::Cart::default();
    let state = friction::CartState {
        track: Slide {
            position: 0.1,
            velocity: 0.0,
        },
        away: Planar {
            position: [0.2, 0.45].into(),
            velocity: [2.0, 0.0].into(),
            ..Planar::default()
        },
    };
    cart.check(0.0, &state, &()).unwrap();
    let found = cart.acceleration(0.0, &state, &());
    // nothing holds the crate along x: the drag acts on the cart alone, from the ground
    close("cart", &[found.track], &[0.3 * 5.0 * 9.8 / 3.0], 1.0, 1e-13);
    close("crate", found.away.linear.as_slice(), &[0.0; 2], 1.0, 1e-13);
    let loads = cart.reactions(0.0, &state, &());
    close(
        "both",
        &[loads.first + loads.second],
        &[5.0 * 9.8],
        1.0,
        1e-12,
    );
    // moments about G: 0.3 first = 0.4 second
    close(
        "first",
        &[loads.first],
        &[5.0 * 9.8 * 4.0 / 7.0],
        1.0,
        1e-12,
    );
    let left = cart.residual(0.0, &state, &found, &loads, &());
    close("cart", left.cart.force.as_slice(), &[0.0; 2], 30.0, 1e-13);
    close("crate", left.load.force.as_slice(), &[0.0; 2], 30.0, 1e-13);
    close("crate", &left.load.moment.list(), &[0.0], 30.0, 1e-13);

    let brake = friction::Brake::default();
    let turn = |rate: f64| friction::BrakeState {
        axle: Hinge {
            angle: 0.3,
            angular_velocity: rate,
        },
        arm: Hinge::default(),
    };
    let state = turn(-5.0);
    brake.check(0.0, &state, &()).unwrap();
    let found = brake.acceleration(0.0, &state, &());
    let loads = brake.reactions(0.0, &state, &());
    // about the hinge of the shoe: 0.4 (N - 30) + 0.1 mu N = 0
    let normal = 0.4 * 30.0 / (0.4 + 0.1 * 0.4);
    close("normal", &[loads.touch], &[normal], 1.0, 1e-12);
    close(
        "drum",
        &[found.axle],
        &[0.4 * 0.2 * normal / 0.05],
        1.0,
        1e-11,
    );
    assert!(found.arm.abs() < 1e-12);
    // and the motor that holds its pace
    let mut wanted = found;
    wanted.axle = 0.0;
    let drives = brake.inverse(0.0, &state, &wanted, &());
    close("motor", &[drives.motor], &[-0.4 * 0.2 * normal], 1.0, 1e-12);
}

/// A constraint that says nothing on one side of a condition.
mod stop {
    use newton_euler::prelude::*;

    rigid_system!(Stopped {
        motion: planar,
        bodies: [first { mass: 2[kg] }, second { mass: 3[kg] },],
        joints: [
            a = prismatic(world(0, 0), first.G, body(1, 0)),
            b = prismatic(world(0, 1), second.G, body(1, 0)),
        ],
        inputs: [push[N]],
        drives: [pushed = push.on(a)],
        constraints: [
            chain = if b.position > 1[m] {
                a.position - b.position
            } else {
                0[m]
            },
            even = b.velocity.max(0.5[m / s]) - 0.5[m / s],
        ],
        outputs: [reactions],
    });
}

#[test]
fn constraints_that_say_nothing_on_a_branch() {
    let stopped = stop::Stopped::default();
    let at = |position: f64, velocity: f64| stop::StoppedState {
        a: Slide { position, velocity },
        b: Slide { position, velocity },
    };
    let input = stop::StoppedInput { push: 10.0 };
    let found = |position, velocity| {
        let state = at(position, velocity);
        let found = stopped.acceleration(0.0, &state, &input);
        let loads = stopped.reactions(0.0, &state, &input);
        [found.a, found.b, loads.chain, loads.even]
    };
    close(
        "both apart",
        &found(0.5, 0.2),
        &[5.0, 0.0, 0.0, 0.0],
        1.0,
        1e-14,
    );
    close(
        "chained",
        &found(1.5, 0.2),
        &[2.0, 2.0, -6.0, 0.0],
        1.0,
        1e-13,
    );
    close("paced", &found(0.5, 0.7), &[5.0, 0.0, 0.0, 0.0], 1.0, 1e-13);
    close(
        "chained and paced",
        &found(1.5, 0.7),
        &[0.0, 0.0, -10.0, -10.0],
        1.0,
        1e-13,
    );
}
