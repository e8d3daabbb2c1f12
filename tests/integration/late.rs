//! Motions that start long after zero, and a time beyond all doubles.

use newton_euler::integrate::{DormandPrince, IntegrationError, Method, TaylorSeries, Verner};
use newton_euler::prelude::*;

rigid_body!(Oscillator {
    motion: translation,
    mass: 1[kg],
    forces: [spring = -100[N / m] * position],
    outputs: [taylor],
});

const START: Translation = Translation {
    position: nalgebra::Vector3::new(1.0, 0.0, 0.0),
    velocity: nalgebra::Vector3::new(0.0, 0.0, 0.0),
};

/// The largest error of a motion that starts at a time \[m\].
fn error<M: Method<Oscillator>>(method: M, start: f64) -> f64 {
    let body = Oscillator::default();
    let errors = (1..=70).map(|hundredths| {
        let end = start + f64::from(hundredths) / 100.0;
        let motion = body.integrate(&START).method(method);
        let state = motion.starting_at(start).to(end).unwrap();
        (state.position.x - (10.0 * (end - start)).cos()).abs()
    });
    errors.fold(0.0, f64::max)
}

#[test]
fn late_motions_are_as_accurate_as_early_ones() {
    let tolerance = 1e-13;
    for start in [0.0, 1e6, -1e6, 1e9, -1e9] {
        assert!(error(Verner { tolerance }, start) < 1e-13, "{start}");
        assert!(error(DormandPrince { tolerance }, start) < 1e-12, "{start}");
        assert!(error(TaylorSeries { tolerance }, start) < 1e-13, "{start}");
    }
}

#[test]
fn a_time_beyond_all_doubles_is_an_error() {
    let rest = Translation::default();
    let body = Oscillator::default();
    let motion = body.integrate(&rest);
    let end = motion
        .method(Verner { tolerance: 1e-9 })
        .starting_at(-1e308)
        .to(1e308);
    assert!(
        matches!(end, Err(IntegrationError::NotFinite { .. })),
        "{end:?}"
    );
}

/// A motion of a few roundings of time is one step. The last piece of a sum of pieces is as short.
#[test]
fn motions_of_a_few_roundings_are_one_step() {
    let body = Oscillator::default();
    let verner = Verner { tolerance: 1e-9 };
    let moved = |start: f64, end: f64, state: &Translation| {
        let motion = body.integrate(state).method(verner);
        motion.starting_at(start).to(end).unwrap()
    };
    for start in [1.0_f64, -1.0, 1e-300, 0.0, 1e9] {
        for roundings in 1..40 {
            let mut end = start;
            (0..roundings).for_each(|_| end = end.next_up());
            let seconds = end - start;
            for (from, to) in [(start, end), (end, start)] {
                let found = moved(from, to, &START).position.x;
                let expected = (10.0 * seconds).cos();
                assert!((found - expected).abs() < 1e-13, "{from} to {to}");
            }
        }
    }
    for pieces in 1..200 {
        let (mut time, mut state) = (0.0, START);
        while time < 1.0 {
            let next = (time + 1.0 / f64::from(pieces)).min(1.0);
            state = moved(time, next, &state);
            time = next;
        }
        assert!((state.position.x - 10_f64.cos()).abs() < 1e-6, "{pieces}");
    }
}

rigid_body!(Leaking {
    motion: translation,
    states: [water[kg]],
    rates: [water = -0.001[kg / s]],
    mass: 1[kg] + water,
    forces: [spring = -100[N / m] * position],
});

/// Steps that are lost in rounding are what is said, not the tank that is empty long after the end.
#[test]
fn a_late_step_that_is_lost_is_the_reason() {
    let start = LeakingState {
        motion: START,
        water: 1.0,
    };
    let bucket = Leaking::default();
    for late in [1e15, -1e15, 1e16] {
        let motion = bucket.integrate(&start).starting_at(late);
        let error = motion.to(late + 4.0).unwrap_err();
        assert!(
            matches!(error, IntegrationError::StepTooSmall { .. }),
            "{error}"
        );
    }
}

#[test]
fn late_periods_of_a_few_roundings_are_taken() {
    let body = Oscillator::default();
    for (start, period) in [(1e9, 3e-7), (1e9, 1e-6), (1e12, 1e-3)] {
        let motion = body.integrate(&START).method(Verner { tolerance: 1e-9 });
        let motion = motion.starting_at(start).max_step(period);
        let end = motion.to(start + 20.0 * period).unwrap();
        let expected = (10.0 * ((start + 20.0 * period) - start)).cos();
        assert!((end.position.x - expected).abs() < 1e-9, "{start}");
    }
}
