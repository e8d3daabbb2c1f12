//! Constraints that jump, or whose rates do: the equations do not describe the shock.

use newton_euler::integrate::{Classical4, Fixed, IntegrationError, Projected};
use newton_euler::prelude::*;

// a bead in a groove with a corner
rigid_body!(Groove {
    motion: planar_translation,
    mass: 1[kg],
    fields: [weight = mass * world(0, -9.81[m / s ^ 2])],
    constraints: [groove = position.in_world().y - position.in_world().x.abs()],
    reactions: [normal = _ * groove.gradient()],
});

#[test]
fn a_corner_ends_the_motion() {
    let start = PlanarTranslation {
        position: [0.5, 0.5].into(),
        ..PlanarTranslation::default()
    };
    let found = Groove::default().integrate(&start).to(1.0);
    let Err(IntegrationError::Jump {
        time,
        state,
        violated,
    }) = found
    else {
        panic!("{found:?}");
    };
    // down a slope of 45 degrees: x = 1/2 - g t^2 / 4
    assert!((time - (2.0_f64 / 9.81).sqrt()).abs() < 1e-6, "{time}");
    assert!(state.position.x >= 0.0 && violated.constraint == "groove");
}

// one arm on a free hub, the angle between them given
macro_rules! led {
    ($name:ident, $($angle:tt)+) => {
        rigid_system!($name {
            motion: planar,
            params: [rate = 2[rad / s], lead = 0.1[rad]],
            bodies: [
                hub {
                    mass: 2[kg],
                    inertia: 0.3[kg * m ^ 2]
                },
                arm {
                    mass: 1[kg],
                    inertia: 0.1[kg * m ^ 2],
                    points: [end = (-0.5, 0)]
                },
            ],
            joints: [flight = free(hub), hinge = revolute(hub.G, arm.end)],
            constraints: [led = hinge.angle - ($($angle)+)],
            outputs: [momentum],
        });
    };
}

led!(Kinked, rate * (t - 1[s]).max(0[s]) + 0 * lead);
led!(
    Curved,
    rate * (t - 1[s]).max(0[s]).powi(2) / 1[s] + 0 * lead
);
led!(Switched, if t > 1[s] { lead } else { 0 * rate * t });

#[test]
fn a_kink_or_a_jump_in_time_ends_the_motion_there() {
    let found = Kinked::default().integrate(&KinkedState::default()).to(2.0);
    let Err(IntegrationError::Jump { time, violated, .. }) = found else {
        panic!("{found:?}");
    };
    assert!((time - 1.0).abs() < 1e-15 && violated.is_velocity);
    assert!((violated.violation.abs() - 2.0).abs() < 1e-12);
    let found = Switched::default()
        .integrate(&SwitchedState::default())
        .to(2.0);
    let Err(IntegrationError::Jump { time, violated, .. }) = found else {
        panic!("{found:?}");
    };
    assert!((time - 1.0).abs() < 1e-15 && !violated.is_velocity);
    let method = Projected(Fixed {
        method: Classical4,
        step: 0.1,
    });
    let body = Kinked::default();
    let found = body
        .integrate(&KinkedState::default())
        .method(method)
        .to(2.0);
    assert!(
        matches!(found, Err(IntegrationError::Jump { time, .. }) if (time - 1.0).abs() < 1e-15)
    );
}

#[test]
fn a_bend_keeps_momentum() {
    let body = Curved::default();
    let end = body
        .integrate(&CurvedState::default())
        .to(2.0)
        .expect("an end");
    assert!((end.hinge.angle - 2.0).abs() < 1e-12);
    assert!((end.hinge.angular_velocity - 4.0).abs() < 1e-12);
    let momentum = body.linear_momentum(&end);
    assert!(momentum.norm() < 1e-9, "{momentum}");
    assert!(body.angular_momentum(&end).abs() < 1e-9);
}

rigid_system!(Step {
    motion: planar,
    bodies: [block {
        mass: 2[kg],
        inertia: 0.3[kg * m ^ 2]
    }],
    joints: [flight = free(block)],
    constraints: [floor = flight.position.in_world().y
        - if flight.position.in_world().x > 1[m] {
            0.05[m]
        } else {
            0[m]
        }],
});

#[test]
fn a_step_in_the_floor_ends_the_motion() {
    let start = StepState {
        flight: Planar {
            velocity: [1.0, 0.0].into(),
            ..Planar::default()
        },
    };
    let found = Step::default().integrate(&start).to(2.0);
    let Err(error @ IntegrationError::Jump { .. }) = found else {
        panic!("{found:?}");
    };
    assert!(error.time() <= 1.0 && error.state().flight.position.x <= 1.0);
    assert!(
        error
            .to_string()
            .contains("`floor` jumps, or its rate does")
    );
}

// almost at its dead points, the rates of a crank and its rod are large
rigid_system!(Crank {
    motion: planar,
    bodies: [
        crank {
            mass: 1[kg],
            inertia: 0.01[kg * m ^ 2],
            points: [o = (-0.1, 0), a = (0.1, 0)]
        },
        rod {
            mass: 0.5[kg],
            inertia: 0.01[kg * m ^ 2],
            points: [a = (-0.1005, 0), b = (0.1005, 0)]
        },
        block {
            mass: 1[kg],
            inertia: 0.01[kg * m ^ 2]
        },
    ],
    joints: [
        o = revolute(world(0, 0), crank.o),
        a = revolute(crank.a, rod.a),
        b = revolute(rod.b, block.G),
        s = prismatic(world(0, 0), block.G, world(1, 0)),
    ],
    fields: [weight = mass * world(0, -9.81[m / s ^ 2])],
});

#[test]
fn coarse_steps_are_no_jumps() {
    for tolerance in [0.3, 0.1, 0.03, 1e-2, 3e-3, 1e-6, 1e-10] {
        for speed in [0.0, 5.0, 60.0] {
            let body = Crank::default();
            let mut start = CrankState::default();
            (start.o.angle, start.a.angle, start.b.angle) = (0.7, -1.4, 0.7);
            start.o.angular_velocity = speed;
            body.project(0.0, &mut start, &()).expect("near by");
            let end = body.integrate(&start).tolerance(tolerance).to(3.0);
            assert!(end.is_ok(), "{tolerance}, {speed}: {end:?}");
        }
    }
}
