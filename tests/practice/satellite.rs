//! A satellite with three wheels and magnetorquers: the wheels hold its attitude, and the
//! magnetorquers remove the momentum that the wheels have gathered.

use newton_euler::nalgebra::{UnitQuaternion, Vector3};
use newton_euler::prelude::*;

rigid_body!(Satellite {
    doc: "A satellite that three wheels turn to the axes of the world, while magnetorquers unload them.",
    motion: rotation,
    params: [field = world(2e-5, 1e-5, -4e-5)[T], unloading = 0.02[1 / s]],
    inertia: principal(12, 14, 9)[kg * m ^ 2],
    states: [h_x[N * m * s], h_y[N * m * s], h_z[N * m * s]],
    locals: [
        w = angular_velocity.in_body(),
        wheels = body(h_x, h_y, h_z),
        turn = if attitude.w < 0 { -1 } else { 1 },
        off = 2 * turn * body(attitude.i, attitude.j, attitude.k),
        motors = 0.5[N * m] * off + 3[N * m * s] * angular_velocity,
        motor = motors.in_body(),
        whole = body(
            12[kg * m ^ 2] * w.x,
            14[kg * m ^ 2] * w.y,
            9[kg * m ^ 2] * w.z
        ) + wheels,
        dipole = -unloading / field.norm_squared() * field.cross(whole),
    ],
    rates: [h_x = motor.x, h_y = motor.y, h_z = motor.z],
    moments: [
        wheels_push = -motors - angular_velocity.cross(wheels),
        magnetorquers = dipole.cross(field),
    ],
    outputs: [momentum],
});

/// Of hub and wheels, world axes.
fn whole(state: &SatelliteState) -> Vector3<f64> {
    let Rotation {
        attitude,
        angular_velocity,
    } = state.motion;
    let hub = Vector3::new(12.0, 14.0, 9.0).component_mul(&angular_velocity);
    attitude * (hub + Vector3::new(state.h_x, state.h_y, state.h_z))
}

/// A moment `m x B` with `m = -k B x H / B^2` is `-k` times the part of H across B: that part decays as
/// `exp(-k t)`, whatever the attitude and the wheels do, and the part along B stays.
#[test]
fn unloads_across_the_field_alone() {
    let satellite = Satellite::default();
    let start = SatelliteState {
        motion: Rotation {
            attitude: UnitQuaternion::from_euler_angles(0.8, -0.5, 1.9),
            angular_velocity: [0.01, -0.03, 0.02].into(),
        },
        h_x: 1.2,
        h_y: -0.7,
        h_z: 2.1,
    };
    let along = Vector3::new(2.0, 1.0, -4.0).normalize();
    let before = whole(&start);
    let kept = along * along.dot(&before);
    for time in [10.0, 60.0, 200.0] {
        let end = satellite.integrate(&start).tolerance(1e-12).to(time);
        let found = whole(&end.expect("it is smooth where it goes"));
        let known = kept + (before - kept) * f64::exp(-0.02 * time);
        assert!((found - known).norm() < 1e-10, "{time}: {found} {known}");
    }
    let end = satellite.integrate(&start).to(600.0);
    let end = end.expect("it is smooth where it goes");
    // what is left in the wheels is along the field, and the satellite is upright
    assert!(end.motion.attitude.angle() < 1e-3, "{end:?}");
    let wheels = Vector3::new(end.h_x, end.h_y, end.h_z);
    assert!((wheels - kept).norm() < 1e-2, "{wheels} {kept}");
}

/// What the body itself calls its angular momentum is that of the hub.
#[test]
fn momentum_is_that_of_the_hub() {
    let state = SatelliteState {
        motion: Rotation {
            attitude: UnitQuaternion::from_euler_angles(0.8, -0.5, 1.9),
            angular_velocity: [0.01, -0.03, 0.02].into(),
        },
        ..SatelliteState::default()
    };
    let told = Satellite::default().angular_momentum(&state);
    assert!((told - whole(&state)).norm() < 1e-15);
}
