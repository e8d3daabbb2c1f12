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
