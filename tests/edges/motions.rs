//! Integrations return errors, and soon, whatever they are given.

use newton_euler::integrate::{
    Classical4, ClosedForm, DormandPrince, DormandPrince8, Fixed, IntegrationError, Method,
    Midpoint, Motion, Projected, RungeKutta, Setting, TaylorSeries, Tsitouras5, Verner, Verner9,
    cf4, taylor,
};
use newton_euler::prelude::*;
use newton_euler::state::Coordinates;

use crate::bounded;
use crate::kinds::*;

/// Numbers that are none, or at the ends of their range.
const NO_TIMES: [f64; 3] = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY];

/// What a motion comes to: its end, its last sample, its last step, and whether events came to an end.
fn ended<B, M>(body: &B, state: &B::State, method: M, start: f64, end: f64) -> [bool; 4]
where
    B: Integrate<State: Coordinates>,
    M: Method<B>,
{
    let motion = || body.integrate(state).starting_at(start).method(method);
    let good = |error: &IntegrationError<B::State>| {
        // the motion never left the start, bit by bit
        let (kept, first) = (error.state().coordinates(), state.coordinates());
        let bits =
            |list: &[f64]| -> Vec<u64> { list.iter().map(|number| number.to_bits()).collect() };
        assert_eq!(error.time().to_bits(), start.to_bits());
        if first.as_ref().iter().all(|number| number.is_finite()) {
            assert_eq!(bits(kept.as_ref()), bits(first.as_ref()));
        }
    };
    let to = motion().to(end);
    let _ = to.as_ref().inspect_err(|error| good(error));
    let sample = motion().samples(end, 0.1).last().expect("a sample");
    let step = motion().steps(end).last();
    let event = motion().events(end, |_, _| 1.0).last();
    [
        to.is_ok(),
        sample.is_ok(),
        step.is_none_or(|step| step.is_ok()),
        event.is_none_or(|event| event.is_ok()),
    ]
}

