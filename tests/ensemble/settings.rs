//! Settings that are impossible for all members, and initial states that are for one.

use newton_euler::ensemble::{Ensemble, EnsembleError, OneByOne};
use newton_euler::integrate::{DormandPrince8, Fixed, InvalidSetting, Setting};
use newton_euler::prelude::*;

use crate::bodies::{Turning, TurningInput};

const STEPS: Fixed<DormandPrince8> = Fixed {
    method: DormandPrince8,
    step: 0.05,
};

fn turning(members: usize) -> Ensemble<Turning<f64>> {
    Ensemble::new(&Turning::default(), vec![Rotation::default(); members])
}

fn input(_: f64, _: usize, _: &Rotation) -> TurningInput<f64> {
    unreachable!("nothing moves")
}

type Ended = Result<(), EnsembleError<Rotation>>;

/// What `main` prints: it names no member.
fn told(end: Ended) -> String {
    format!("{:?}", end.unwrap_err())
}

/// By whatever method, to whatever end, and of none: one error without a member.
#[test]
fn settings_are_those_of_all() {
    for (members, end) in [(5, 1.0), (5, 0.0), (0, 1.0), (0, 0.0)] {
        let mut all = turning(members);
        assert_eq!(
            told(all.integrate().tolerance(-1.0).to(end)),
            "the tolerance is -1: it must be positive and finite"
        );
        assert_eq!(
            told(all.integrate().tolerance(f64::NAN).method(STEPS).to(end)),
            "the tolerance is NaN: it must be positive and finite"
        );
        assert_eq!(
            told(all.integrate().max_step(0.0).to(end)),
            "the longest step is 0 s: it must be positive"
        );
        let step = Fixed {
            step: -0.5,
            ..STEPS
        };
        let refused = "the step is -0.5 s: it must be positive";
        assert_eq!(told(all.integrate().method(step).to(end)), refused);
        let one_by_one = all.integrate().method(OneByOne(step));
        assert_eq!(told(one_by_one.to(end)), refused);
        assert_eq!(
            told(all.integrate().control(0.0, input).to(end)),
            "the period is 0 s: it must be positive"
        );
        assert_eq!(
            told(all.integrate().breaks([0.5, f64::NAN]).to(end)),
            "a break is NaN s: it must be finite"
        );
        assert_eq!(
            told(all.integrate().starting_at(f64::INFINITY).to(end)),
            "the start is inf s: it must be finite"
        );
        let events = all.integrate().max_step(-1.0).events(end, |_, _, _| 1.0);
        assert_eq!(
            told(events.map(|_| ())),
            "the longest step is -1 s: it must be positive"
        );
        let each = all.integrate().max_step(-1.0).each_to(end);
        let (setting, value) = (Setting::MaxStep, -1.0);
        assert_eq!(each, Err(InvalidSetting { setting, value }));
        assert!(*all.states() == *turning(members).states());
    }
}

/// Steps that are lost in rounding at the end are refused at the start.
#[test]
fn steps_too_short_for_the_end() {
    let mut all = turning(5);
    assert_eq!(
        told(all.integrate().max_step(1e-300).to(0.3)),
        "the longest step is 1e-300 s: it must be above the rounding of time"
    );
    let step = Fixed {
        step: 1e-300,
        ..STEPS
    };
    assert_eq!(
        told(all.integrate().method(step).to(0.3)),
        "the step is 1e-300 s: it must be above the rounding of time"
    );
    assert_eq!(
        told(all.integrate().control(1e-300, input).to(0.3)),
        "the period is 1e-300 s: it must be above the rounding of time"
    );
}

/// What cannot be sampled is one error, and no motion.
#[test]
fn periods_that_are_none() {
    for members in [0, 3] {
        for period in [0.0, -1.0, f64::NAN] {
            let mut all = turning(members);
            let mut samples = all.integrate().samples(1.0, period);
            let error = samples.next().unwrap().map(|_| ());
            let is_told = matches!(error, Err(EnsembleError::Setting(invalid))
                if invalid.setting == Setting::Period && invalid.value.to_bits() == period.to_bits());
            assert!(is_told && samples.next().is_none(), "{period}");
            assert!(*all.states() == *turning(members).states());
        }
        let mut all = turning(members);
        let mut samples = all.integrate().samples(f64::NAN, 0.1);
        let error = samples.next().unwrap().map(|_| ());
        assert_eq!(told(error), "the end is NaN s: it must be finite");
        // the start is the only sample
        let mut samples = all.integrate().samples(1.0, 2.0);
        assert!(samples.next().unwrap().is_ok() && samples.next().is_none());
    }
}

/// An initial state is that of a member, which is named; the others may go on.
#[test]
fn initial_states_are_those_of_members() {
    let mut all = turning(6);
    let mut state = all.state(4);
    state.angular_velocity.x = f64::INFINITY;
    all.states_mut().set(4, &state);
    let refused = "member 4: a coordinate of the initial state is inf: it must be finite";
    for end in [0.0, 1.0] {
        assert_eq!(told(all.integrate().to(end)), refused);
        assert_eq!(told(all.integrate().method(STEPS).to(end)), refused);
        let events = all.integrate().events(end, |_, _, _| 1.0);
        assert_eq!(told(events.map(|_| ())), refused);
        let lost = all.clone().integrate().each_to(end).unwrap();
        let lost: Vec<String> = lost.iter().map(ToString::to_string).collect();
        assert_eq!(lost, [refused]);
    }
}
