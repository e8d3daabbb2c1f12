//! Samples, steps and events.

use nalgebra::{Rotation2, Vector2};
use newton_euler::integrate::{Classical4, Fixed, Held, Integration, Method, Sample};
use newton_euler::prelude::*;

use crate::scenes::{
    Drifting, ExactPendulum, HeavyTop, HeldPendulum, Pendulum, SeriesPendulum, Tethered,
    TetheredInput, ends, error, period,
};

const START: Hinge = Hinge {
    angle: 2.0,
    angular_velocity: 0.0,
};

fn samples<B, M>(
    motion: Integration<'_, B, M, Held<()>>,
    end: f64,
    every: f64,
) -> Vec<Sample<Hinge>>
where
    B: RigidBody<Scalar = f64, State = Hinge, Input = ()>,
    M: Method<B>,
{
    motion
        .samples(end, every)
        .map(|sample| sample.unwrap())
        .collect()
}

/// Samples between the ends of steps are as good as the ends, by every method, in both directions.
#[test]
fn samples_against_the_closed_form() {
    let exact = ExactPendulum::default();
    for end in [7.0, -7.0] {
        let expected = samples(exact.integrate(&START), end, 0.1);
        let by_stages = samples(
            Pendulum::default().integrate(&START).tolerance(1e-13),
            end,
            0.1,
        );
        let by_series = samples(
            SeriesPendulum::default().integrate(&START).tolerance(1e-13),
            end,
            0.1,
        );
        let fixed = Fixed {
            method: Classical4,
            step: 1e-3,
        };
        let by_steps = samples(
            Pendulum::default().integrate(&START).method(fixed),
            end,
            0.1,
        );
        assert_eq!(expected.len(), 71);
        for (list, limit) in [(by_stages, 1e-11), (by_series, 1e-11), (by_steps, 1e-9)] {
            assert_eq!(list.len(), 71);
            for (sample, expected) in list.iter().zip(&expected) {
                assert_eq!(sample.time, expected.time);
                let error = (sample.state.angle - expected.state.angle).abs();
                assert!(error < limit, "{} s: {error:e}", sample.time);
            }
        }
        for (k, sample) in (0..=70).zip(&expected) {
            assert!((sample.time - f64::from(k) * 0.1_f64.copysign(end)).abs() < 1e-14);
            assert_eq!(sample.state, exact.flow(&START, sample.time));
        }
    }
}

/// The last sample is the end where the period divides the span, and before it where it does not.
#[test]
fn the_last_sample() {
    let body = Pendulum::default();
    let last = |end, every| {
        samples(body.integrate(&START), end, every)
            .pop()
            .unwrap()
            .time
    };
    assert_eq!(last(0.3, 0.1), 0.3);
    assert_eq!(last(-0.3, 0.1), -0.3);
    assert!((last(0.35, 0.1) - 0.3).abs() < 1e-15);
    assert_eq!(last(0.0, 0.1), 0.0);
    let from_ten: Vec<f64> = body
        .integrate(&START)
        .starting_at(10.0)
        .samples(11.0, 0.25)
        .map(|sample| sample.unwrap().time)
        .collect();
    assert_eq!(from_ten, [10.0, 10.25, 10.5, 10.75, 11.0]);
}

/// The last sample is not lost in the rounding of large times.
#[test]
fn samples_far_from_zero() {
    let body = Pendulum::default();
    for k in 0..1000_u32 {
        let start = 1e3 * f64::from(k) + 0.6 + 0.1 * f64::from(k % 7);
        let motion = body.integrate(&START).starting_at(start);
        let count = motion.samples(start + 0.3, 0.1).count();
        assert_eq!(count, 4, "{start}");
    }
}

