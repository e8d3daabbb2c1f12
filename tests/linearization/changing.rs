//! Steady motions of bodies in which something runs down meanwhile.

use newton_euler::linearization::TrimError;
use newton_euler::prelude::*;

/// The states that an error advises to let change.
fn drifting(error: &TrimError) -> Vec<&'static str> {
    match error {
        TrimError::Drifting { states, .. } => states.iter().flatten().copied().collect(),
        _ => Vec::new(),
    }
}

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
    assert_eq!(drifting(&error), ["charge"], "{error}");
    let text = error.to_string();
    let advice = "; whatever the inputs, states change: add `.changing([\"charge\"])`";
    assert!(
        text.starts_with("not steady: `") && text.ends_with(advice),
        "{text}"
    );
    // it is said before what is held is freed: no command makes up for it
    let error = copter.trim(&start).free(["duty"]).solve().err().unwrap();
    assert_eq!(drifting(&error), ["charge"], "{error}");
    // with it, the held command is told
    let search = || copter.trim(&start).free(["duty"]).changing(["charge"]);
    let error = search().solve().err().unwrap();
    let TrimError::Unbalanced { held, .. } = error else {
        panic!("{error}");
    };
    assert_eq!(held, [Some("command"), None, None], "{error}");
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

rigid_body!(Balloon {
    doc: "It burns its fuel and leaks, and its burner wears out: each at a rate that never vanishes.",
    motion: planar_translation,
    inputs: [flame[rad]],
    states: [heat[K], fuel[kg], age, filter[N]],
    rates: [
        heat = 40[K / s] * flame.exp() - 0.3[1 / s] * heat,
        fuel = -2e-3[kg / s] * flame.exp(),
        age = (1 + age.powi(2)) / 3600[s],
        filter = (pull - filter) / 0.5[s],
    ],
    locals: [pull = 0.05[N / K] * heat],
    mass: 3[kg] + fuel,
    fields: [weight = mass * world(0, -9.81[m / s ^ 2])],
    forces: [lift = world(0, filter)],
    outputs: [linearization],
});

#[test]
fn all_that_runs_down_is_named() {
    let balloon = Balloon::default();
    let start = BalloonState {
        heat: 500.0,
        fuel: 2.0,
        filter: 30.0,
        ..BalloonState::default()
    };
    let search = || balloon.trim(&start).free(["heat", "filter", "flame"]);
    let error = search().solve().err().unwrap();
    assert_eq!(drifting(&error), ["fuel", "age"], "{error}");
    assert!(size_of_val(&error) <= 128);
    let level = search().changing(["fuel", "age"]).solve().unwrap();
    let heat = 5.0 * 9.81 / 0.05;
    assert!((level.state.heat / heat - 1.0).abs() < 1e-14);
    assert!((level.input.flame - (0.3 * heat / 40.0_f64).ln()).abs() < 1e-14);
    // what nothing balances is not said to change
    let search = balloon.trim(&start).free(["flame"]);
    let error = search.solve().err().unwrap();
    assert!(drifting(&error).is_empty(), "{error}");
}

rigid_body!(Ferry {
    motion: planar_translation,
    inputs: [push[N], push_x[N]],
    states: [fuel[kg], fuel_x[kg]],
    rates: [fuel = -0.1[kg / s], fuel_x = -0.2[kg / s]],
    mass: 900[kg],
    forces: [
        propeller = world(push, 0),
        thruster = world(0, push_x - 30[N])
    ],
    outputs: [linearization],
});

/// A scalar called as a component is: `push` is not all that begins with it.
#[test]
fn a_name_is_that_of_the_quantity_that_has_it() {
    let (ferry, start) = (Ferry::default(), FerryState::default());
    let search = ferry.trim(&start).free(["push"]);
    let error = search.changing(["fuel", "fuel_x"]).solve().err().unwrap();
    let text = error.to_string();
    assert!(text.contains("free also `push_x`"), "{text}");
    let search = ferry.trim(&start).free(["push_x"]).changing(["fuel"]);
    let text = search.solve().err().unwrap().to_string();
    assert!(text.contains("`.changing([\"fuel_x\"])`"), "{text}");
    let search = ferry.trim(&start).free(["push_x"]);
    let steady = search.changing(["fuel", "fuel_x"]).solve().unwrap();
    assert!((steady.input.push_x - 30.0).abs() < 1e-12);
    // a whole vector
    let mut moving = start;
    moving.motion.velocity = [3.0, 4.0].into();
    let search = ferry.trim(&moving).free(["velocity", "push_x"]);
    assert_eq!(
        search
            .changing(["fuel", "fuel_x"])
            .solve()
            .unwrap()
            .undetermined,
        2
    );
}
