//! Statistics: exact, and the same from any shards. They are compared with rational numbers.

use dashu_ratio::RBig;
use nalgebra::Vector2;
use newton_euler::columns::Columns;
use newton_euler::ensemble::{Ensemble, Moments, Statistics, shard};
use newton_euler::prelude::*;
use newton_euler::state::generic;

rigid_body!(Plank::<T> {
    motion: planar,
    params: [length = 2.4[m]],
    mass: 6[kg],
    inertia: mass * length.powi(2) / 12,
    fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
    forces: [drag = -0.05 * velocity.norm() * velocity],
});

/// Numbers of all sizes, small ones among them.
fn numbers(seed: u64, count: usize, exponents: std::ops::Range<u64>) -> Vec<f64> {
    let mut state = seed;
    let mut next = || {
        // Knuth's generator; its first bits are good
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        state >> 11
    };
    let mut number = || {
        let (sign, fraction) = (next() & 1, next() & ((1 << 52) - 1));
        let exponent = exponents.start + next() % (exponents.end - exponents.start);
        f64::from_bits(sign << 63 | exponent << 52 | fraction)
    };
    (0..count).map(|_| number()).collect()
}

fn exact(number: f64) -> RBig {
    RBig::try_from(number).expect("finite")
}

/// Mean and variance in rational numbers, rounded once.
fn rational(numbers: &[f64]) -> [f64; 2] {
    let count = RBig::from(numbers.len());
    let sum = numbers
        .iter()
        .fold(RBig::ZERO, |sum, number| sum + exact(*number));
    let squares = numbers.iter().fold(RBig::ZERO, |sum, number| {
        sum + exact(*number) * exact(*number)
    });
    let mean = &sum / &count;
    let variance = (squares - sum * &mean) / (count - RBig::ONE);
    [mean, variance].map(|value| value.to_f64().value())
}

#[test]
fn means_and_variances_are_rounded_once() {
    // ordinary; across the whole range; subnormal; a large offset, in which sums of doubles drown
    let close: Vec<f64> = numbers(5, 500, 1000..1020)
        .iter()
        .map(|x| 1e9 + x)
        .collect();
    let cases = [
        numbers(1, 1000, 1013..1033),
        numbers(2, 300, 1..1500),
        numbers(3, 97, 0..3),
        close,
        vec![0.1; 10],
        vec![1.0, 1.0 + f64::EPSILON],
        vec![5e-324, 0.0, 0.0],
        vec![5e-324, 5e-324, 0.0],
        vec![-2.5, 7.25],
    ];
    for case in cases {
        let moments: Moments = case.iter().copied().collect();
        let [mean, variance] = rational(&case);
        assert_eq!(
            moments.mean().map(f64::to_bits),
            Some(mean.to_bits()),
            "{mean:e}"
        );
        assert_eq!(
            moments.variance().map(f64::to_bits),
            Some(variance.to_bits()),
            "{variance:e}"
        );
    }
}

#[test]
fn few_numbers_have_no_mean_or_variance() {
    let nothing = Moments::new();
    assert_eq!(
        (nothing.mean(), nothing.variance(), nothing.least()),
        (None, None, None)
    );
    let one: Moments = [-0.0].into_iter().collect();
    assert_eq!((one.mean(), one.variance()), (Some(0.0), None));
    let lost: Moments = [f64::NAN, f64::INFINITY, 2.0, f64::NEG_INFINITY]
        .into_iter()
        .collect();
    assert_eq!(
        (lost.count(), lost.not_finite(), lost.mean()),
        (1, 3, Some(2.0))
    );
    let signs: Moments = [0.0, -0.0].into_iter().collect();
    let extremes = [signs.least(), signs.greatest()].map(|end| end.map(f64::to_bits));
    assert_eq!(extremes, [Some((-0.0_f64).to_bits()), Some(0)]);
}

#[test]
fn shards_cover_all_members_once() {
    for members in [0, 1, 2, 7, 1000, u64::MAX] {
        for shards in [1, 2, 3, 7, 1000] {
            let mut next = 0;
            for index in 0..shards {
                let shard = shard(members, index, shards);
                assert_eq!(shard.start, next);
                let size = shard.end - shard.start;
                assert!(size >= members / shards && size <= members.div_ceil(shards));
                next = shard.end;
            }
            assert_eq!(next, members);
        }
    }
}