/// Of a fall from nearly upright, all that the other methods see.
#[test]
fn brief_events_of_a_closed_form() {
    let start = Hinge {
        angle: std::f64::consts::PI - 1e-7,
        angular_velocity: 0.0,
    };
    for height in [-0.5, -0.8, -0.95, 0.95] {
        let crossing = |_: f64, state: &Hinge| state.angle.cos() - height;
        let exact = ExactPendulum::default();
        let series = SeriesPendulum::default();
        let events = exact.integrate(&start).events(20.0, crossing).count();
        let expected = series
            .integrate(&start)
            .tolerance(1e-13)
            .events(20.0, crossing)
            .count();
        assert!(events == expected && events > 2, "{height}: {events}");
    }
}

/// Sampling does not change the motion: the ends are the same to the bit.
#[test]
fn samples_do_not_cut_steps() {
    let [start, _] = ends("heavy_asym");
    let top = HeavyTop::default();
    let end = top.integrate(&start).to(10.0).unwrap();
    let last = top
        .integrate(&start)
        .samples(10.0, 0.01)
        .last()
        .unwrap()
        .unwrap();
    assert_eq!(last.state, end);
    let steps: Vec<_> = top
        .integrate(&start)
        .steps(10.0)
        .map(|step| step.unwrap())
        .collect();
    assert_eq!(steps.last().unwrap().state, end);
    assert!(steps.windows(2).all(|pair| pair[0].time < pair[1].time));
    assert!((5..100).contains(&steps.len()), "{}", steps.len());
}

/// Turning points follow at half the period, by every method.
#[test]
fn events_of_a_pendulum() {
    let half = 0.5 * period(2.0);
    for direction in [1.0, -1.0] {
        let end = direction * 10.2 * half;
        let turns = |_: f64, state: &Hinge| state.angular_velocity;
        let (plain, series, exact) = (
            Pendulum::default(),
            SeriesPendulum::default(),
            ExactPendulum::default(),
        );
        let fixed = Fixed {
            method: Classical4,
            step: 1e-3,
        };
        let lists: [(f64, Vec<_>); 4] = [
            (
                1e-10,
                plain
                    .integrate(&START)
                    .tolerance(1e-13)
                    .events(end, turns)
                    .collect(),
            ),
            (
                1e-10,
                series
                    .integrate(&START)
                    .tolerance(1e-13)
                    .events(end, turns)
                    .collect(),
            ),
            (1e-13, exact.integrate(&START).events(end, turns).collect()),
            (
                1e-9,
                plain
                    .integrate(&START)
                    .method(fixed)
                    .events(end, turns)
                    .collect(),
            ),
        ];
        for (limit, list) in lists {
            assert_eq!(list.len(), 10);
            for (k, event) in (1..).zip(list) {
                let event = event.unwrap();
                let expected = direction * half * f64::from(k);
                assert!(
                    (event.time - expected).abs() < limit,
                    "{} for {expected}",
                    event.time
                );
                let side = if k % 2 == 1 { -2.0 } else { 2.0 };
                assert!((event.state.angle - side).abs() < 1e-9);
                assert_eq!(event.rises, side < 0.0);
            }
        }
    }
}

