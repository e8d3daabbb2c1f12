//! Each method has its order, and every body reaches the same end with each of them.

use newton_euler::integrate::{
    Classical4, DormandPrince, DormandPrince8, Embedded, Equations, Fixed, Midpoint, Motion,
    RungeKutta, RungeKuttaPair, TaylorSeries, Tsitouras5, Verner, Verner9, taylor,
};
use newton_euler::prelude::*;
use newton_euler::state::Coordinates as _;

use crate::scenes::{
    Chirp, ExactBody, FreeBody, HeavyTop, Kicked, SeriesPendulum, SeriesTop, Stiffening, ends,
    error,
};

/// The order that shows between two lengths of steps is that of the method.
fn shows<M: RungeKutta>(method: M, steps: [f64; 2]) {
    let [start, expected] = ends("heavy_asym");
    let top = HeavyTop::default();
    let [coarse, fine] = steps.map(|step| {
        let end = top
            .integrate(&start)
            .method(Fixed { method, step })
            .to(10.0);
        error(&end.unwrap(), &expected)
    });
    let order = (coarse / fine).log2() / (steps[0] / steps[1]).log2();
    #[expect(clippy::cast_precision_loss, reason = "a small number")]
    let expected = M::ORDER as f64;
    assert!(
        (expected - 0.3..expected + 0.7).contains(&order),
        "{method:?}: {order}, {coarse:e} {fine:e}"
    );
}

#[test]
fn fixed_methods() {
    shows(Midpoint, [0.01, 0.005]);
    shows(Classical4, [0.02, 0.01]);
    shows(Tsitouras5, [0.025, 0.0125]);
    shows(DormandPrince8, [0.2, 0.1]);
    shows(Verner9, [0.25, 0.125]);
}

/// Differences to methods of lower order shrink with the step as these do.
#[test]
fn differences_of_pairs() {
    fn orders<P: Embedded>(step: f64) -> Vec<f64> {
        let [start, _] = ends("heavy_asym");
        let (body, start) = (&HeavyTop::default(), start.coordinates());
        let sizes = |step: f64| {
            let (_, differences) = P::sums(&Equations { body, input: &() }, 0.0, &start, step);
            let size = |one: &[f64; 7]| one.iter().map(|part| part * part).sum::<f64>().sqrt();
            differences.as_ref().iter().map(size).collect::<Vec<f64>>()
        };
        let (long, short) = (sizes(step), sizes(0.5 * step));
        long.iter()
            .zip(&short)
            .map(|(a, b)| (a / b).log2())
            .collect()
    }
    // Verner's coefficients of order nine are small, and in longer steps the next order shows
    let near = |found: Vec<f64>, expected: &[f64]| {
        let is_near = |(a, b): (&f64, &f64)| (-0.3..1.3).contains(&(a - b));
        let are_near = found.iter().zip(expected).all(is_near) && found.len() == expected.len();
        assert!(are_near, "{found:?}, not {expected:?}");
    };
    near(orders::<DormandPrince8>(0.1), &[6.0, 4.0]);
    near(orders::<Verner9>(0.2), &[9.0]);
}

/// In small steps nothing but rounding is left.
#[test]
fn high_orders_come_to_rounding() {
    comes_to_rounding(DormandPrince8, 0.02);
    comes_to_rounding(Verner9, 0.03125);
}

fn comes_to_rounding<M: RungeKutta>(method: M, step: f64) {
    for name in ["heavy_asym", "asymmetric_free"] {
        let [start, expected] = ends(name);
        let fine = Fixed { method, step };
        let end = if name == "heavy_asym" {
            HeavyTop::default().integrate(&start).method(fine).to(10.0)
        } else {
            FreeBody::default().integrate(&start).method(fine).to(10.0)
        };
        let error = error(&end.unwrap(), &expected);
        assert!(error < 5e-14, "{name}: {error:e}");
    }
}

/// The error at the end follows the tolerance, within what ten seconds make of the errors of the steps.
#[test]
fn tolerances() {
    let [start, expected] = ends("heavy_asym");
    for tolerance in [1e-4, 1e-6, 1e-8, 1e-10, 1e-12] {
        let by_dop853 = HeavyTop::default()
            .integrate(&start)
            .method(DormandPrince { tolerance })
            .to(10.0);
        let by_verner = HeavyTop::default()
            .integrate(&start)
            .method(Verner { tolerance })
            .to(10.0);
        let by_series = SeriesTop::default()
            .integrate(&start)
            .tolerance(tolerance)
            .to(10.0);
        for (method, end) in [
            ("DOP853", by_dop853),
            ("Verner 9(8)", by_verner),
            ("series", by_series),
        ] {
            let error = error(&end.unwrap(), &expected);
            assert!(
                error < 200.0 * tolerance,
                "{method} at {tolerance:e}: {error:e}"
            );
        }
    }
}

