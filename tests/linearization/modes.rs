//! Modes of matrices with known eigenvalues.

use nalgebra::{Complex, SMatrix};
use newton_euler::linearization::{Linearized, Modes};

struct Known<const N: usize>(SMatrix<f64, N, N>);

impl<const N: usize> Linearized<N, 0> for Known<N> {
    const STATES: [&'static str; N] = [""; N];
    const INPUTS: [&'static str; 0] = [];
    const A_PATTERN: [[bool; N]; N] = [[true; N]; N];
    const B_PATTERN: [[bool; 0]; N] = [[]; N];

    fn a(&self) -> SMatrix<f64, N, N> {
        self.0
    }

    fn b(&self) -> SMatrix<f64, N, 0> {
        SMatrix::zeros()
    }
}

/// Numbers between -1 and 1, always the same.
fn numbers(mut seed: u64) -> impl FnMut() -> f64 {
    move || {
        seed = seed
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        f64::from((seed >> 33) as u32) / f64::from(1_u32 << 30) - 1.0
    }
}

fn hold<const N: usize>(modes: &Modes<N>, mut expected: Vec<Complex<f64>>, bound: f64) {
    assert_eq!(modes.len() - modes.neutral(), expected.len(), "{modes:?}");
    for mode in modes.iter().filter(|mode| !mode.is_neutral) {
        let near = |value: &Complex<f64>| (value - mode.eigenvalue).norm();
        let found =
            (0..expected.len()).min_by(|a, b| near(&expected[*a]).total_cmp(&near(&expected[*b])));
        let value = expected.remove(found.expect("there are as many"));
        assert!(
            near(&value) <= bound * value.norm(),
            "{value} {}",
            mode.eigenvalue
        );
    }
}

#[test]
fn eigenvalues_are_those_that_were_put_in() {
    for seed in 0..300 {
        let mut number = numbers(seed);
        let mut d = SMatrix::<f64, 12, 12>::zeros();
        let mut expected = Vec::new();
        // three zeros, one of them in a chain of two; scales apart
        d[(0, 1)] = 1.0;
        let scale = 10_f64.powf(3.0 * number());
        for place in (4..12).step_by(2) {
            let [re, im] = [number() * scale, number() * scale];
            if number() > 0.0 {
                d[(place, place)] = re;
                d[(place + 1, place + 1)] = im;
                expected.extend([Complex::new(re, 0.0), Complex::new(im, 0.0)]);
            } else {
                for (row, column, entry) in [(0, 0, re), (1, 1, re), (0, 1, im), (1, 0, -im)] {
                    d[(place + row, place + column)] = entry;
                }
                expected.push(Complex::new(re, im.abs()));
            }
        }
        d[(3, 3)] = scale;
        expected.push(Complex::new(scale, 0.0));
        let p = SMatrix::<f64, 12, 12>::from_fn(|i, j| number() + if i == j { 4.0 } else { 0.0 });
        let inverse = p.try_inverse().expect("it is regular");
        let modes = Known(p * d * inverse).modes().expect("it converges");
        assert_eq!(modes.neutral(), 3, "{seed} {modes:?}");
        hold(&modes, expected, 1e-9);
    }
}

#[test]
fn a_train_without_brakes() {
    // six cars on springs: rates of zero that are a chain of two, and 2 w sin(k pi / 12)
    let mut a = SMatrix::<f64, 12, 12>::zeros();
    for car in 0..6_usize {
        a[(car, car + 6)] = 1.0;
        for other in [car.wrapping_sub(1), car + 1] {
            if other < 6 {
                a[(car + 6, car)] -= 1e8;
                a[(car + 6, other)] += 1e8;
            }
        }
    }
    let modes = Known(a).modes().expect("it converges");
    assert_eq!(modes.neutral(), 2, "{modes:?}");
    let expected = (1..6).map(|k| {
        let angle = f64::from(k) * core::f64::consts::PI / 12.0;
        Complex::new(0.0, 2e4 * angle.sin())
    });
    hold(&modes, expected.collect(), 1e-13);
}

#[test]
fn what_shifts_do_not_move() {
    // permutations: eigenvalues on the unit circle, on which double shifts may turn for ever
    macro_rules! cycles {
        ($($n:literal)*) => {$({
            let a = SMatrix::<f64, $n, $n>::from_fn(|i, j| f64::from(u8::from((i + 1) % $n == j)));
            let modes = Known(a).modes().expect("it converges");
            let expected = (0..$n).map(|k| core::f64::consts::TAU * f64::from(k) / f64::from($n));
            let expected = expected.map(|angle| Complex::new(angle.cos(), angle.sin()));
            let above = expected.filter(|value| value.im > -1e-12);
            hold(&modes, above.collect(), 1e-13);
        })*};
    }
    cycles!(2 3 4 5 6 8 12);
}

#[test]
fn what_is_no_number_has_no_modes() {
    for value in [f64::NAN, f64::INFINITY] {
        let mut a = SMatrix::<f64, 4, 4>::identity();
        a[(1, 2)] = value;
        assert!(Known(a).modes().is_none());
    }
    let modes = Known(SMatrix::<f64, 4, 4>::zeros()).modes().expect("zeros");
    assert_eq!((modes.len(), modes.neutral()), (4, 4));
    let large = SMatrix::<f64, 4, 4>::from_diagonal_element(-1e300);
    assert!(Known(large).modes().expect("it is finite").is_stable());
}

/// `x'' = -k x - c x'` for some oscillators, in axes that are not those of the oscillators.
fn mixed<const N: usize>(oscillators: &[[f64; 2]], seed: u64) -> SMatrix<f64, N, N> {
    let mut a = SMatrix::<f64, N, N>::zeros();
    for (number, [k, c]) in oscillators.iter().enumerate() {
        let (at, rate) = (2 * number, 2 * number + 1);
        a[(at, rate)] = 1.0;
        (a[(rate, at)], a[(rate, rate)]) = (-k, -c);
    }
    let mut number = numbers(seed);
    let p = SMatrix::<f64, N, N>::from_fn(|i, j| number() + if i == j { 3.0 } else { 0.0 });
    p * a * p.try_inverse().expect("it is regular")
}

#[test]
fn undamped_oscillations_neither_grow_nor_decay() {
    for seed in 0..100 {
        let modes = Known(mixed::<6>(&[[9.0, 0.0], [4.0, 0.0], [1e4, 0.0]], seed)).modes();
        let modes = modes.expect("it converges");
        assert_eq!((modes.len(), modes.neutral()), (3, 0));
        for mode in modes.iter() {
            assert_eq!(mode.eigenvalue.re, 0.0);
            assert_eq!(mode.damping_ratio(), 0.0);
            assert_eq!((mode.time_to_half(), mode.time_to_double()), (None, None));
        }
        assert!(!modes.is_stable());
    }
}

#[test]
fn weak_damping_is_seen() {
    // beside rounding, at the frequency of an undamped mode, critical, and repeated
    for seed in 0..100 {
        for [k, c] in [[9.0, 1e-9], [4.0, 1e-8], [4.0, 4.0], [4.0, -1e-8]] {
            let a = mixed::<6>(&[[4.0, 0.0], [k, c], [k, c]], seed);
            let modes = Known(a).modes().expect("it converges");
            let rates = modes.iter().map(|mode| mode.eigenvalue.re);
            let still = rates.clone().filter(|rate| *rate == 0.0).count();
            assert_eq!(still, 1, "{seed} {k} {c}: {modes:?}");
            assert!(
                rates
                    .clone()
                    .all(|rate| rate == 0.0 || (rate < 0.0) == (c > 0.0))
            );
            let a = mixed::<4>(&[[k, c], [k, c]], seed);
            let modes = Known(a).modes().expect("it converges");
            assert_eq!(modes.is_stable(), c > 0.0, "{seed} {k} {c}: {modes:?}");
        }
    }
}

#[test]
fn critical_modes_are_all_there() {
    // a mount in the plane, x'' = -k x - c x': each direction has a double root, which decays in
    // one case and grows in the other
    for [first, second] in [[2.5, 2.0], [3.0, 2.8], [1.8, 3.7], [4.3, 2.5]] {
        for sign in [1.0, -1.0] {
            let mut a = SMatrix::<f64, 4, 4>::zeros();
            for (place, rate) in [first, sign * second].into_iter().enumerate() {
                a[(place, place + 2)] = 1.0;
                a[(place + 2, place)] = -rate * rate;
                a[(place + 2, place + 2)] = -2.0 * rate;
            }
            let modes = Known(a).modes().expect("it converges");
            let count: usize = (modes.iter())
                .map(|mode| 1 + usize::from(mode.period().is_some()))
                .sum();
            assert_eq!(count, 4, "{first} {second} {sign}: {modes:?}");
            let sum: f64 = (modes.iter())
                .map(|mode| mode.eigenvalue.re * (1.0 + f64::from(mode.eigenvalue.im > 0.0)))
                .sum();
            assert!((sum + 2.0 * (first + sign * second)).abs() < 1e-12);
            assert_eq!(modes.is_stable(), sign > 0.0, "{first} {second}: {modes:?}");
        }
    }
}