/// A pin as a constraint holds at every step and every sample.
#[test]
fn under_constraints() {
    let center = Rotation2::new(2.0) * Vector2::new(0.0, -0.5);
    let start = Planar {
        position: center,
        angle: 2.0,
        ..Planar::default()
    };
    let held = HeldPendulum::default();
    let exact = ExactPendulum::default();
    for sample in held.integrate(&start).tolerance(1e-12).samples(20.0, 0.37) {
        let Sample { time, state } = sample.unwrap();
        for violation in held.violations(time, &state, &()) {
            assert!(
                violation.position.unwrap().abs() < 1e-14 && violation.velocity.abs() < 1e-13,
                "{violation:?}"
            );
        }
        let expected = exact.flow(&START, time);
        assert!((state.angle - expected.angle).abs() < 1e-8, "{time}");
    }
    // a string that is let out: from then on its length is the new one
    let hanging = Translation {
        position: [0.6, 0.0, -0.8].into(),
        ..Translation::default()
    };
    let tethered = Tethered::default();
    let let_out = |time: f64, _: &Translation| TetheredInput {
        out: if time > 0.05 { 0.01 } else { 0.0 },
        ..TetheredInput::default()
    };
    let at_once = tethered
        .integrate(&hanging)
        .tolerance(1e-12)
        .control(0.1, let_out)
        .to(0.2)
        .unwrap();
    let mut first = tethered
        .integrate(&hanging)
        .tolerance(1e-12)
        .to(0.1)
        .unwrap();
    let longer = TetheredInput {
        out: 0.01,
        ..TetheredInput::default()
    };
    tethered.project(0.1, &mut first, &longer).unwrap();
    let second = tethered.integrate(&first).tolerance(1e-12).input(longer);
    let second = second.starting_at(0.1).to(0.2).unwrap();
    assert!((at_once.position - second.position).norm() < 1e-12);

    // far from the pin
    let astray = Planar {
        position: Vector2::new(3.0, 4.0),
        velocity: Vector2::new(f64::MAX, 0.0),
        ..Planar::default()
    };
    let error = held.integrate(&astray).to(1.0).unwrap_err();
    assert!(
        error.to_string().contains("inconsistent start: `held"),
        "{error}"
    );
}

#[test]
fn best_of_a_symmetric_motion() {
    let [start, expected] = ends("heavy_asym");
    let end = HeavyTop::default()
        .integrate(&start)
        .tolerance(1e-12)
        .to(10.0)
        .unwrap();
    assert!(error(&end, &expected) < 1e-10);
}

/// A function that becomes zero and stays so: where it does.
#[test]
fn events_where_a_function_becomes_zero_and_stays() {
    let drifting = Drifting::default();
    let start = Translation {
        velocity: [1.0, 0.0, 0.0].into(),
        ..Translation::default()
    };
    for place in [0.3_f64, 7.77, 450.0] {
        let function = |_: f64, state: &Translation| (place - state.position.x).max(0.0);
        let motion = drifting.integrate(&start);
        let found: Vec<_> = motion.events(1e3, function).map(Result::unwrap).collect();
        assert_eq!(found.len(), 1);
        assert!(
            (found[0].time - place).abs() < 1e-12 * 1e3,
            "{}",
            found[0].time
        );
        let timed = drifting
            .integrate(&start)
            .events(1e3, |time, _| (place - time).max(0.0));
        let timed: Vec<_> = timed.map(Result::unwrap).collect();
        assert!(
            (timed[0].time - place).abs() < 1e-12 * 1e3,
            "{}",
            timed[0].time
        );
    }
}

/// A zero at the end of a step is found, wherever rounding puts the length of the step: at times at
/// which steps end, and at the end of the motion.
#[test]
fn events_where_steps_end() {
    let (by_stages, by_series) = (Pendulum::default(), SeriesPendulum::default());
    let exact = ExactPendulum::default();
    for k in 1..100 {
        let time = f64::from(k) * 0.1;
        for (start, end) in [(-3.3, 10.0), (0.037, time), (10.7, -0.9)] {
            if (start < end) != (start < time) {
                continue;
            }
            let clock = |now: f64, _: &Hinge| now - time;
            let seen = [
                by_stages
                    .integrate(&START)
                    .starting_at(start)
                    .breaks([time])
                    .events(end, clock)
                    .map(|event| event.unwrap().time)
                    .collect::<Vec<_>>(),
                by_series
                    .integrate(&START)
                    .starting_at(start)
                    .breaks([time])
                    .events(end, clock)
                    .map(|event| event.unwrap().time)
                    .collect(),
                exact
                    .integrate(&START)
                    .starting_at(start)
                    .breaks([time])
                    .events(end, clock)
                    .map(|event| event.unwrap().time)
                    .collect(),
            ];
            for times in seen {
                assert_eq!(times, [time], "from {start} to {end}");
            }
        }
    }
}