/// Some of the members of a large ensemble: each is a function of its index.
fn planks(members: std::ops::Range<u64>) -> Ensemble<Plank<f64>> {
    let member = |index: u64| {
        let index = f64::from(u32::try_from(index).expect("few"));
        let params = PlankParams {
            length: 1.0 + 0.01 * index,
        };
        let state = generic::Planar {
            velocity: Vector2::new(index.sin(), 0.3),
            angular_velocity: 0.1 * index,
            ..generic::Planar::default()
        };
        (params, state)
    };
    Ensemble::with_params(members.map(member)).expect("planks of some length")
}

/// The statistics of shards, each moved for itself, passed on as text and merged in a given order.
fn merged(members: u64, shards: u64, last_first: bool) -> Statistics<generic::Planar<f64>> {
    let mut texts: Vec<String> = (0..shards)
        .map(|index| {
            let mut ensemble = planks(shard(members, index, shards));
            ensemble.cf4(0.0..1.0, 50);
            serde_json::to_string(&ensemble.statistics()).expect("numbers")
        })
        .collect();
    if last_first {
        texts.reverse();
    }
    let mut all = Statistics::new();
    for text in texts {
        all.merge(&serde_json::from_str(&text).expect("as written"));
    }
    all
}

#[test]
fn any_shards_give_the_same_bits() {
    let members = 333;
    let whole = merged(members, 1, false);
    let naive = |shards: u64| {
        let parts = (0..shards).map(|index| {
            let mut ensemble = planks(shard(members, index, shards));
            ensemble.cf4(0.0..1.0, 50);
            ensemble
                .states()
                .iter()
                .map(|state| state.position.x)
                .sum::<f64>()
        });
        parts.sum::<f64>()
    };
    // what a plain sum would give depends on the shards
    assert!(
        [2, 3, 7]
            .iter()
            .any(|shards| naive(*shards).to_bits() != naive(1).to_bits())
    );
    for shards in [2, 3, 7] {
        for last_first in [false, true] {
            let other = merged(members, shards, last_first);
            assert_eq!(other, whole);
            for (one, two) in other.columns().iter().zip(whole.columns()) {
                let bits = |moments: &Moments| {
                    [
                        moments.mean(),
                        moments.variance(),
                        moments.least(),
                        moments.greatest(),
                    ]
                    .map(|value| value.map(f64::to_bits))
                };
                assert_eq!(bits(one), bits(two));
            }
        }
    }
    assert_eq!(
        whole.columns().len(),
        <generic::Planar<f64> as Columns<f64>>::COUNT
    );
}

#[test]
fn any_threads_give_the_same_bits() {
    let values: Vec<Vector2<f64>> = numbers(8, 4000, 1..1800)
        .chunks(2)
        .map(|pair| Vector2::new(pair[0], pair[1]))
        .collect();
    let of = |threads: usize| {
        let parts = values.chunks(values.len().div_ceil(threads));
        let all = std::sync::Mutex::new(Statistics::<Vector2<f64>>::new());
        std::thread::scope(|scope| {
            for part in parts {
                let all = &all;
                scope.spawn(move || {
                    let own: Statistics<_> = part.iter().copied().collect();
                    all.lock().expect("no panic").merge(&own);
                });
            }
        });
        all.into_inner().expect("no panic")
    };
    let alone = of(1);
    for threads in [2, 3, 7] {
        assert_eq!(of(threads), alone);
    }
}

#[test]
fn impossible_moments_are_refused() {
    let moments: Moments = [1.0, 2.0].into_iter().collect();
    let written = serde_json::to_value(&moments).expect("numbers");
    let read = |change: &dyn Fn(&mut serde_json::Value)| {
        let mut changed = written.clone();
        change(&mut changed);
        serde_json::from_value::<Moments>(changed)
    };
    assert_eq!(read(&|_| {}).expect("as written"), moments);
    assert!(
        read(&|value| value["count"] = 1.into()).is_err(),
        "squares below the mean's"
    );
    assert!(read(&|value| value["count"] = 0.into()).is_err());
    assert!(read(&|value| value["extremes"] = serde_json::Value::Null).is_err());
    assert!(read(&|value| value["sum"]["first"] = u64::MAX.into()).is_err());
    assert!(read(&|value| value["sum"]["digits"][0] = (-1).into()).is_err());
    assert!(read(&|value| value["squares"]["digits"][0] = (1_u64 << 33).into()).is_err());
    let columns = serde_json::to_string(&[&moments, &moments, &moments]).expect("numbers");
    let wrong = serde_json::from_str::<Statistics<Vector2<f64>>>(&columns);
    let message = wrong.expect_err("three columns").to_string();
    assert!(message.starts_with("expected the moments of 2 columns, and there are 3"));
}
