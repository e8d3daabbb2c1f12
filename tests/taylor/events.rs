//! Zeros of functions along the motion.

use newton_euler::integrate::{Event, Motion};
use newton_euler::prelude::*;

use crate::scenes;

const G: f64 = 9.80665;

/// The period of the pendulum of 2 kg at 0.5 m, of 0.6 kg m² about its pin: 2 π / ω₀ / agm(1, cos(amplitude / 2)).
fn period(amplitude: f64) -> f64 {
    let rate = (2.0 * G * 0.5 / 0.6_f64).sqrt();
    let (mut a, mut b) = (1.0, (amplitude / 2.0).cos());
    for _ in 0..6 {
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
    }
    std::f64::consts::TAU / rate / a
}

/// All zeros of `function` on the way.
fn events(times: std::ops::Range<f64>, function: fn(f64, &Hinge) -> f64) -> Vec<Event<Hinge>> {
    let body = scenes::Pendulum::default();
    let start = Hinge {
        angle: 2.0,
        ..Hinge::default()
    };
    let mut motion = Motion::<_, 19>::new(&body, times.start, &start);
    let mut events = Vec::new();
    while let Some(step) = motion.step_towards(times.end, &(), 1e-13).unwrap() {
        events.extend(step.zeros(function).map(Result::unwrap));
    }
    events
}

/// From a turning point, the next ones follow at half the period, in turn.
#[test]
fn turning_points_of_a_pendulum() {
    let half = 0.5 * period(2.0);
    for direction in [1.0, -1.0] {
        let turns = events(0.0..direction * 10.2 * half, |_, state| {
            state.angular_velocity
        });
        assert_eq!(turns.len(), 10);
        for (k, turn) in turns.iter().enumerate() {
            let expected = direction * half * (k + 1) as f64;
            assert!(
                (turn.time - expected).abs() < 1e-11,
                "{} for {expected}",
                turn.time
            );
            let side = if k % 2 == 0 { -2.0 } else { 2.0 };
            assert!((turn.state.angle - side).abs() < 1e-11, "{:?}", turn.state);
            // the rate goes from negative to positive on the left, in time
            assert_eq!(turn.rises, side < 0.0);
        }
    }
}

/// The lowest point is passed a quarter of a period later.
#[test]
fn lowest_points() {
    let quarter = 0.25 * period(2.0);
    let passes = events(0.0..8.0 * quarter, |_, state| state.angle);
    assert_eq!(passes.len(), 4);
    for (k, pass) in passes.iter().enumerate() {
        let expected = quarter * (2 * k + 1) as f64;
        assert!(
            (pass.time - expected).abs() < 1e-11,
            "{} for {expected}",
            pass.time
        );
        assert_eq!(pass.rises, k % 2 == 1);
    }
}

/// A zero at the end of a step is found once: steps are half open.
#[test]
fn a_zero_at_an_end_counts_once() {
    let body = scenes::Pendulum::default();
    let start = Hinge {
        angle: 0.3,
        ..Hinge::default()
    };
    let mut motion = Motion::<_, 13>::new(&body, 0.0, &start);
    let mut found = Vec::new();
    for _ in 0..4 {
        let step = motion.step(0.125, &()).unwrap();
        found.extend(
            step.zeros(|time, _| time - 0.25)
                .map(|event| event.unwrap().time),
        );
    }
    assert_eq!(found, [0.25]);
}

/// Within a step the motion is as good as at its end.
#[test]
fn between_the_ends() {
    let body = scenes::Pendulum::default();
    let start = Hinge {
        angle: 2.0,
        ..Hinge::default()
    };
    let energy =
        |state: &Hinge| body.kinetic_energy(state) + body.potential_energy(0.0, state, &());
    let mut motion = Motion::<_, 17>::new(&body, 0.0, &start);
    let mut last = start;
    while let Some(step) = motion.step_towards(3.0, &(), 1e-12).unwrap() {
        let (from, to) = (step.start(), step.end());
        assert!((step.at(from).angle - last.angle).abs() < 4e-15);
        for part in [0.25, 0.5, 0.75, 1.0] {
            let between = step.at(from + part * (to - from));
            assert!((energy(&between) - energy(&start)).abs() < 1e-10);
        }
        last = step.at(to);
    }
    assert!((last.angle - motion.state().angle).abs() < 1e-14);
}

/// A function whose zeros are searched.
type Watched<'f> = &'f dyn Fn(f64, &Hinge) -> f64;

/// A step ends where the next one begins, to the bit: a zero there is found once.
#[test]
fn zeros_where_steps_end() {
    let body = scenes::Pendulum::default();
    let start = Hinge {
        angle: 2.0,
        ..Hinge::default()
    };
    let mut motion = Motion::<_, 17>::new(&body, 0.1, &start);
    let mut ends = Vec::new();
    while let Some(step) = motion.step_towards(20.0, &(), 1e-10).unwrap() {
        let end = (step.end(), step.at(step.end()));
        assert_eq!(end, (motion.time(), motion.state()));
        ends.push(end);
    }
    assert!(ends.len() > 20);
    for (time, state) in ends {
        let functions: [Watched<'_>; 2] = [&|now, _| now - time, &|now, there| {
            let near = (now - time).abs() < 0.1;
            if near { there.angle - state.angle } else { 1.0 }
        }];
        for function in functions {
            let mut motion = Motion::<_, 17>::new(&body, 0.1, &start);
            let mut found = 0;
            while let Some(step) = motion.step_towards(20.0, &(), 1e-10).unwrap() {
                let at = |zero: Result<Event<Hinge>, _>| zero.unwrap().time;
                let near = |zero: &f64| (zero - time).abs() < 1e-6;
                found += step.zeros(function).map(at).filter(near).count();
            }
            assert_eq!(found, 1, "{time}");
        }
    }
}
