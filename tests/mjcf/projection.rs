//! Projection from far: an arm of seven hinges whose hand is held, with a load welded to its elbow.
//! The light links at the end would move too far in steps of full length.

use nalgebra::{UnitQuaternion, Vector3};
use newton_euler::prelude::*;
use newton_euler::state::Coordinates;

rigid_system!(Held {
    mjcf: "tests/mjcf/held.xml",
});

/// The pose of the file.
fn drawn() -> HeldState {
    let turned = |axis, degrees: f64| UnitQuaternion::from_axis_angle(&axis, degrees.to_radians());
    let attitude = turned(Vector3::x_axis(), 20.0)
        * turned(Vector3::y_axis(), 30.0)
        * turned(Vector3::z_axis(), 40.0);
    let mut state = HeldState::default();
    state.aj2.angle = 20_f64.to_radians();
    state.fj.attitude = attitude;
    state.fj.position = Vector3::new(0.4, 0.3, 1.0) + attitude * Vector3::new(0.1, 0.0, 0.1);
    state
}

#[test]
fn states_far_from_the_constraints() {
    let (body, mut seed) = (Held::default(), 5_u64);
    let mut random = || {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        f64::from(u32::try_from(seed >> 33).expect("31 bits")) / f64::from(1 << 30) - 1.0
    };
    assert!(body.check(0.0, &drawn(), &()).is_ok());
    for size in [0.03, 0.1, 0.2] {
        for _ in 0..50 {
            let mut coordinates = drawn().coordinates();
            for angle in &mut coordinates.as_mut()[..7] {
                *angle += size * random();
            }
            let mut state = HeldState::from_coordinates(&coordinates);
            let projected = body.project(0.0, &mut state, &());
            assert!(projected.is_ok(), "{size}: {projected:?}");
            assert!(body.check(0.0, &state, &()).is_ok());
        }
    }
}
