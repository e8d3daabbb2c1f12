//! The interface of `integrate` for all members: controllers, samples, events, errors.

use nalgebra::Vector3;
use newton_euler::ensemble::{Ensemble, EnsembleError, OneByOne};
use newton_euler::integrate::{DormandPrince, DormandPrince8, Fixed, IntegrationError, Verner};
use newton_euler::prelude::*;

use crate::bodies;

/// Each member under a controller of its own; a member that fails is named, and all stay where they were.
#[test]
fn controllers_and_errors() {
    let body = bodies::Turning::default();
    let rest = [Rotation::default(); 11];
    let mut ensemble = Ensemble::new(&body, rest);
    let steps = Fixed {
        method: DormandPrince8,
        step: 0.05,
    };
    let control = |time: f64, index: usize, _: &Rotation| bodies::TurningInput {
        torque: Vector3::new(0.0, 0.0, if index == 4 { time } else { 1.5 }),
    };
    ensemble
        .integrate()
        .method(steps)
        .control(0.25, control)
        .to(1.0)
        .unwrap();
    for (index, state) in ensemble.states().iter().enumerate() {
        let pushed = if index == 4 {
            0.25 * (0.25 + 0.5 + 0.75) / 1.5
        } else {
            1.0
        };
        assert!((state.angular_velocity.z - pushed).abs() < 1e-14, "{index}");
    }

    let before = ensemble.states().clone();
    let push = |push| bodies::TurningInput {
        torque: Vector3::new(0.0, 0.0, push),
    };
    ensemble.inputs_mut().set(7, &push(f64::NAN));
    let lost = |error: EnsembleError<Rotation>| {
        let text = error.to_string();
        let named = error.member().unwrap().index == 7;
        assert!(
            named && text.starts_with("member 7: the motion is not finite"),
            "{text}"
        );
    };
    lost(ensemble.integrate().method(steps).to(1.0).unwrap_err());
    assert!(*ensemble.states() == before);
    lost(ensemble.integrate().to(1.0).unwrap_err());
    assert!(*ensemble.states() == before);

    for step in [0.0, -1.0, f64::NAN] {
        assert!(
            ensemble
                .integrate()
                .method(Fixed { step, ..steps })
                .to(1.0)
                .is_err()
        );
        assert!(
            ensemble
                .integrate()
                .method(steps)
                .control(step, |_, _, _| push(1.0))
                .to(1.0)
                .is_err()
        );
    }
    for end in [f64::NAN, f64::INFINITY] {
        assert!(ensemble.integrate().method(steps).to(end).is_err());
        assert!(ensemble.integrate().to(end).is_err());
    }
    assert!(ensemble.integrate().starting_at(2.0).to(2.0).is_ok());
}

fn spinning() -> Ensemble<bodies::Turning<f64>> {
    let spinning = |i: u8| Rotation {
        angular_velocity: Vector3::new(0.1, 1.0 + 0.1 * f64::from(i), 0.3),
        ..Rotation::default()
    };
    Ensemble::new(&bodies::Turning::default(), (0..19).map(spinning))
}

/// One input for all members, which they keep.
#[test]
fn one_input_for_all() {
    let mut ensemble = Ensemble::new(&bodies::Turning::default(), [Rotation::default(); 11]);
    let torque = Vector3::new(0.0, 0.0, 1.5);
    let input = bodies::TurningInput { torque };
    ensemble.integrate().input(&input).to(1.0).unwrap();
    ensemble.integrate().starting_at(1.0).to(2.0).unwrap();
    for state in ensemble.states() {
        assert!((state.angular_velocity.z - 2.0).abs() < 1e-12);
    }
    let last = ensemble.states().iter().next_back();
    assert_eq!(last, Some(ensemble.state(10)));
}

/// Under a controller that reads the state, each member moves as it would alone, and the ensemble is
/// where its last sample is.
#[test]
fn controlled_members_move_as_if_alone() {
    let body = bodies::Turning::default();
    let starts: Vec<_> = (0..9)
        .map(|index| Rotation {
            angular_velocity: Vector3::new(0.1, 0.2 * f64::from(index), 1.0),
            ..Rotation::default()
        })
        .collect();
    let push = |state: &Rotation| bodies::TurningInput {
        torque: -0.3 * state.angular_velocity,
    };
    for (tolerance, end) in [(1e-3, 2.1), (1e-9, 2.1), (1e-9, -1.3)] {
        let mut ensemble = Ensemble::new(&body, starts.clone());
        let motion = ensemble.integrate().tolerance(tolerance);
        let motion = motion.control(0.25, |_, _, state: &Rotation| push(state));
        motion.to(end).unwrap();
        let mut sampled = Ensemble::new(&body, starts.clone());
        let motion = sampled.integrate().tolerance(tolerance);
        let motion = motion.control(0.25, |_, _, state: &Rotation| push(state));
        let last = motion.samples(end, 0.1).last().unwrap().unwrap();
        assert!(last.state == *ensemble.states() && last.state == *sampled.states());
        for (index, start) in starts.iter().enumerate() {
            let motion = body.integrate(start).method(Verner { tolerance });
            let alone = motion.control(0.25, |_, state: &Rotation| push(state));
            assert!(ensemble.state(index) == alone.to(end).unwrap(), "{index}");
        }
    }
}

