//! Ensembles in threads: the results do not depend on how many there are.

use nalgebra::Vector3;
use newton_euler::ensemble::{Ensemble, Statistics};
use newton_euler::prelude::*;

rigid_body!(Handle::<T> {
    motion: rotation,
    params: [largest = 3[kg * m ^ 2]],
    inertia: principal(1, 2, largest)[kg * m ^ 2],
});

#[test]
fn any_number_of_threads() {
    let members = (0..1000_u16).map(|i| {
        let share = f64::from(i) / 1000.0;
        let state = Rotation {
            angular_velocity: Vector3::new(0.01, 1.0, share),
            ..Rotation::default()
        };
        (
            HandleParams {
                largest: 2.0 + share,
            },
            state,
        )
    });
    let start = Ensemble::<Handle<f64>>::with_params(members).expect("possible bodies");
    let run = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .expect("threads");
        let mut ensemble = start.clone();
        let (accelerations, statistics) = pool.install(|| {
            ensemble.cf4(0.0..1.0, 20);
            (ensemble.accelerations(1.0), ensemble.statistics())
        });
        (ensemble.states().clone(), accelerations, statistics)
    };
    let alone = run(1);
    assert!(run(2) == alone);
    assert!(run(5) == alone);
    // and as in one sum
    assert!(alone.0.iter().collect::<Statistics<_>>() == alone.2);
}

/// Nothing is shown where there is no terminal, and the run is the same.
#[cfg(feature = "progress")]
#[test]
fn with_progress() {
    let state = Rotation {
        angular_velocity: Vector3::new(0.01, 1.0, 0.5),
        ..Rotation::default()
    };
    let mut shown = Ensemble::new(&Handle::<f64>::default(), [state]);
    let mut silent = shown.clone();
    shown.cf4_with_progress(0.0..1.0, 30);
    silent.cf4(0.0..1.0, 30);
    assert!(shown.states() == silent.states());
}
