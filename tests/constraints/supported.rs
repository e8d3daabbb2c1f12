//! Constraints together with a support: the same scenes with the support as a constraint, and known
//! motions.

use nalgebra::{UnitQuaternion, Vector3};
use newton_euler::prelude::*;

// a door on a hinge that leans, with a rope from its corner to a post, and what the hinge carries
rigid_body!(Door {
    motion: fixed_axis(hinge, world(0.36, 0.48, 0.8)).at(world(1, -2, 0.5)),
    mass: 3.1[kg],
    inertia: tensor {
        xx: 0.5,
        yy: 0.7,
        zz: 0.4,
        xy: 0.03,
        yz: -0.05,
        zx: 0.02
    }[kg * m ^ 2],
    points: [
        hinge = (0.4, -0.1, 0.2),
        corner = (-0.5, 0.3, 0.6),
        post = world(2.5, 1, 1)
    ],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    moments: [damping = -0.2[N * m * s] * angular_velocity],
    constraints: [rope = (corner.position() - post.position()).norm() - (3[m] + 0.2[m / s] * t)],
    reactions: [
        pull = (_ * (corner.position() - post.position()).normalize()).at(corner),
        bearing = world(_, _, _).at(hinge),
        couple = moment(body(0, _, _)),
    ],
    outputs: [reactions],
});

// the same door, which nothing but constraints holds: a point, and two directions across the axis
rigid_body!(LooseDoor {
    motion: spatial,
    mass: 3.1[kg],
    inertia: tensor {
        xx: 0.5,
        yy: 0.7,
        zz: 0.4,
        xy: 0.03,
        yz: -0.05,
        zx: 0.02
    }[kg * m ^ 2],
    points: [
        hinge = (0.4, -0.1, 0.2),
        corner = (-0.5, 0.3, 0.6),
        post = world(2.5, 1, 1)
    ],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    moments: [damping = -0.2[N * m * s] * angular_velocity],
    constraints: [
        held = hinge.position() - world(1, -2, 0.5),
        upright = body(0.36, 0.48, 0.8).dot(world(0.8, -0.6, 0)),
        straight = body(0.36, 0.48, 0.8).dot(world(0.48, 0.64, -0.6)),
        rope = (corner.position() - post.position()).norm() - (3[m] + 0.2[m / s] * t),
    ],
    reactions: [
        pull = (_ * (corner.position() - post.position()).normalize()).at(corner),
        bearing = world(_, _, _).at(hinge),
        couple = moment(body(0, _, _)),
    ],
    outputs: [reactions],
});

/// A state on the rope, at a time, from an angle nearby: by bisection.
fn on_the_rope(door: &Door, time: f64, from: f64) -> Option<Hinge> {
    let off = |angle: f64, angular_velocity: f64| {
        let state = Hinge {
            angle,
            angular_velocity,
        };
        let violation = door.violations(time, &state, &())[0];
        (violation.position.unwrap(), violation.velocity)
    };
    let (mut low, mut high) = (from, from + 1.0);
    if off(low, 0.0).0 * off(high, 0.0).0 > 0.0 {
        return None;
    }
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if off(middle, 0.0).0 * off(low, 0.0).0 > 0.0 {
            low = middle;
        } else {
            high = middle;
        }
    }
    // the rate is linear in the velocity
    let (at_rest, moving) = (off(low, 0.0).1, off(low, 1.0).1);
    Some(Hinge {
        angle: low,
        angular_velocity: -at_rest / (moving - at_rest),
    })
}

#[test]
fn a_hinge_is_a_support_and_constraints() {
    let (door, loose) = (Door::default(), LooseDoor::default());
    let axis = Vector3::new(0.36, 0.48, 0.8);
    let mut tried = 0;
    for step in 0..40 {
        let time = 0.1 * f64::from(step);
        let Some(state) = on_the_rope(&door, time, 0.3 * f64::from(step)) else {
            continue;
        };
        tried += 1;
        let attitude = UnitQuaternion::from_scaled_axis(axis * state.angle);
        let turning = axis * state.angular_velocity;
        let arm = attitude * Vector3::new(-0.4, 0.1, -0.2);
        let whole = Spatial {
            position: Vector3::new(1.0, -2.0, 0.5) + arm,
            attitude,
            velocity: turning.cross(&arm),
            angular_velocity: turning,
        };
        for violation in loose.violations(time, &whole, &()) {
            let position = violation.position.unwrap_or(0.0);
            assert!(
                position.abs().max(violation.velocity.abs()) < 1e-12,
                "{violation:?}"
            );
        }
        let expected = loose.acceleration(time, &whole, &());
        let found = door.acceleration(time, &state, &());
        let scale = 1.0 + expected.angular.norm();
        assert!(
            (axis * found - expected.angular).norm() < 1e-11 * scale,
            "{found} for {:?}",
            expected.angular
        );
        let by_hinge = door.reactions(time, &state, &()).unwrap();
        let by_constraints = loose.reactions(time, &whole, &()).unwrap();
        let size = 30.0 + by_constraints.bearing.norm();
        for (one, other) in [
            (by_hinge.pull, by_constraints.pull),
            (by_hinge.bearing, by_constraints.bearing),
            (by_hinge.couple, by_constraints.couple),
        ] {
            assert!((one - other).norm() < 1e-10 * size, "{one} for {other}");
        }
    }
    assert!(tried > 5, "{tried}");
}

