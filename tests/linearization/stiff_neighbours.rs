//! Slow modes of a linkage beside a stiff body that has nothing to do with it.

use newton_euler::prelude::*;

// a parallelogram that stands on its cranks, and a body on a stiff hinge
rigid_system!(Standing {
    motion: planar,
    params: [stiffness = 1[N * m / rad], gravity = 9.81[m / s ^ 2]],
    bodies: [
        left {
            mass: 1[kg],
            inertia: 0.1[kg * m ^ 2],
            points: [foot = (0, -0.5), top = (0, 0.5)]
        },
        coupler {
            mass: 1[kg],
            inertia: 0.1[kg * m ^ 2],
            points: [a = (-0.5, 0), b = (0.5, 0)]
        },
        right {
            mass: 1[kg],
            inertia: 0.1[kg * m ^ 2],
            points: [foot = (0, -0.5), top = (0, 0.5)]
        },
        beside {
            mass: 1e-3[kg],
            inertia: 1e-3[kg * m ^ 2],
            points: [pin = (0, 0)]
        },
    ],
    joints: [
        left_foot = revolute(world(0, 0), left.foot),
        left_top = revolute(left.top, coupler.a),
        right_foot = revolute(world(1, 0), right.foot),
        right_top = revolute(coupler.b, right.top),
        pin = revolute(world(5, 0), beside.pin),
    ],
    drives: [spring = (-stiffness * pin.angle).on(pin)],
    fields: [weight = mass * world(0, -gravity)],
    outputs: [linearization],
});

/// By hand: the cranks have 2 (0.1 + 0.25) kg m^2 about their feet, the coupler 1 kg at 1 m, and the
/// weights (2 * 0.5 + 1) m g. In another unit of time, gravity and stiffness have other numbers.
#[test]
fn a_linkage_that_falls_is_not_stable_beside_a_stiff_body() {
    for unit in [1e-4, 1.0, 1e4_f64] {
        for stiff in [1.0, 1e4, 6e8, 8e8, 1e10, 1e12, 1e16, 1e30] {
            let squared = unit.powi(2);
            let [stiffness, gravity] = [stiff, 9.81].map(|rate| rate * squared);
            let params = StandingParams { stiffness, gravity };
            let system = Standing::new(params).expect("parameters that are possible");
            let steady = system.trim(&StandingState::default()).solve();
            let modes = steady.expect("it stands").modes().expect("finite slopes");
            assert!(!modes.is_stable(), "{unit} {stiff}: {modes:?}");
            let swing = unit * (stiff / 1e-3).sqrt();
            let fall = unit * (2.0 * 9.81 / 1.7_f64).sqrt();
            for (expected, im) in [(swing, true), (fall, false), (-fall, false)] {
                let is_there = modes.iter().any(|mode| {
                    let eigenvalue = mode.eigenvalue;
                    let found = if im { eigenvalue.im } else { eigenvalue.re };
                    (found / expected - 1.0).abs() < 1e-5
                });
                assert!(is_there, "{unit} {stiff}: {expected} in {modes:?}");
            }
        }
    }
}
