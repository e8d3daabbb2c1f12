//! The claims about bodies with user-defined states: nothing more than what holds.

use newton_euler::prelude::*;
use newton_euler::structure::{Structure, Structured};

use crate::bodies::{Drone, Rocket};

rigid_body!(Top {
    doc: "A symmetric top in free fall; how it spins is counted in axes of its own.",
    motion: rotation,
    states: [turns[rad], swing[rad]],
    rates: [
        turns = angular_velocity.in_body().z,
        swing = angular_velocity.in_body().x
    ],
    inertia: principal(2, 2, 3)[kg * m ^ 2],
    outputs: [taylor],
});

#[test]
fn claims() {
    let of = |structure: Structure| [structure.linear.states, structure.angular.states];
    assert_eq!(of(Rocket::STRUCTURE), [true, false]);
    assert!(!Rocket::STRUCTURE.linear.is_constant());
    assert_eq!(of(Drone::<f64>::STRUCTURE), [true, true]);
    assert_eq!(of(Top::STRUCTURE), [false, false]);
    const { assert!(Top::STRUCTURE.is_torque_free) };
}

/// The series of a symmetric body are in axes that do not spin; with rates that are written in its
/// own, they are in these.
#[test]
fn series_in_axes_of_the_body() {
    let start = TopState {
        motion: Rotation {
            angular_velocity: [0.3, 0.0, 5.0].into(),
            ..Rotation::default()
        },
        ..TopState::default()
    };
    let end = Top::default()
        .integrate(&start)
        .tolerance(1e-14)
        .to(3.0)
        .unwrap();
    assert!((end.turns - 15.0).abs() < 1e-12);
    // w_x = 0.3 cos(p t), p = (J_3 - J_1) / J_1 w_z
    let pace = 2.5;
    assert!((end.swing - 0.3 * (pace * 3.0_f64).sin() / pace).abs() < 1e-12);
}
