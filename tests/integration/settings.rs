//! Impossible settings: each is told by its name, before anything moves, by whatever method.

use newton_euler::integrate::{Classical4, Fixed, IntegrationError, Sample, Setting};
use newton_euler::prelude::*;

use crate::scenes::{Cart, CartInput, ExactPendulum, Pendulum, SeriesPendulum};

const START: Hinge = Hinge {
    angle: 2.0,
    angular_velocity: 0.0,
};

/// Steps that are lost in rounding at the end are refused at the start: none would arrive.
#[test]
fn steps_too_short_for_the_end_are_refused() {
    fn is_refused<S>(end: &Result<S, IntegrationError<S>>) -> bool {
        matches!(end, Err(IntegrationError::InvalidSetting { time: 0.0, .. }))
    }
    let (body, series, cart) = (
        Pendulum::default(),
        SeriesPendulum::default(),
        Cart::default(),
    );
    let control = |_: f64, _: &Translation| CartInput { push: 1.0 };
    for step in [1e-300, 1e-20] {
        for end in [0.3, -0.3] {
            assert!(is_refused(&body.integrate(&START).max_step(step).to(end)));
            assert!(is_refused(&series.integrate(&START).max_step(step).to(end)));
        }
        let rest = Translation::default();
        let controlled = cart.integrate(&rest).control(step, control).to(0.3);
        assert!(is_refused(&controlled));
    }
    // the last step may be shorter
    let end = body.integrate(&START).max_step(0.1).to(0.3 + 1e-15);
    assert!(end.is_ok());
}

/// An impossible setting is told by its name, with its value and what it must be.
#[test]
fn settings_are_told() {
    fn told<S>(end: Result<S, IntegrationError<S>>) -> String {
        end.err().expect("an impossible setting").to_string()
    }
    let (body, series, exact) = (
        Pendulum::default(),
        SeriesPendulum::default(),
        ExactPendulum::default(),
    );
    let positive = |what: &str| format!("the {what}: it must be positive");
    let longer = |what: &str| format!("the {what}: it must be above the rounding of time");
    let valid = |what: &str| format!("the {what}: it must be positive and finite");
    let finite = |what: &str| format!("{what}: it must be finite");
    assert_eq!(
        told(body.integrate(&START).tolerance(-1.0).to(1.0)),
        valid("tolerance is -1")
    );
    assert_eq!(
        told(series.integrate(&START).tolerance(f64::NAN).to(1.0)),
        valid("tolerance is NaN")
    );
    for tolerance in [f64::INFINITY, 0.0] {
        let refused = valid(&format!("tolerance is {tolerance}"));
        assert_eq!(
            told(body.integrate(&START).tolerance(tolerance).to(1.0)),
            refused
        );
        assert_eq!(
            told(series.integrate(&START).tolerance(tolerance).to(1.0)),
            refused
        );
    }
    assert_eq!(
        told(body.integrate(&START).max_step(0.0).to(1.0)),
        positive("longest step is 0 s")
    );
    let far = body.integrate(&START).max_step(1e-20);
    assert_eq!(told(far.to(1.0)), longer("longest step is 1e-20 s"));
    let sampled = |end, period| {
        let mut samples = body.integrate(&START).samples(end, period);
        let (first, next) = (samples.next().unwrap(), samples.next());
        assert!(next.is_none());
        first.unwrap_err().to_string()
    };
    assert_eq!(sampled(1.0, -0.25), positive("period is -0.25 s"));
    assert_eq!(sampled(0.0, f64::NAN), positive("period is NaN s"));
    assert_eq!(sampled(1e300, 0.5), longer("period is 0.5 s"));
    let (cart, rest) = (Cart::default(), Translation::default());
    let control = |_: f64, _: &Translation| CartInput::default();
    let motion = cart.integrate(&rest).starting_at(1.0);
    assert_eq!(
        told(motion.control(-0.1, control).to(2.0)),
        positive("period is -0.1 s")
    );
    assert_eq!(
        told(body.integrate(&START).to(f64::NAN)),
        finite("the end is NaN s")
    );
    let late = exact.integrate(&START).starting_at(f64::INFINITY);
    assert_eq!(told(late.to(1.0)), finite("the start is inf s"));
    let thrown = Hinge {
        angular_velocity: f64::NAN,
        ..START
    };
    for end in [
        told(body.integrate(&thrown).to(1.0)),
        told(series.integrate(&thrown).to(1.0)),
        told(exact.integrate(&thrown).to(1.0)),
    ] {
        assert_eq!(end, finite("a coordinate of the initial state is NaN"));
    }
}

