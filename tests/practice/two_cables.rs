//! A bar that hangs on two cables: a bifilar pendulum.

use newton_euler::nalgebra::Vector3;
use newton_euler::prelude::*;

rigid_system!(Bar {
    doc: "A bar on two parallel cables that only pull.",
    params: [half = 0.6[m], length = 2[m], stiffness = 30[kN / m]],
    bodies: [bar {
        mass: 8[kg],
        inertia: principal(0.02, 1.1, 1.1)[kg * m ^ 2],
        points: [left = (-half, 0, 0), right = (half, 0, 0)],
    }],
    joints: [
        hang = free(bar),
        cable_left = cable(world(-half, 0, 3[m]), bar.left, length, stiffness),
        cable_right = cable(world(half, 0, 3[m]), bar.right, length, stiffness),
    ],
    fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
    outputs: [energy, linearization],
});

const WEIGHT: f64 = 8.0 * 9.81;

fn hanging(height: f64) -> BarState {
    let mut state = BarState::default();
    state.hang.position.z = height;
    state
}

/// Each cable carries half; small motions are those of parallel springs under tension, by hand.
#[test]
fn hangs_and_swings_as_by_hand() {
    let bar = Bar::default();
    let search = bar.trim(&hanging(0.9)).free(["hang_position_z"]);
    let still = search.solve().expect("it hangs");
    let length = 2.0 + WEIGHT / 2.0 / 30e3;
    assert!((still.state.hang.position.z - (3.0 - length)).abs() < 1e-12);
    let modes = still.modes().expect("taut on both sides");
    // heave, pitch, turning about the vertical, and swinging to both sides
    let mut known = [
        2.0 * 30e3 / 8.0,
        2.0 * 30e3 * 0.36 / 1.1,
        WEIGHT * 0.36 / (length * 1.1),
        9.81 / length,
        9.81 / length,
    ];
    known.sort_by(f64::total_cmp);
    let swinging = modes.iter().filter(|mode| mode.period().is_some());
    let mut found: Vec<f64> = swinging
        .map(|mode| mode.natural_frequency().powi(2))
        .collect();
    found.sort_by(f64::total_cmp);
    assert_eq!(found.len(), 5, "{found:?}");
    for (found, known) in found.iter().zip(known) {
        assert!((found / known - 1.0).abs() < 1e-9, "{found} {known}");
    }
    // rolling about the line through both cables, nothing turns it back
    assert_eq!(modes.neutral(), 2);
}

/// Lifted at one end, it is held by the other cable alone; lifted at both, it falls.
#[test]
fn a_slack_cable_does_not_push() {
    let bar = Bar::default();
    let mut state = hanging(1.2);
    let falling = bar.acceleration(0.0, &state, &()).hang;
    assert_eq!(falling.linear, Vector3::new(0.0, 0.0, -9.81));
    assert_eq!(falling.angular, Vector3::zeros());
    // the right end, which body y turns down, is 2.05 m below its hook
    state.hang.position.z = 1.0;
    let turned = 0.05_f64.atan2(0.6);
    state.hang.attitude =
        newton_euler::nalgebra::UnitQuaternion::from_axis_angle(&Vector3::y_axis(), turned);
    let one = bar.acceleration(0.0, &state, &()).hang;
    let end = state.hang.position + 0.6 * Vector3::new(turned.cos(), 0.0, -turned.sin());
    let rope = Vector3::new(0.6, 0.0, 3.0) - end;
    let pull = 30e3 * (rope.norm() - 2.0) * rope.normalize();
    let known = pull / 8.0 - Vector3::new(0.0, 0.0, 9.81);
    assert!((one.linear - known).norm() < 1e-10, "{one:?} {known}");
    let moment = (end - state.hang.position).cross(&pull);
    assert!((one.angular.y - moment.y / 1.1).abs() < 1e-9);
}

/// It may swing, turn and go slack: energy stays.
#[test]
fn keeps_its_energy() {
    let bar = Bar::default();
    let mut start = hanging(1.1);
    start.hang.velocity = Vector3::new(0.3, 0.2, 0.0);
    start.hang.angular_velocity = Vector3::new(0.1, 0.4, 0.8);
    let energy =
        |state: &BarState| bar.kinetic_energy(state) + bar.potential_energy(0.0, state, &());
    let end = bar
        .integrate(&start)
        .tolerance(1e-11)
        .to(5.0)
        .expect("it ends");
    assert!((energy(&end) - energy(&start)).abs() < 1e-6);
}