// a crank that a motor turns at a steady pace, and what its bearing carries
rigid_body!(Crank {
    motion: pivot(shaft),
    mass: 1.5[kg],
    inertia: 0.02[kg * m ^ 2],
    points: [shaft = (-0.3[m], 0.1[m])],
    fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
    constraints: [pace = angular_velocity - 3],
    reactions: [motor = moment(_), bearing = world(_, _).at(shaft)],
    outputs: [reactions, taylor],
});

#[test]
fn a_crank_at_a_steady_pace() {
    let crank = Crank::default();
    for angle in [-2.0, 0.0, 0.7, 3.0] {
        let state = Hinge {
            angle,
            angular_velocity: 3.0,
        };
        assert!(crank.acceleration(0.0, &state, &()).abs() < 1e-13);
        let found = crank.reactions(0.0, &state, &()).unwrap();
        let (sine, cosine) = f64::sin_cos(angle);
        // from the shaft to G
        let (x, y) = (0.3 * cosine + 0.1 * sine, 0.3 * sine - 0.1 * cosine);
        let weight = 1.5 * 9.80665;
        assert!((found.motor - weight * x).abs() < 1e-13);
        let expected = [-1.5 * 9.0 * x, -1.5 * 9.0 * y + weight];
        assert!((found.bearing - nalgebra::Vector2::from(expected)).norm() < 1e-12);
    }
    let start = Hinge {
        angle: 0.4,
        angular_velocity: 3.0,
    };
    let end = crank.integrate(&start).to(2.0).unwrap();
    assert!((end.angle - 6.4).abs() < 1e-12 && (end.angular_velocity - 3.0).abs() < 1e-14);
}

// a top whose axis is kept at one height by a guide at its tip, which also drags: the support a motion, and a constraint
rigid_body!(GuidedTop {
    motion: fixed_point(foot),
    mass: 0.9[kg],
    inertia: tensor {
        xx: 0.05,
        yy: 0.06,
        zz: 0.02,
        xy: 0.002,
        yz: 0.001,
        zx: -0.003
    }[kg * m ^ 2],
    points: [foot = (0.02, 0.01, -0.2), tip = (0, 0, 0.25)],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    constraints: [height = tip.position().in_world().z - 0.31[m]],
    reactions: [
        guide = world(0, 0, _).at(tip),
        ground = world(_, _, _).at(foot)
    ],
    forces: [friction = (-0.1 * guide.in_world().z * world(0, 1, 0)).at(tip)],
    outputs: [reactions, taylor],
});

rigid_body!(LooseTop {
    motion: spatial,
    mass: 0.9[kg],
    inertia: tensor {
        xx: 0.05,
        yy: 0.06,
        zz: 0.02,
        xy: 0.002,
        yz: 0.001,
        zx: -0.003
    }[kg * m ^ 2],
    points: [foot = (0.02, 0.01, -0.2), tip = (0, 0, 0.25)],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    constraints: [
        held = foot.position(),
        height = tip.position().in_world().z - 0.31[m]
    ],
    reactions: [
        guide = world(0, 0, _).at(tip),
        ground = world(_, _, _).at(foot)
    ],
    forces: [friction = (-0.1 * guide.in_world().z * world(0, 1, 0)).at(tip)],
    outputs: [reactions, taylor],
});