/// A controller and samples of another period: the inputs change when the controller is asked, and only then.
#[test]
fn samples_under_a_controller() {
    let mut ensemble = Ensemble::new(&bodies::Turning::default(), [Rotation::default(); 3]);
    let mut asked = Vec::new();
    let control = |time: f64, index: usize, _: &Rotation| {
        if index == 0 {
            asked.push(time);
        }
        let torque = Vector3::new(0.0, 0.0, if time < 0.9 { 1.5 } else { 0.0 });
        bodies::TurningInput { torque }
    };
    let motion = ensemble.integrate().tolerance(1e-12).control(0.5, control);
    let rates: Vec<f64> = motion
        .samples(2.0, 0.4)
        .map(|sample| sample.unwrap().state.get(2).angular_velocity.z)
        .collect();
    for (rate, wanted) in rates.iter().zip([0.0, 0.4, 0.8, 1.0, 1.0, 1.0]) {
        assert!((rate - wanted).abs() < 1e-12, "{rates:?}");
    }
    assert_eq!(rates.len(), 6);
    assert_eq!(asked, [0.0, 0.5, 1.0, 1.5]);
}

/// Events are those of each member alone, to the bit, and the ensemble comes to the end.
#[test]
fn events_are_those_of_each_alone() {
    let start = spinning();
    let mut ensemble = start.clone();
    let height = |index: usize, state: &Rotation| {
        let level = if index.is_multiple_of(2) { 0.0 } else { 0.1 };
        state.attitude.transform_vector(&Vector3::x()).z - level
    };
    let seen = ensemble
        .integrate()
        .method(OneByOne(DormandPrince { tolerance: 1e-10 }))
        .events(8.0, |_, index, state| height(index, state))
        .unwrap();
    let mut alone = Vec::new();
    for index in 0..start.len() {
        let (body, state) = (start.body(index), start.state(index));
        let motion = || {
            body.integrate(&state)
                .method(DormandPrince { tolerance: 1e-10 })
        };
        let events = motion().events(8.0, |_, state| height(index, state));
        alone.extend(events.map(|event| (index, event.unwrap())));
        // where steps end only where the tolerance puts them, the last ends at the end
        assert!(
            ensemble.state(index) == motion().to(8.0).unwrap(),
            "{index}"
        );
    }
    let seen: Vec<_> = seen
        .into_iter()
        .map(|seen| (seen.index, seen.event))
        .collect();
    assert!(seen.len() > 19 && seen == alone);

    let before = ensemble.states().clone();
    ensemble.inputs_mut().set(
        3,
        &bodies::TurningInput {
            torque: Vector3::repeat(f64::INFINITY),
        },
    );
    let lost = ensemble.integrate().events(1.0, |_, _, _| 1.0).unwrap_err();
    assert!(lost.member().unwrap().index == 3 && *ensemble.states() == before);

    // a function that is not a number, of one member
    let mut ensemble = spinning();
    let function = |_: f64, index: usize, _: &_| if index == 2 { f64::NAN } else { 0.0 };
    let error = ensemble.integrate().events(1.0, function).unwrap_err();
    let lost = error.member().unwrap();
    let is_of_event = matches!(
        lost.error,
        IntegrationError::EventNotANumber { time: 0.0, .. }
    );
    assert!(lost.index == 2 && is_of_event && *ensemble.states() == *spinning().states());
}

/// Members that do not come to the end are handed out with their index, and the others come there.
#[test]
fn others_do_not_wait() {
    let moved = |start: &Ensemble<bodies::Turning<f64>>| {
        let mut ensemble = start.clone();
        let lost = ensemble.integrate().tolerance(1e-10).each_to(2.0).unwrap();
        (ensemble, lost)
    };
    let (mut start, all) = (spinning(), moved(&spinning()));
    assert!(all.1.is_empty());
    for index in [3, 12] {
        let torque = Vector3::new(0.0, f64::NAN, 0.0);
        start
            .inputs_mut()
            .set(index, &bodies::TurningInput { torque });
    }
    let (ensemble, lost) = moved(&start);
    let indices: Vec<usize> = lost.iter().map(|one| one.index).collect();
    assert_eq!(indices, [3, 12]);
    for index in 0..start.len() {
        let wanted = if indices.contains(&index) {
            start.state(index)
        } else {
            all.0.state(index)
        };
        assert!(ensemble.state(index) == wanted, "{index}");
    }
}

/// Under a controller they stay at their last good states, while the others go on.
#[test]
fn others_go_on_under_a_controller() {
    let mut ensemble = Ensemble::new(&bodies::Turning::default(), [Rotation::default(); 9]);
    let control = |time: f64, index: usize, _: &Rotation| {
        let push = if index == 5 && time > 0.4 {
            f64::NAN
        } else {
            1.5
        };
        let torque = Vector3::new(0.0, 0.0, push);
        bodies::TurningInput { torque }
    };
    let lost = ensemble
        .integrate()
        .control(0.25, control)
        .each_to(1.0)
        .unwrap();
    assert_eq!(lost.len(), 1);
    assert_eq!((lost[0].index, lost[0].error.time()), (5, 0.5));
    for (index, state) in ensemble.states().iter().enumerate() {
        let wanted = if index == 5 { 0.5 } else { 1.0 };
        let rate = state.angular_velocity.z;
        assert!((rate - wanted).abs() < 1e-12, "{index}: {rate}");
    }
}
