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

/// Rolling in space: a disc alone as a body with reactions, and as a system; and on a turntable.
mod rolling {
    use newton_euler::prelude::*;

    rigid_body!(Disc {
        motion: spatial,
        params: [radius = 0.3[m]],
        mass: 2[kg],
        inertia: principal(0.05, 0.09, 0.05)[kg * m ^ 2],
        locals: [
            axis = body(0, 1, 0),
            down = world(0, 0, -1) + axis.in_world().z * axis,
        ],
        points: [contact = G + radius * down / down.norm()],
        fields: [weight = mass * world(0, 0, -9.8[m / s ^ 2])],
        constraints: [rolling = contact.velocity()],
        reactions: [ground = world(_, _, _).at(contact)],
        outputs: [reactions],
    });

    rigid_system!(Discs {
        params: [radius = 0.3[m]],
        bodies: [disc {
            mass: 2[kg],
            inertia: principal(0.05, 0.09, 0.05)[kg * m ^ 2],
            locals: [
                axis = body(0, 1, 0),
                down = world(0, 0, -1) + axis.in_world().z * axis,
            ],
            points: [contact = G + radius * down / down.norm()],
            constraints: [rolling = contact.velocity()],
        },],
        joints: [away = free(disc)],
        fields: [weight = mass * world(0, 0, -9.8[m / s ^ 2])],
        outputs: [reactions, balance, energy],
    });

    // the same disc on a hinged fork without mass of its own worth speaking of, and held by its height
    rigid_system!(Tilted {
        params: [radius = 0.3[m]],
        bodies: [
            fork {
                mass: 0.5[kg],
                inertia: principal(0.02, 0.03, 0.04)[kg * m ^ 2]
            },
            disc {
                mass: 2[kg],
                inertia: principal(0.05, 0.09, 0.05)[kg * m ^ 2],
                locals: [
                    axis = body(0, 1, 0),
                    down = world(0, 0, -1) + axis.in_world().z * axis,
                ],
                points: [contact = G + radius * down / down.norm()],
            },
        ],
        joints: [
            away = free(fork),
            hub = revolute(fork.G, disc.G, body(0, 1, 0)),
        ],
        constraints: [
            touch = disc.contact.position().in_world().z,
            slip = disc.contact.velocity().in_world().x,
        ],
        fields: [weight = mass * world(0, 0, -9.8[m / s ^ 2])],
        outputs: [reactions, balance],
    });

    // a ball on a turntable goes round in circles, at 2/7 of its rate
    rigid_system!(Turntable {
        params: [radius = 0.05[m]],
        bodies: [
            table {
                mass: 8[kg],
                inertia: principal(0.2, 0.2, 0.4)[kg * m ^ 2]
            },
            ball {
                mass: 0.4[kg],
                inertia: sphere(0.05[m])
            },
        ],
        joints: [
            axle = revolute(world(0, 0, 0), table.G, body(0, 0, 1)).driven(2[rad / s] * t),
            away = free(ball),
        ],
        locals: [
            arm = world(0, 0, -1) * radius,
            under = ball.position + arm,
            matter = table.angular_velocity.cross(under),
        ],
        constraints: [rolling = ball.velocity + ball.angular_velocity.cross(arm) - matter,],
        fields: [weight = mass * world(0, 0, -9.8[m / s ^ 2])],
        outputs: [reactions],
    });
}

