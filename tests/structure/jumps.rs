//! Expressions that have no slope and jump: they do not count as unchanged.

use newton_euler::prelude::*;
use newton_euler::structure::{Structured, Symmetry};

mod scenes {
    newton_euler::rigid_body!(Tangent {
        motion: translation,
        mass: 1[kg],
        locals: [y = position.in_world().y / 1[m]],
        forces: [f = 1[N] * (y.tan().atan() - y) * world(0, 1, 0)],
    });
    newton_euler::rigid_body!(Sign {
        motion: translation,
        mass: 1[kg],
        locals: [y = position.in_world().y],
        forces: [f = 1[N] * y / (y * y).sqrt() * world(0, 1, 0)],
    });
    newton_euler::rigid_body!(Angles {
        motion: rotation,
        inertia: principal(1, 1, 1)[kg * m ^ 2],
        locals: [y = angular_velocity.in_body().y / 1[rad / s]],
        moments: [f = ((1 / y).atan() + y.atan()) * body(0, 1[N * m], 0)],
    });
    newton_euler::rigid_body!(Turned {
        motion: rotation,
        inertia: principal(1, 1, 1)[kg * m ^ 2],
        locals: [y = angular_velocity.in_body().y / 1[rad / s]],
        moments: [f = (y.sin().atan2(y.cos()) - y) * body(0, 1[N * m], 0)],
    });
    // of these, what is divided by stays as it is
    newton_euler::rigid_body!(Central {
        motion: translation,
        mass: 1[kg],
        fields: [sun = -1[N * m ^ 2] * position / position.norm().powi(3)],
    });
}

#[test]
fn what_jumps_is_not_symmetric() {
    assert_ne!(scenes::Tangent::STRUCTURE.linear.world, Symmetry::Every);
    assert_ne!(scenes::Sign::STRUCTURE.linear.world, Symmetry::Every);
    assert_ne!(scenes::Angles::STRUCTURE.angular.body, Symmetry::Every);
    assert_ne!(scenes::Turned::STRUCTURE.angular.body, Symmetry::Every);
    assert_eq!(scenes::Central::STRUCTURE.linear.world, Symmetry::Every);
    // the states that say so
    let at = |y: f64| {
        scenes::Sign::default().acceleration(
            0.0,
            &Translation {
                position: [0.0, y, 0.0].into(),
                ..Translation::default()
            },
            &(),
        )
    };
    assert!((at(2.0) - at(-2.0)).norm() > 1.0);
}