#[test]
fn a_fixed_point_is_a_support_and_constraints() {
    let (top, loose) = (GuidedTop::default(), LooseTop::default());
    for step in 0..12 {
        let turn = Vector3::new(0.6, 0.2 * f64::from(step), 0.3);
        let mut state = Rotation {
            attitude: UnitQuaternion::from_scaled_axis(turn),
            angular_velocity: [1.0, -0.7, 5.0 + f64::from(step)].into(),
        };
        if top.project(0.0, &mut state, &()).is_err() {
            continue;
        }
        let whole = |state: &Rotation| {
            let arm = state.attitude * Vector3::new(-0.02, -0.01, 0.2);
            Spatial {
                position: arm,
                attitude: state.attitude,
                velocity: (state.attitude * state.angular_velocity).cross(&arm),
                angular_velocity: state.angular_velocity,
            }
        };
        let expected = loose.acceleration(0.0, &whole(&state), &()).angular;
        let found = top.acceleration(0.0, &state, &());
        assert!((found - expected).norm() < 1e-11 * (1.0 + expected.norm()));
        let by_support = top.reactions(0.0, &state, &()).unwrap();
        let by_constraints = loose.reactions(0.0, &whole(&state), &()).unwrap();
        for (one, other) in [
            (by_support.guide, by_constraints.guide),
            (by_support.ground, by_constraints.ground),
        ] {
            assert!((one - other).norm() < 1e-10 * (10.0 + other.norm()));
        }
        // series, and each step on the constraints
        let end = top.integrate(&state).tolerance(1e-11).to(0.5).unwrap();
        let other = loose
            .integrate(&whole(&state))
            .tolerance(1e-11)
            .to(0.5)
            .unwrap();
        assert!(end.attitude.angle_to(&other.attitude) < 1e-8);
        assert!((end.attitude * Vector3::new(-0.02, -0.01, 0.45)).z - 0.31 < 1e-14);
    }
}

// a wheel on a pin that turns at a set pace; its bearing rubs by both components of what it carries, or drags
// all of it at another point: on a pivot, and with constraints for it
macro_rules! rubbing {
    ($($name:ident { $motion:ident $(($pin:ident))?, [$($held:tt)*], [$($rub:tt)*] })*) => {$(
        rigid_body!($name {
            motion: $motion $(($pin))?,
            mass: 2[kg],
            inertia: 0.3[kg * m ^ 2],
            fields: [weight = mass * world(0, -9.8)],
            constraints: [$($held)* pace = angular_velocity - 1 - 0.3 * (2[1 / s] * t).sin()],
            reactions: [motor = moment(_), bearing = world(_, _).at(pin)],
            $($rub)*
            outputs: [reactions],
        });
    )*};
}

rubbing! {
    Rubbing { pivot(pin), [], [points: [pin = (0.4, 0.1)], joint_moments: [rub = -0.1 * (bearing.in_world().x + 2 * bearing.in_world().y)],] }
    LooseRubbing { planar, [held = pin.position(),], [points: [pin = (0.4, 0.1)], joint_moments: [rub = -0.1 * (bearing.in_world().x + 2 * bearing.in_world().y)],] }
    Dragging { pivot(pin), [], [points: [pin = (0.4, 0.1), far = (1, 0.2)], joint_forces: [rub = (-0.1 * bearing).at(far)],] }
    LooseDragging { planar, [held = pin.position(),], [points: [pin = (0.4, 0.1), far = (1, 0.2)], joint_forces: [rub = (-0.1 * bearing).at(far)],] }
}

#[test]
fn friction_follows_all_that_a_support_carries() {
    for (angle, time) in [(0.3_f64, 0.0_f64), (1.7, 0.4), (-2.2, 1.3)] {
        let angular_velocity = 1.0 + 0.3 * f64::sin(2.0 * time);
        let held = Hinge {
            angle,
            angular_velocity,
        };
        let mut loose = Planar {
            angle,
            angular_velocity,
            ..Planar::default()
        };
        LooseRubbing::default()
            .project(time, &mut loose, &())
            .unwrap();
        let one = Rubbing::default().reactions(time, &held, &()).unwrap();
        let other = LooseRubbing::default()
            .reactions(time, &loose, &())
            .unwrap();
        assert!((one.bearing - other.bearing).norm() < 1e-12);
        assert!((one.motor - other.motor).abs() < 1e-12);
        let one = Dragging::default().reactions(time, &held, &()).unwrap();
        let other = LooseDragging::default()
            .reactions(time, &loose, &())
            .unwrap();
        assert!((one.bearing - other.bearing).norm() < 1e-12);
        assert!((one.motor - other.motor).abs() < 1e-12);
    }
}