/// Settings are checked the same way by all methods, also where the start is the end, and nothing
/// is called before.
#[test]
fn settings_are_checked_first() {
    fn refused<S>(end: &Result<S, IntegrationError<S>>, expected: Setting) {
        let is_told = match end {
            Err(IntegrationError::InvalidSetting {
                setting, time: 0.0, ..
            }) => *setting == expected,
            _ => false,
        };
        assert!(is_told, "{expected}: {:?}", end.as_ref().err());
    }
    fn check<B: Integrate<State = Hinge>>(body: &B) {
        let motion = || body.integrate(&START);
        for end in [0.0, 1.0, -1.0] {
            for none in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
                for times in [[none, 0.5], [0.5, none]] {
                    refused(&motion().breaks(times).to(end), Setting::Break);
                }
                let start = Hinge {
                    angle: none,
                    ..START
                };
                refused(&body.integrate(&start).to(end), Setting::InitialState);
            }
            for none in [f64::NAN, 0.0, -1.0] {
                refused(&motion().tolerance(none).to(end), Setting::Tolerance);
                refused(&motion().max_step(none).to(end), Setting::MaxStep);
                let step = Fixed {
                    method: Classical4,
                    step: none,
                };
                refused(&motion().method(step).to(end), Setting::Step);
                // whatever comes after it
                let replaced = motion().tolerance(none).method(Fixed { step: 0.1, ..step });
                refused(&replaced.to(end), Setting::Tolerance);
                let controlled = motion().control(none, |_, _| unreachable!("nothing moves"));
                refused(&controlled.to(end), Setting::Period);
            }
            refused(
                &motion().tolerance(f64::INFINITY).to(end),
                Setting::Tolerance,
            );
            // the last value counts
            assert!(motion().tolerance(-1.0).tolerance(1e-6).to(end).is_ok());
        }
        let mut steps = motion().tolerance(-1.0).steps(0.0);
        assert!(steps.next().is_some_and(|step| step.is_err()) && steps.next().is_none());
        let mut events = motion().breaks([f64::NAN]).events(0.0, |_, _| 1.0);
        assert!(events.next().is_some_and(|event| event.is_err()) && events.next().is_none());
    }
    check(&Pendulum::default());
    check(&SeriesPendulum::default());
    check(&ExactPendulum::default());
}

/// No sample is beyond the end.
#[test]
fn samples_farther_apart_than_the_end() {
    for end in [0.3, -0.3] {
        let body = Pendulum::default();
        for period in [0.4, 1e300, f64::INFINITY] {
            let samples: Vec<_> = body.integrate(&START).samples(end, period).collect();
            let first = Sample {
                time: 0.0,
                state: START,
            };
            assert_eq!(samples, [Ok(first)]);
        }
    }
}

/// Times and values are printed to be read.
#[test]
fn numbers_in_messages_are_short() {
    let body = Pendulum::default();
    let far = body.integrate(&START).starting_at(1e300).max_step(-1e300);
    let error = far.to(1.1e300).unwrap_err();
    assert_eq!(
        error.to_string(),
        "the longest step is -1e300 s: it must be positive"
    );
    let none = |_: f64, _: &Hinge| f64::NAN;
    let mut events = body
        .integrate(&START)
        .starting_at(1e12)
        .events(1e12 + 1.0, none);
    assert_eq!(
        events.next().unwrap().unwrap_err().to_string(),
        "at 1e12 s the function of the events is not a number"
    );
}