/// The best of a body is what its description asks for, to the bit.
#[test]
fn the_best_method() {
    let [start, expected] = ends("heavy_asym");
    let (plain, series) = (HeavyTop::default(), SeriesTop::default());
    let motion = || plain.integrate(&start);
    let best = |tolerance| motion().tolerance(tolerance).to(10.0).unwrap();
    let (coarse, fine) = (
        DormandPrince { tolerance: 1e-4 },
        Verner { tolerance: 1e-11 },
    );
    assert_eq!(best(1e-4), motion().method(coarse).to(10.0).unwrap());
    assert_eq!(best(1e-11), motion().method(fine).to(10.0).unwrap());
    let pair = RungeKuttaPair { tolerance: 1e-11 };
    assert_eq!(best(1e-11), motion().method(pair).to(10.0).unwrap());
    let best = series.integrate(&start).tolerance(1e-11).to(10.0).unwrap();
    let other = TaylorSeries { tolerance: 1e-11 };
    assert_eq!(
        best,
        series.integrate(&start).method(other).to(10.0).unwrap()
    );
    assert_eq!(
        best,
        taylor(&series, &start, &(), 0.0..10.0, 1e-11).unwrap()
    );
    assert!(error(&best, &expected) < 1e-9);

    let [start, expected] = ends("asymmetric_free");
    let exact = ExactBody::default();
    let end = exact.integrate(&start).to(10.0).unwrap();
    assert_eq!(end, exact.flow(&start, 10.0));
    assert!(error(&end, &expected) < 2e-14);
}

/// Where the last coefficients of a series vanish, or nearly, it is not taken for a polynomial.
#[test]
fn series_with_gaps() {
    let start = Translation {
        position: [1.0, 0.0, 0.0].into(),
        ..Translation::default()
    };
    for begin in [0.0, 1e-12, 1e-9, 1e-6, 1e-3] {
        for tolerance in [1e-3, 1e-5, 1e-6, 1e-8, 1e-9, 1e-11, 1e-13] {
            let chirp = Chirp::default();
            let motion = || chirp.integrate(&start).starting_at(begin);
            let by_series = motion().tolerance(tolerance).to(3.0).unwrap();
            let exact = motion()
                .method(DormandPrince { tolerance: 1e-14 })
                .to(3.0)
                .unwrap();
            let error = (by_series.position - exact.position).norm();
            assert!(
                error < 100.0 * tolerance,
                "chirp from {begin} at {tolerance:e}: {error:e}"
            );

            let spring = Stiffening::default();
            let motion = || spring.integrate(&start).starting_at(begin);
            let by_series = motion().tolerance(tolerance).to(3.0).unwrap();
            let exact = motion()
                .method(DormandPrince { tolerance: 1e-14 })
                .to(3.0)
                .unwrap();
            let error = (by_series.position - exact.position).norm();
            assert!(
                error < 300.0 * tolerance,
                "spring from {begin} at {tolerance:e}: {error:e}"
            );
        }
    }
}

/// Series of two and three coefficients know little of their radius, and go on in short steps.
#[test]
fn the_lowest_orders() {
    fn steps<const N: usize>() -> usize {
        let (pendulum, start) = (
            SeriesPendulum::default(),
            Hinge {
                angle: 1.0,
                angular_velocity: 0.0,
            },
        );
        let mut motion = Motion::<_, N>::new(&pendulum, 0.0, &start);
        let mut steps = 0;
        while motion.step_towards(0.1, &(), 1e-3).unwrap().is_some() {
            steps += 1;
        }
        let exact = pendulum.integrate(&start).to(0.1).unwrap();
        assert!((motion.state().angle - exact.angle).abs() < 0.1);
        steps
    }
    assert!(steps::<2>() > 1 && steps::<3>() > 1);
}

/// What acts for a second after five of rest is seen, if it is a twentieth of the whole.
#[test]
fn a_kick_after_rest() {
    let end = Kicked::default()
        .integrate(&Translation::default())
        .to(20.0)
        .unwrap();
    assert!((end.position.x - 14.5).abs() < 1e-6, "{end:?}");
}

/// There and back again.
#[test]
fn backwards() {
    let [start, _] = ends("heavy_asym");
    let top = HeavyTop::default();
    let there = top
        .integrate(&start)
        .starting_at(3.0)
        .tolerance(1e-13)
        .to(8.0)
        .unwrap();
    let back = top
        .integrate(&there)
        .starting_at(8.0)
        .tolerance(1e-13)
        .to(3.0)
        .unwrap();
    assert!(error(&back, &start) < 1e-11);
    let there = top
        .integrate(&start)
        .method(Fixed {
            method: Tsitouras5,
            step: 1e-3,
        })
        .to(-2.0)
        .unwrap();
    let back = top
        .integrate(&there)
        .starting_at(-2.0)
        .tolerance(1e-13)
        .to(0.0)
        .unwrap();
    assert!(error(&back, &start) < 1e-11);
}
