//! Members that fail have the errors that they have alone: kind, time, state and load.

use std::fmt::Debug;

use nalgebra::Vector3;
use newton_euler::columns::Generic;
use newton_euler::ensemble::{
    Ensemble, EnsembleControl, EnsembleError, EnsembleSamples, MemberError, Moves, OneByOne,
    Together,
};
use newton_euler::integrate::{
    Classical4, Control, DormandPrince8, Fixed, Integration, IntegrationError, Method, Midpoint,
    Setting, Verner,
};
use newton_euler::lanes::Width;
use newton_euler::prelude::*;

use crate::bodies::{Turning, TurningInput};

// the cable snaps at some time, and the law of its tension has no value from then on
rigid_body!(Climber::<T> {
    motion: translation,
    params: [snap = 2[s]],
    inputs: [push[N]],
    mass: 1[kg],
    forces: [
        engine = world(0, 0, push),
        cable = if t < snap && t > -snap {
            -0.1[kg / s] * velocity
        } else {
            -0.1[kg / s] * velocity * (-t / 1[s] * t / 1[s]).sqrt()
        },
    ],
});
// a winch, which pulls after half a second, and less if more is out
rigid_body!(Pulled::<T> {
    motion: translation,
    inputs: [out[m].moving],
    mass: 1[kg],
    forces: [winch = if t < 0.5[s] {
        world(0, 0, 0)
    } else {
        world(1[N] * ((1[m] - out) / 1[m]).sqrt(), 0, 0)
    }],
});
// a drum that may be too fast for the rounding of time
rigid_body!(Beaten::<T> {
    motion: translation,
    inputs: [beats[1 / s]],
    mass: 1[kg],
    forces: [drum = if t * beats - (t * beats).floor() < 0.5 {
        world(1[N], 0, 0)
    } else {
        world(0, 0, 0)
    }],
});

// the law of the gap has no value for a moment, which a step may pass over
rigid_body!(Gap::<T> {
    motion: translation,
    mass: 1[kg],
    forces: [gap = world(1[N / s] * ((t - 0.3[s]).powi(2) - 0.01[s ^ 2]).sqrt(), 0, 0)],
});

/// How a motion ends: the number of its samples, and its last state or its error.
type Ended<S> = (usize, Result<S, IntegrationError<S>>);

/// The settings of all motions.
#[derive(Clone, Copy, Debug)]
struct Settings {
    end: f64,
    max_step: f64,
    /// The period of a controller.
    control: Option<f64>,
    /// The period of samples.
    samples: Option<f64>,
}

impl Settings {
    fn all(end: f64) -> impl Iterator<Item = Self> {
        let periods = [
            (None, None),
            (Some(0.37), None),
            (None, Some(0.13)),
            (Some(0.37), Some(0.13)),
        ];
        let periods = periods.into_iter();
        periods.flat_map(move |(control, samples)| {
            [f64::INFINITY, 0.11].map(|max_step| Self {
                end,
                max_step,
                control,
                samples,
            })
        })
    }
}

/// A member that moves alone.
fn alone<B, M>(start: &Ensemble<B>, index: usize, method: M, settings: Settings) -> Ended<B::State>
where
    B: Generic<Input: Clone> + Integrate,
    M: Moves<B> + Copy,
{
    let (body, state) = (start.body(index), start.state(index));
    let motion = body.integrate(&state).method(method.alone());
    let motion = motion.max_step(settings.max_step);
    let input = start.inputs().get(index);
    match settings.control {
        None => alone_to(motion.input(input), settings),
        Some(period) => alone_to(motion.control(period, |_, _| input.clone()), settings),
    }
}

