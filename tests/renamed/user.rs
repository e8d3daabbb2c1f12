//! A user's crate that knows the library under another name, and through a third crate.
#![deny(warnings, missing_docs)]
#![forbid(unsafe_code)]

use dynamics::prelude::*;

/// Through the renamed dependency.
pub mod direct {
    dynamics::rigid_body!(Ball {
        motion: translation,
        params: [m = 0.5[kg]],
        mass: m,
        fields: [weight = mass * world(0, 0, -9.8[m / s ^ 2])],
        outputs: [energy, momentum, balance],
    });
}

/// Through what another crate re-exports.
pub mod passed_on {
    facade::mechanics::rigid_body!(Plate {
        motion: planar,
        inputs: [push[N]],
        mass: 2[kg],
        inertia: 0.5[kg * m ^ 2],
        forces: [pushed = body(0, push).at((0.25, 0))],
        outputs: [energy, momentum, balance],
    });

    facade::deeper::body!(Stone {
        motion: spatial,
        mass: 2[kg],
        inertia: principal(1, 2, 3),
        outputs: [balance],
    });
}

#[test]
fn a_users_crate_may_call_the_library_as_it_likes() {
    let ball = direct::Ball::default();
    let falling = ball.acceleration(0.0, &Translation::default(), &());
    let plate = passed_on::Plate {};
    let input = passed_on::PlateInput { push: 3.0 };
    let pushed = plate.acceleration(0.0, &Planar::default(), &input);
    let stone = passed_on::Stone {};
    let residual = stone.applied(0.0, &Spatial::default(), &());
    // -g; 3 N on 2 kg; 3 N at 0.25 m on 0.5 kg m²; nothing
    let found = [
        falling.z,
        pushed.linear.y,
        pushed.angular,
        residual.force.norm(),
    ];
    assert_eq!(found, [-9.8, 1.5, 1.5, 0.0]);
}