/// A body, a state and a method: where times or numbers of the state are none, all errs, at once.
fn check<B, M>(what: &'static str, body: B, state: B::State, method: M)
where
    B: Integrate<State: Coordinates> + Send + Sync + Clone + 'static,
    B::State: Send + Sync + 'static,
    M: Method<B> + 'static,
{
    let all = move || {
        assert_eq!(ended(&body, &state, method, 0.0, 0.2), [true; 4], "{what}");
        assert_eq!(
            ended(&body, &state, method, 0.0, -0.2),
            [true; 4],
            "{what} backwards"
        );
        assert_eq!(
            ended(&body, &state, method, 0.5, 0.5),
            [true; 4],
            "{what} nowhere"
        );
        for end in NO_TIMES {
            assert_eq!(
                ended(&body, &state, method, 0.5, end),
                [false; 4],
                "{what} to {end}"
            );
        }
        for start in NO_TIMES {
            assert_eq!(
                ended(&body, &state, method, start, 0.5),
                [false; 4],
                "{what} from {start}"
            );
        }
        for place in 0..state.coordinates().as_ref().len() {
            for number in NO_TIMES {
                let mut coordinates = state.coordinates();
                coordinates.as_mut()[place] = number;
                let state = B::State::from_coordinates(&coordinates);
                let found = ended(&body, &state, method, 0.5, 0.7)[0];
                assert!(!found, "{what}: coordinate {place} is {number}");
            }
        }
    };
    bounded(what, all);
}

pub fn spun() -> Spatial {
    Spatial {
        velocity: [1.0, 2.0, 3.0].into(),
        angular_velocity: [0.3, 0.2, 0.5].into(),
        ..Spatial::default()
    }
}

fn nodding() -> Rotation {
    Rotation {
        attitude: newton_euler::attitude::exp(&[0.4, 0.1, 0.0].into()),
        angular_velocity: [0.3, 0.2, 30.0].into(),
    }
}

const SWUNG: Hinge = Hinge {
    angle: 1.0,
    angular_velocity: 0.4,
};

fn hanging() -> Planar {
    Planar {
        position: [0.0, -0.5].into(),
        ..Planar::default()
    }
}

#[test]
fn in_equal_steps() {
    fn by(what: &'static str, method: impl RungeKutta + 'static) {
        let step = 0.03;
        check(what, Craft::default(), spun(), Fixed { method, step });
    }
    by("Midpoint", Midpoint);
    by("Classical4", Classical4);
    by("Tsitouras5", Tsitouras5);
    by("DormandPrince8", DormandPrince8);
    by("Verner9", Verner9);
}

#[test]
fn by_tolerance() {
    let verner = Verner { tolerance: 1e-9 };
    check("Verner 9(8)", Craft::default(), spun(), verner);
    let method = DormandPrince { tolerance: 1e-9 };
    check("DOP853", Craft::default(), spun(), method);
    check("DOP853 of a top", Top::default(), nodding(), method);
    check("DOP853 of a pendulum", Pendulum::default(), SWUNG, method);
    check("DOP853 of a rod", Stick::default(), Rod::default(), method);
    check(
        "DOP853 under constraints",
        Bead::default(),
        hanging(),
        Projected(method),
    );
}

#[test]
fn along_series() {
    let method = TaylorSeries { tolerance: 1e-9 };
    check("series", Quadrotor::default(), spun(), method);
    check("series of a top", Gyroscope::default(), nodding(), method);
    check("series of a pendulum", Swing::default(), SWUNG, method);
}

#[test]
fn in_closed_form() {
    check("closed form", Brick::default(), spun(), ClosedForm);
    check(
        "closed form of a top",
        Top::default(),
        nodding(),
        ClosedForm,
    );
    check(
        "closed form of a pendulum",
        Pendulum::default(),
        SWUNG,
        ClosedForm,
    );
    check(
        "closed form of a rod",
        Needle::default(),
        Rod::default(),
        ClosedForm,
    );
}

/// Tolerances that are none are errors; of what is coarser than everything, anything but for ever.
#[test]
fn tolerances() {
    bounded("tolerances", || {
        let (body, series) = (Craft::default(), Quadrotor::default());
        for tolerance in [f64::NAN, 0.0, -0.0, -1.0, f64::NEG_INFINITY] {
            assert!(
                body.integrate(&spun())
                    .tolerance(tolerance)
                    .to(1.0)
                    .is_err()
            );
            assert!(
                series
                    .integrate(&spun())
                    .tolerance(tolerance)
                    .to(1.0)
                    .is_err()
            );
        }
        for tolerance in [1.0, 1e300, f64::MAX, f64::INFINITY] {
            let _ = body.integrate(&spun()).tolerance(tolerance).to(1.0);
            let _ = series.integrate(&spun()).tolerance(tolerance).to(1.0);
            let _ = Bead::default()
                .integrate(&hanging())
                .tolerance(tolerance)
                .to(1.0);
        }
        // also where none is needed
        assert!(
            Brick::default()
                .integrate(&spun())
                .tolerance(f64::NAN)
                .to(1.0)
                .is_err()
        );
    });
}

/// A step that is none is an error; one that is too long is cut to what there is.
#[test]
fn steps() {
    bounded("steps", || {
        let body = Craft::default();
        let by = |step| {
            let method = Fixed {
                method: Classical4,
                step,
            };
            body.integrate(&spun()).method(method).to(0.1)
        };
        for step in [f64::NAN, 0.0, -0.0, -0.1, f64::NEG_INFINITY, 5e-324, 1e-300] {
            let error = by(step).unwrap_err();
            let is_of_step = matches!(
                error,
                IntegrationError::InvalidSetting {
                    setting: Setting::Step,
                    time: 0.0,
                    ..
                }
            );
            assert!(is_of_step, "{error}");
        }
        assert_eq!(by(f64::INFINITY), by(0.1));
        assert_eq!(by(f64::MAX), by(0.1));
    });
}

/// Inputs that are no numbers, held or given by a controller: the error has the last state before them.
#[test]
fn inputs() {
    bounded("inputs", || {
        let (body, start) = (Plank::default(), Planar::default());
        for thrust in NO_TIMES {
            let held = body.integrate(&start).input(PlankInput { thrust }).to(1.0);
            assert_eq!(
                held,
                Err(IntegrationError::NotFinite {
                    time: 0.0,
                    state: start,
                    load: Some("push"),
                })
            );
            let control = |time: f64, _: &Planar| PlankInput {
                thrust: if time < 0.45 { 1.0 } else { thrust },
            };
            let error = body
                .integrate(&start)
                .control(0.1, control)
                .to(1.0)
                .unwrap_err();
            assert!(
                matches!(error, IntegrationError::NotFinite { time, .. } if time == 0.5),
                "{error}"
            );
            let good = body
                .integrate(&start)
                .control(0.1, control)
                .to(0.5)
                .unwrap();
            assert_eq!(*error.state(), good);
        }
        for period in [f64::NAN, 0.0, -0.1, f64::NEG_INFINITY, 5e-324] {
            let control = |_: f64, _: &Planar| PlankInput { thrust: 1.0 };
            let motion = || {
                body.integrate(&start)
                    .starting_at(1.0)
                    .control(period, control)
            };
            assert!(motion().to(2.0).is_err(), "{period}");
            assert!(
                motion().samples(2.0, 0.5).last().unwrap().is_err(),
                "{period}"
            );
            assert!(
                motion().events(2.0, |_, _| 1.0).last().unwrap().is_err(),
                "{period}"
            );
        }
        let once = |_: f64, _: &Planar| PlankInput { thrust: 1.0 };
        assert!(
            body.integrate(&start)
                .control(f64::INFINITY, once)
                .to(1.0)
                .is_ok()
        );
        // inputs of constraints
        let (tethered, hung) = (
            Tethered::default(),
            Translation {
                position: [0.0, 0.0, -1.0].into(),
                ..Translation::default()
            },
        );
        for out in NO_TIMES {
            assert!(
                tethered
                    .integrate(&hung)
                    .input(TetheredInput {
                        out,
                        ..TetheredInput::default()
                    })
                    .to(1.0)
                    .is_err()
            );
        }
    });
}

/// Far from zero a step is lost in the rounding of time.
#[test]
fn late() {
    bounded("late", || {
        for start in [1e17, -1e17, 1e300, f64::MAX] {
            let end = start + start.abs() * 1e-10;
            let to = |body: &Craft<f64>| body.integrate(&spun()).starting_at(start).to(end);
            assert!(end == start || to(&Craft::default()).is_err(), "{start}");
        }
        // the whole range at once
        assert!(
            Craft::default()
                .integrate(&spun())
                .starting_at(f64::MIN)
                .to(f64::MAX)
                .is_err()
        );
        assert!(
            Quadrotor::default()
                .integrate(&spun())
                .starting_at(f64::MIN)
                .to(f64::MAX)
                .is_err()
        );
        let _ = Brick::default()
            .integrate(&spun())
            .starting_at(f64::MIN)
            .to(f64::MAX);
        let _ = Brick::default().integrate(&spun()).to(f64::MAX);
        let _ = Top::<f64>::default().integrate(&nodding()).to(1e300);
        let _ = Pendulum::<f64>::default().integrate(&SWUNG).to(1e300);
    });
}

/// States at the ends of the range of numbers: an end that is finite, or an error.
#[test]
fn sizes() {
    fn check<B: Integrate<State: Coordinates> + Send + 'static>(body: B, state: B::State)
    where
        B::State: Send,
    {
        bounded("sizes", move || {
            for size in [1e-308, 1e-200, 1e100, 1e150, 1e200, 1e300] {
                let mut coordinates = state.coordinates();
                for number in coordinates.as_mut() {
                    *number *= size;
                }
                for place in 0..coordinates.as_ref().len() {
                    // one after another large, then all
                    let mut one = state.coordinates();
                    one.as_mut()[place] *= size;
                    let _ = body
                        .integrate(&B::State::from_coordinates(&one))
                        .steps(1e-3)
                        .take(1000)
                        .last();
                }
                let _ = body
                    .integrate(&B::State::from_coordinates(&coordinates))
                    .steps(1e-3)
                    .take(1000)
                    .last();
            }
        });
    }
    check(Craft::default(), spun());
    check(Top::default(), nodding());
    check(Pendulum::default(), SWUNG);
    check(Needle::default(), Rod::default());
    check(Quadrotor::default(), spun());
    check(Gyroscope::default(), nodding());
    check(
        Bead::default(),
        Planar {
            angular_velocity: 1.0,
            velocity: [0.5, 0.0].into(),
            ..hanging()
        },
    );
    check(
        Stone::default(),
        Translation {
            velocity: [1.0, 1.0, 1.0].into(),
            ..Translation::default()
        },
    );
}

/// Functions for whole motions.
#[test]
fn functions() {
    bounded("functions", || {
        let body = Quadrotor::default();
        for end in NO_TIMES {
            assert!(taylor(&body, &spun(), &(), 0.0..end, 1e-9).is_err());
            assert!(taylor(&body, &spun(), &(), end..1.0, 1e-9).is_err());
            let moved = cf4(&body, &spun(), &(), 0.0..end, 4);
            assert!(!moved.position.iter().sum::<f64>().is_finite());
        }
        for tolerance in [f64::NAN, 0.0, -1.0] {
            for end in [0.0, 1.0] {
                assert!(taylor(&body, &spun(), &(), 0.0..end, tolerance).is_err());
            }
        }
        let start = spun();
        let mut motion = Motion::<_, 11>::new(&body, 0.0, &start);
        assert!(motion.step_towards(f64::NAN, &(), 1e-9).is_err());
        assert!(motion.step_towards(0.0, &(), f64::NAN).is_err());
        assert!(motion.step(f64::NAN, &()).is_err() && motion.step(f64::INFINITY, &()).is_err());
        assert_eq!((motion.time(), motion.state()), (0.0, start));
        assert_eq!(cf4(&body, &spun(), &(), 0.0..1.0, 0), spun());
    });
}
