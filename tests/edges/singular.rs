//! States in which constraints do not determine their reactions: nothing panics, and integrations
//! report it.

use newton_euler::integrate::{Classical4, DormandPrince, Fixed, IntegrationError, Projected};
use newton_euler::prelude::*;

use crate::bounded;

rigid_body!(Toggle {
    doc: "Kept on a line by a force that turns with the body; upright it cannot.",
    motion: planar,
    mass: 2[kg],
    inertia: 0.3[kg * m ^ 2],
    fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
    constraints: [line = position.in_world().y],
    reactions: [push = body(0, _)],
    outputs: [reactions],
});

/// At 1 rad/s it is upright after a quarter of a turn, or never exactly.
fn turning(angle: f64) -> Planar {
    Planar {
        angle,
        angular_velocity: 1.0,
        ..Planar::default()
    }
}

#[test]
fn an_evaluation_is_not_a_number_and_reactions_say_which() {
    let upright = turning(std::f64::consts::FRAC_PI_2);
    let acceleration = Toggle::default().acceleration(0.0, &upright, &());
    assert!(acceleration.linear.x.is_nan() && acceleration.linear.y.is_nan());
    let singular = Toggle::default().reactions(0.0, &upright, &()).unwrap_err();
    assert_eq!(singular.unknown, "Toggle.push.y");
}

#[test]
fn a_motion_ends_before_it() {
    bounded("toggle", || {
        let (body, upright) = (Toggle::default(), turning(std::f64::consts::FRAC_PI_2));
        let error = body.integrate(&upright).to(1.0).unwrap_err();
        assert!(
            matches!(error, IntegrationError::NotFinite { time: 0.0, .. }),
            "{error}"
        );
        assert_eq!(*error.state(), upright);
        let equal = Projected(Fixed {
            method: Classical4,
            step: std::f64::consts::FRAC_PI_2 / 16.0,
        });
        let error = body
            .integrate(&turning(0.0))
            .method(equal)
            .to(std::f64::consts::PI)
            .unwrap_err();
        assert!((1.4..1.6).contains(&error.time()), "{error}");
        // the push grows beyond bounds before, and the steps become short
        let adaptive = Projected(DormandPrince { tolerance: 1e-9 });
        let error = body
            .integrate(&turning(0.0))
            .method(adaptive)
            .to(3.0)
            .unwrap_err();
        assert!((1.4..1.6).contains(&error.time()), "{error}");
        assert!(error.state().position.y.abs() < 1e-9);
    });
}