#[test]
fn bodies_roll_in_space() {
    let mut numbers = Random::new(5);
    let (alone, discs) = (rolling::Disc::default(), rolling::Discs::default());
    for _ in 0..20 {
        let mut vector = || nalgebra::Vector3::from_fn(|_, _| numbers.number());
        let attitude = nalgebra::UnitQuaternion::from_scaled_axis(vector());
        let mut state = Spatial {
            position: vector(),
            attitude,
            velocity: vector(),
            angular_velocity: vector(),
        };
        alone.project(0.0, &mut state, &()).unwrap();
        let system = rolling::DiscsState { away: state };
        let (one, other) = (
            alone.acceleration(0.0, &state, &()),
            discs.acceleration(0.0, &system, &()),
        );
        close(
            "linear",
            other.away.linear.as_slice(),
            one.linear.as_slice(),
            10.0,
            1e-11,
        );
        close(
            "angular",
            other.away.angular.as_slice(),
            one.angular.as_slice(),
            10.0,
            1e-11,
        );
        let ground = alone.reactions(0.0, &state, &()).unwrap().ground;
        let loads = discs.reactions(0.0, &system, &());
        let found = [
            loads.disc_rolling_x,
            loads.disc_rolling_y,
            loads.disc_rolling_z,
        ];
        close("ground", &found, ground.as_slice(), 30.0, 1e-11);
        let left = discs.residual(0.0, &system, &other, &loads, &());
        close("force", left.disc.force.as_slice(), &[0.0; 3], 30.0, 1e-12);
        close(
            "moment",
            left.disc.moment.as_slice(),
            &[0.0; 3],
            30.0,
            1e-12,
        );
    }
    let tilted = rolling::Tilted::default();
    for _ in 0..20 {
        let mut vector = || nalgebra::Vector3::from_fn(|_, _| numbers.number());
        let away = Spatial {
            position: vector(),
            attitude: nalgebra::UnitQuaternion::from_scaled_axis(vector()),
            velocity: vector(),
            angular_velocity: vector(),
        };
        let mut state = rolling::TiltedState {
            away,
            hub: Hinge {
                angle: numbers.number(),
                angular_velocity: numbers.number(),
            },
        };
        tilted.project(0.0, &mut state, &()).unwrap();
        let found = tilted.acceleration(0.0, &state, &());
        let loads = tilted.reactions(0.0, &state, &());
        let left = tilted.residual(0.0, &state, &found, &loads, &());
        for part in [left.fork, left.disc] {
            close("force", part.force.as_slice(), &[0.0; 3], 30.0, 1e-12);
            close("moment", part.moment.as_slice(), &[0.0; 3], 30.0, 1e-12);
        }
        let moved = |time: f64| {
            let middle = state.moved(&(state.rate(&found) * (0.5 * time)));
            state.moved(&(middle.rate(&found) * time))
        };
        let worst = |time: f64| {
            let violations = tilted.violations(0.0, &moved(time), &());
            violations
                .iter()
                .map(|one| one.velocity.abs())
                .fold(0.0, f64::max)
        };
        // rates are off by the square of the time, were accelerations right
        assert!(worst(1e-4) < 0.015 * worst(1e-3) + 1e-11);
    }
    let turntable = rolling::Turntable::default();
    let mut start = rolling::TurntableState {
        away: Spatial {
            position: [0.3, 0.1, 0.05].into(),
            velocity: [0.2, -0.1, 0.0].into(),
            ..Spatial::default()
        },
    };
    turntable.project(0.0, &mut start, &()).unwrap();
    // a circle in 7/2 turns of the table
    let period = core::f64::consts::TAU * 3.5 / 2.0;
    let end = turntable
        .integrate(&start)
        .tolerance(1e-12)
        .to(period)
        .unwrap();
    close(
        "position",
        end.away.position.as_slice(),
        start.away.position.as_slice(),
        1.0,
        1e-9,
    );
    close(
        "velocity",
        end.away.velocity.as_slice(),
        start.away.velocity.as_slice(),
        1.0,
        1e-9,
    );
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

/// A plane four-bar in space stands on a foot, which carries what it weighs, whatever the hinges hold.
mod held {
    use newton_euler::prelude::*;

    rigid_system!(Standing {
        bodies: [
            base {
                mass: 2[kg],
                inertia: principal(1, 1, 1)[kg * m ^ 2],
                points: [side = (1, 0, 0)[m]],
            },
            crank {
                mass: 1[kg],
                inertia: principal(0.1, 0.2, 0.3)[kg * m ^ 2],
                points: [o = (0, 0, 0)[m], a = (0.3, 0.4, 0)[m]],
            },
            coupler {
                mass: 1.5[kg],
                inertia: principal(0.1, 0.2, 0.3)[kg * m ^ 2],
                points: [a = (0, 0, 0)[m], b = (0.6, 0.8, 0)[m]],
            },
            rocker {
                mass: 0.5[kg],
                inertia: principal(0.1, 0.2, 0.3)[kg * m ^ 2],
                points: [b = (0, 0, 0)[m], c = (0.1, -1.2, 0)[m]],
            },
        ],
        joints: [
            foot = weld(world(0, 0, 0), base.G),
            o = revolute(base.G, crank.o, body(0, 0, 1)),
            a = revolute(crank.a, coupler.a, body(0, 0, 1)),
            b = revolute(coupler.b, rocker.b, body(0, 0, 1)),
            c = revolute(base.side, rocker.c, body(0, 0, 1)),
        ],
        fields: [weight = mass * world(0, 0, -9.8[m / s ^ 2])],
        outputs: [reactions(foot)],
    });

    // statics: two bodies that three hinges hold, by the same joints
    rigid_system!(Arch {
        motion: planar,
        bodies: [
            left {
                mass: 1[kg],
                inertia: 1[kg * m ^ 2],
                points: [a = (0, 0)[m], c = (4, 3)[m], load = (1.5, 2)[m]],
                forces: [wind = world(6[N], -20[N]).at(load)],
            },
            right {
                mass: 1[kg],
                inertia: 1[kg * m ^ 2],
                points: [b = (2, -3)[m], c = (-2, 0)[m], load = (0, -0.8)[m]],
                forces: [snow = world(0, -30[N]).at(load)],
                moments: [couple = 5[N * m]],
            },
        ],
        joints: [
            a = revolute(world(0, 0), left.a),
            c = revolute(left.c, right.c),
            b = revolute(world(8, 0), right.b),
        ],
        outputs: [reactions],
    });
}

#[test]
fn what_is_held_too_much_gives_what_is_determined() {
    let standing = held::Standing::default();
    let mut state = held::StandingState::default();
    standing.project(0.0, &mut state, &()).unwrap();
    let foot = standing.reactions(0.0, &state, &()).foot;
    close(
        "foot",
        foot.force.as_slice(),
        &[0.0, 0.0, 5.0 * 9.8],
        10.0,
        1e-13,
    );
    let found = standing.acceleration(0.0, &state, &());
    assert!(
        [found.o, found.a, found.b]
            .iter()
            .all(|one| one.abs() < 1e-12)
    );
}

// reference/systems/three_hinged_arch.json: six balances, exact rationals
#[test]
fn an_arch_on_three_hinges() {
    let (arch, state) = (held::Arch::default(), held::ArchState::default());
    arch.check(0.0, &state, &()).unwrap();
    let found = arch.acceleration(0.0, &state, &());
    assert!(found.a.abs().max(found.c.abs()) < 1e-13);
    let loads = arch.reactions(0.0, &state, &());
    close(
        "a",
        loads.a.force.as_slice(),
        &[11.833_333_333_333_334, 22.875],
        10.0,
        1e-14,
    );
    close(
        "b",
        loads.b.force.as_slice(),
        &[-17.833_333_333_333_332, 27.125],
        10.0,
        1e-14,
    );
    close(
        "c",
        loads.c.force.as_slice(),
        &[17.833_333_333_333_332, 2.875],
        10.0,
        1e-14,
    );
}
