//! Steady motions of what runs down meanwhile.

use newton_euler::linearization::TrimError;
use newton_euler::prelude::*;

rigid_body!(Copter {
    doc: "Its battery runs down, and with it the thrust.",
    motion: planar_translation,
    inputs: [command],
    states: [charge[C], duty],
    rates: [
        charge = -3[A] * duty.powi(2) * voltage / 12[V],
        duty = (command - duty) / 0.05[s],
    ],
    locals: [voltage = 10[V] + 2[V] * charge / 5000[C]],
    mass: 0.3[kg],
    fields: [weight = mass * world(0, -9.81[m / s ^ 2])],
    forces: [
        thrust = 0.03[N / V ^ 2] * (duty * voltage).powi(2) * world(0, 1),
        drag = -0.2[kg / s] * velocity,
    ],
    outputs: [linearization],
});

#[test]
fn a_battery_runs_down_in_steady_flight() {
    let start = CopterState {
        charge: 2500.0,
        duty: 0.8,
        ..CopterState::default()
    };
    let copter = Copter::default();
    let search = || copter.trim(&start).free(["duty", "command"]);
    let hover = search().changing(["charge"]).solve().unwrap();
    let duty = (0.3_f64 * 9.81 / 0.03).sqrt() / 11.0;
    assert!((hover.state.duty - duty).abs() < 1e-15);
    assert!((hover.input.command - duty).abs() < 1e-15);
    assert_eq!(hover.state.charge, 2500.0);
    assert_eq!(hover.undetermined, 0);
    // without, nothing but an empty battery is steady
    let error = search().solve().err().unwrap();
    assert!(matches!(error, TrimError::Unbalanced { .. }), "{error}");
    // a full throttle, in a climb that slows down: its velocity is changing, too
    let full = CopterInput { command: 0.95 };
    let climb = copter.trim(&start).input(&full).free(["duty"]);
    let climb = climb.changing(["charge", "velocity"]).solve().unwrap();
    assert!((climb.state.duty - 0.95).abs() < 1e-15);
    assert_eq!(climb.state.motion, start.motion);
    for name in ["position", "fuel"] {
        let error = search().changing([name]).solve().err().unwrap();
        assert_eq!(error, TrimError::Unknown { name });
    }
}
