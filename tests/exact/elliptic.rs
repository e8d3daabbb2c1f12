//! Elliptic functions and the integral of the third kind, compared with identities that their
//! algorithms do not use.
#![allow(clippy::float_cmp, reason = "what is exact is compared exactly")]

use newton_euler::exact::{Elliptic, Jacobi, r_j};

const COMPLEMENTS: [f64; 9] = [1.0, 0.999_999, 0.9, 0.5, 0.1, 1e-3, 1e-8, 1e-100, 1e-300];

fn near(a: f64, b: f64, tolerance: f64) -> bool {
    (a - b).abs() <= tolerance * b.abs()
}

#[test]
fn squares() {
    for complement in COMPLEMENTS {
        let functions = Jacobi::new(complement);
        for part in -40..=40 {
            let u = functions.quarter_period() * f64::from(part) / 13.0;
            let Elliptic { sn, cn, dn } = functions.at(u);
            assert!(near(sn * sn + cn * cn, 1.0, 1e-15));
            let square = (complement * sn).powi(2) + cn * cn;
            assert!(near(dn * dn, square, 4e-15), "k' = {complement}, u = {u}");
        }
    }
}

/// Half way to a quarter period, and at it.
#[test]
fn special_arguments() {
    for complement in COMPLEMENTS {
        let functions = Jacobi::new(complement);
        let quarter = functions.quarter_period();
        let middle = functions.at(0.5 * quarter);
        let root = f64::sqrt(1.0 + complement);
        // phases of size K are known to its rounding
        let rounding = 4e-16 * (1.0 + quarter);
        assert!(near(middle.sn, 1.0 / root, rounding));
        assert!(near(middle.cn, complement.sqrt() / root, rounding));
        assert!(near(middle.dn, complement.sqrt(), rounding));
        let end = functions.at(quarter);
        assert!(near(end.sn, 1.0, 1e-15) && near(end.dn, complement, rounding));
        assert_eq!(
            functions.at(0.0),
            Elliptic {
                sn: 0.0,
                cn: 1.0,
                dn: 1.0
            }
        );
    }
}

/// `sn' = cn dn`, `cn' = -sn dn`, `dn' = -k² sn cn`, by differences of order four.
#[test]
fn derivatives() {
    for complement in [1.0, 0.8, 0.3, 1e-2, 1e-6, 0.0] {
        let functions = Jacobi::new(complement);
        for part in -20..=20 {
            let u = 0.37 * f64::from(part);
            let step = 1e-3;
            let slope = |function: fn(Elliptic) -> f64| {
                let at = |steps: f64| function(functions.at(u + steps * step));
                (8.0 * (at(1.0) - at(-1.0)) - (at(2.0) - at(-2.0))) / (12.0 * step)
            };
            let Elliptic { sn, cn, dn } = functions.at(u);
            let square = 1.0 - complement * complement;
            assert!((slope(|values| values.sn) - cn * dn).abs() < 3e-12);
            assert!((slope(|values| values.cn) + sn * dn).abs() < 3e-12);
            assert!((slope(|values| values.dn) + square * sn * cn).abs() < 3e-12);
        }
    }
}

/// Where k = 1, hyperbolic functions; near it, they up to k'².
#[test]
fn without_a_period() {
    let functions = Jacobi::new(0.0);
    assert_eq!(functions.quarter_period(), f64::INFINITY);
    for u in [-700.0, -3.0, 1e-9, 0.5, 20.0_f64] {
        let Elliptic { sn, cn, dn } = functions.at(u);
        assert!(near(sn, u.tanh(), 1e-15) && near(cn, 1.0 / u.cosh(), 1e-15) && cn == dn);
        let nearly = Jacobi::new(1e-200).at(u.clamp(-200.0, 200.0));
        assert!(near(nearly.dn, 1.0 / u.clamp(-200.0, 200.0).cosh(), 1e-13));
    }
}

/// Values of Carlson (1995), and closed forms of equal arguments.
#[test]
fn the_third_kind() {
    let published = [
        ([0.0, 1.0, 2.0, 3.0], 0.776_886_237_785_823_3),
        ([2.0, 3.0, 4.0, 5.0], 0.142_975_796_671_567_54),
    ];
    for ([x, y, z, p], value) in published {
        assert!(near(r_j(x, y, z, p), value, 4e-16));
    }
    for x in [1e-60, 1e-3, 1.0, 7.0, 1e60_f64] {
        assert!(near(r_j(x, x, x, x), x.powf(-1.5), 1e-14));
        // R_J(x, x, x, p) = 3 (R_C(x, p) - 1/√x)/(x - p), with R_C(x, p) = atan(√(p/x - 1))/√(p - x)
        let p = 3.0 * x;
        let circular = f64::atan(f64::sqrt(2.0)) / f64::sqrt(2.0 * x);
        let expected = 3.0 * (1.0 / x.sqrt() - circular) / (p - x);
        assert!(near(r_j(x, x, x, p), expected, 4e-15));
    }
    for [x, y, z, p] in [
        [0.0, 0.0, 1.0, 2.0],
        [1.0, 0.0, 0.0, 2.0],
        [1.0, 2.0, 3.0, 0.0],
    ] {
        assert_eq!(r_j(x, y, z, p), f64::INFINITY);
    }
    // p below the others: R_C is hyperbolic
    let p = 0.25_f64;
    let hyperbolic = f64::atanh(f64::sqrt(1.0 - p)) / f64::sqrt(1.0 - p);
    assert!(near(
        r_j(1.0, 1.0, 1.0, p),
        3.0 * (hyperbolic - 1.0) / (1.0 - p),
        4e-15
    ));
}

/// By the double exponential rule on the half line, `t = exp((3/2) sinh s)`.
#[test]
fn the_integral_that_defines_it() {
    for [x, y, z, p] in [
        [0.1, 0.5, 1.0, 1.3],
        [1.0, 0.2, 3.0, 0.4],
        [0.7, 0.8, 0.9, 5.0],
    ] {
        let integrand = |t: f64| {
            let product: f64 = (t + x) * (t + y) * (t + z);
            1.5 / ((t + p) * product.sqrt())
        };
        let step = 1.0 / 64.0;
        let sum: f64 = (-600..=600)
            .map(|k| {
                let s = f64::from(k) * step;
                let t = f64::exp(1.5 * s.sinh());
                integrand(t) * t * 1.5 * s.cosh() * step
            })
            .filter(|term| term.is_finite())
            .sum();
        assert!(
            near(r_j(x, y, z, p), sum, 1e-14),
            "{} {sum}",
            r_j(x, y, z, p)
        );
    }
}
