//! Rolling between bodies and in space, with points of contact that move in their bodies.

use newton_euler::prelude::*;

use super::compare::{Random, close};

/// Rolling in space: a disc alone as a body with reactions, and as a system; and on a turntable.
mod bodies {
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
    let (alone, discs) = (bodies::Disc::default(), bodies::Discs::default());
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
        let system = bodies::DiscsState { away: state };
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
}

#[test]
fn a_point_that_changes_in_its_body_is_held() {
    let mut numbers = Random::new(6);
    let tilted = bodies::Tilted::default();
    for _ in 0..20 {
        let mut vector = || nalgebra::Vector3::from_fn(|_, _| numbers.number());
        let away = Spatial {
            position: vector(),
            attitude: nalgebra::UnitQuaternion::from_scaled_axis(vector()),
            velocity: vector(),
            angular_velocity: vector(),
        };
        let mut state = bodies::TiltedState {
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
}

#[test]
fn a_ball_on_a_turntable_goes_round() {
    let turntable = bodies::Turntable::default();
    let mut start = bodies::TurntableState {
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

/// Points whose values have none, or other ones, where the axes of the body are those of the world.
mod upright {
    use newton_euler::prelude::*;

    rigid_body!(Alone {
        motion: spatial,
        mass: 2[kg],
        inertia: disc(0.3),
        locals: [
            axis = body(0, 0, 1),
            up = world(0, 0, 1),
            steepest = (up - up.dot(axis) * axis).normalize(),
        ],
        points: [
            contact = G - 0.3[m] * steepest,
            raised = G + body(0, 0, attitude.w * 1[m])
        ],
        forces: [
            push = world(0, 1[N], 2[N]).at(contact),
            pull = world(1[N], 0, 0).at(raised)
        ],
    });

    rigid_system!(Jointed {
        bodies: [disc {
            mass: 2[kg],
            inertia: disc(0.3),
            locals: [
                axis = body(0, 0, 1),
                up = world(0, 0, 1),
                steepest = (up - up.dot(axis) * axis).normalize(),
            ],
            points: [
                contact = G - 0.3[m] * steepest,
                raised = G + body(0, 0, attitude.w * 1[m])
            ],
            forces: [
                push = world(0, 1[N], 2[N]).at(contact),
                pull = world(1[N], 0, 0).at(raised)
            ],
        }],
        joints: [away = free(disc)],
    });

    rigid_body!(Cam {
        motion: planar,
        mass: 2[kg],
        inertia: sphere(0.3),
        points: [nose = G - 0.1[m] * attitude.sin() * world(0, 1)],
        forces: [push = world(1[N], 0).at(nose)],
    });

    rigid_system!(JointedCam {
        motion: planar,
        bodies: [cam {
            mass: 2[kg],
            inertia: sphere(0.3),
            points: [nose = G - 0.1[m] * attitude.sin() * world(0, 1)],
            forces: [push = world(1[N], 0).at(nose)],
        }],
        joints: [away = free(cam)],
    });
}

#[test]
fn points_that_a_body_standing_still_has_not() {
    let state = Spatial {
        attitude: newton_euler::attitude::exp(&[0.4, 0.3, -0.2].into()),
        angular_velocity: [0.3, -0.2, 0.7].into(),
        ..Spatial::default()
    };
    let alone = upright::Alone::default().acceleration(0.0, &state, &());
    let jointed = upright::JointedState { away: state };
    let jointed = upright::Jointed::default().acceleration(0.0, &jointed, &());
    assert!((alone.linear - jointed.away.linear).norm() < 1e-14);
    assert!((alone.angular - jointed.away.angular).norm() < 1e-13);

    let state = Planar {
        angle: 0.7,
        ..Planar::default()
    };
    let alone = upright::Cam::default().acceleration(0.0, &state, &());
    let jointed = upright::JointedCamState { away: state };
    let jointed = upright::JointedCam::default().acceleration(0.0, &jointed, &());
    assert!((alone.angular - jointed.away.angular).abs() < 1e-14);
    // the force is 0.1 m times the sine below G
    let inertia = 0.4 * 2.0 * 0.3 * 0.3;
    assert!((alone.angular - 0.1 * 0.7_f64.sin() / inertia).abs() < 1e-14);
}