fn alone_to<B, M, C>(motion: Integration<'_, B, M, C>, settings: Settings) -> Ended<B::State>
where
    B: Generic,
    M: Method<B>,
    C: Control<B::State, B::Input>,
{
    match settings.samples {
        None => (0, motion.to(settings.end)),
        Some(period) => last_of(motion.samples(settings.end, period)),
    }
}

fn last_of<S, E>(samples: impl Iterator<Item = Result<Sample<S>, E>>) -> (usize, Result<S, E>) {
    let all: Vec<_> = samples.collect();
    let good = all.iter().filter(|sample| sample.is_ok()).count();
    let last = all.into_iter().next_back().expect("the start at least");
    (good, last.map(|sample| sample.state))
}

fn last<B: Generic, M: Moves<B>, C: EnsembleControl<B>>(
    samples: EnsembleSamples<'_, B, M, C>,
) -> (usize, Result<(), EnsembleError<B::State>>) {
    let (count, last) = last_of(samples);
    (count, last.map(|_| ()))
}

/// Compares all members with motions alone, to the bit; returns the errors without a controller.
fn fail_as_if_alone<B, M>(start: &Ensemble<B>, method: M, end: f64) -> Vec<MemberError<B::State>>
where
    B: Generic<State: PartialEq + Copy + Debug, Input: Clone> + Integrate<Best: Together<B>>,
    M: Moves<B> + Copy,
{
    let mut errors = Vec::new();
    let widths = Width::ALL.into_iter().filter(|width| width.is_there());
    for (width, settings) in
        widths.flat_map(|width| Settings::all(end).map(move |one| (width, one)))
    {
        let given = |_: f64, index: usize, _: &B::State| start.inputs().get(index);
        let case = format!("{width:?}, {settings:?}, {}", std::any::type_name::<M>());
        let mut ensemble = start.clone();
        ensemble.set_width(width);

        // the first that fails
        let motion = ensemble
            .integrate()
            .method(method)
            .max_step(settings.max_step);
        let (count, ended) = match (settings.control, settings.samples) {
            (None, None) => (0, motion.to(end)),
            (Some(period), None) => (0, motion.control(period, given).to(end)),
            (None, Some(period)) => last(motion.samples(end, period)),
            (Some(control), Some(period)) => {
                last(motion.control(control, given).samples(end, period))
            }
        };
        let error = ended.expect_err("one fails");
        let error = error.member().expect("a member");
        let wanted = alone(start, error.index, method, settings);
        assert_eq!(wanted, (count, Err(error.error)), "{}: {case}", error.index);

        // each that fails
        if settings.samples.is_some() {
            continue;
        }
        let mut ensemble = start.clone();
        ensemble.set_width(width);
        let motion = ensemble
            .integrate()
            .method(method)
            .max_step(settings.max_step);
        let lost = match settings.control {
            None => motion.each_to(end).unwrap(),
            Some(period) => motion.control(period, given).each_to(end).unwrap(),
        };
        for index in 0..start.len() {
            let (_, wanted) = alone(start, index, method, settings);
            let error = lost.iter().find(|one| one.index == index);
            assert_eq!(wanted.err(), error.map(|one| one.error), "{index}: {case}");
            let state = wanted.unwrap_or_else(|error| *error.state());
            assert_eq!(ensemble.state(index), state, "{index}: {case}");
        }
        if settings.control.is_none() {
            errors = lost;
        }
    }
    errors
}

/// The errors by explicit and implicit fixed steps, and with error control.
fn fail_by_each_method<B>(start: &Ensemble<B>, end: f64) -> [Vec<MemberError<B::State>>; 3]
where
    B: Generic<State: PartialEq + Copy + Debug, Input: Clone> + Integrate<Best: Together<B>>,
{
    [
        fail_as_if_alone(start, by(Classical4), end),
        fail_as_if_alone(start, by(Midpoint), end),
        fail_as_if_alone(start, Verner { tolerance: 1e-6 }, end),
    ]
}

fn by<M>(method: M) -> Fixed<M> {
    Fixed { method, step: 0.05 }
}

/// A load without a value after some steps, of some members, each at a time of its own.
#[test]
fn loads_are_named() {
    let climbers = |end: f64| {
        let climber = |index: usize| {
            let snap = [0.3, 1e3, 0.02, 0.6, 1e3, 0.0, 1e3, 1.1, 1e3, 1e3, 0.31][index];
            let velocity = Vector3::z() * end.signum();
            let (params, state) = (
                ClimberParams { snap },
                Translation {
                    velocity,
                    ..Translation::default()
                },
            );
            (params, state)
        };
        let mut all = Ensemble::<Climber<f64>>::with_params((0..11).map(climber)).unwrap();
        all.inputs_mut().set(9, &ClimberInput { push: f64::NAN });
        all
    };
    for end in [1.5, -1.5] {
        let start = climbers(end);
        let named = |errors: Vec<MemberError<Translation>>| {
            let indices: Vec<usize> = errors.iter().map(|one| one.index).collect();
            assert_eq!(indices, [0, 2, 3, 5, 7, 9, 10]);
            for MemberError { index, error } in errors {
                let wanted = if index == 9 { "engine" } else { "cable" };
                let is_named = matches!(error, IntegrationError::NotFinite { load, .. } if load == Some(wanted));
                assert!(is_named, "{index}: {error}");
            }
        };
        named(fail_as_if_alone(&start, by(Classical4), end));
        named(fail_as_if_alone(&start, by(DormandPrince8), end));
        named(fail_as_if_alone(&start, OneByOne(by(Classical4)), end));
        fail_as_if_alone(&start, by(Midpoint), end);
        fail_as_if_alone(&start, Verner { tolerance: 1e-6 }, end);
    }
}

/// The input of a winch moves on its own.
#[test]
fn loads_of_moving_inputs_are_named() {
    let mut start = Ensemble::new(&Pulled::default(), [Translation::default(); 5]);
    start.inputs_mut().update(|index, input| {
        input.out_rate = [0.0, 3.5, 0.4, 9.0, 0.6][index];
    });
    for errors in fail_by_each_method(&start, 1.5) {
        let named = errors.iter().map(|one| match one.error {
            IntegrationError::NotFinite { load, .. } => (one.index, load),
            other => panic!("{other}"),
        });
        assert_eq!(
            named.collect::<Vec<_>>(),
            [(1, Some("winch")), (3, Some("winch"))]
        );
    }
}

/// An implicit step that is too long for the spin of a member.
#[test]
fn steps_are_too_long() {
    let spinning = |index: usize| Rotation {
        angular_velocity: Vector3::new(0.1, [1.0, 2.0, 300.0, 0.5, 80.0][index % 5], 0.3),
        ..Rotation::default()
    };
    let mut start = Ensemble::new(&Turning::default(), (0..9).map(spinning));
    let torque = Vector3::new(0.0, f64::NAN, 0.0);
    start.inputs_mut().set(3, &TurningInput { torque });
    // too fast only after some time
    let torque = Vector3::new(0.0, 150.0, 0.0);
    start.inputs_mut().set(6, &TurningInput { torque });
    let errors = fail_as_if_alone(&start, by(Midpoint), 1.5);
    let indices: Vec<usize> = errors.iter().map(|one| one.index).collect();
    assert_eq!(indices, [2, 3, 4, 6, 7]);
    for MemberError { index, error } in errors {
        let is_told = match error {
            IntegrationError::StepTooLong { time, .. } => {
                index != 3 && (time > 0.2) == (index == 6)
            }
            IntegrationError::NotFinite { time, load, .. } => {
                index == 3 && time == 0.0 && load == Some("drive")
            }
            _ => false,
        };
        assert!(is_told, "{index}: {error}");
    }
    // explicit steps of any snap are taken
    fail_as_if_alone(&start, by(Classical4), 1.5);
}

/// Conditions whose period is lost in the rounding of time.
#[test]
fn periods_are_refused() {
    let mut start = Ensemble::new(&Beaten::default(), [Translation::default(); 5]);
    start.inputs_mut().update(|index, input| {
        input.beats = [3.0, 1e30, 1.0, 0.0, 1e25][index];
    });
    for errors in fail_by_each_method(&start, 1.5) {
        let refused = errors.iter().map(|one| match one.error {
            IntegrationError::InvalidSetting { setting, .. } => (one.index, setting),
            other => panic!("{other}"),
        });
        let period = Setting::PeriodOfCondition;
        assert_eq!(refused.collect::<Vec<_>>(), [(1, period), (4, period)]);
    }
}

/// A sample within a step may have no value though the step has one: it is the same alone.
#[test]
fn samples_without_a_value_are_told() {
    let method = Fixed {
        method: Classical4,
        step: 1.0,
    };
    let state = Translation::default();
    let mut ensemble = Ensemble::new(&Gap::default(), [state; 5]);
    let samples = ensemble.integrate().method(method).samples(2.0, 0.6);
    let body = Gap::default();
    let alone = body.integrate(&state).method(method).samples(2.0, 0.6);
    let mut without = 0;
    for (sample, alone) in samples.zip(alone) {
        let (sample, alone) = (sample.unwrap().state.get(3), alone.unwrap().state);
        let [sample, alone] = [sample, alone].map(|state| state.velocity.x);
        // the sign of NaN is not promised
        let is_same = sample.to_bits() == alone.to_bits() || sample.is_nan() && alone.is_nan();
        assert!(is_same, "{sample}, {alone}");
        without += usize::from(alone.is_nan());
    }
    assert_eq!(without, 1);
}
