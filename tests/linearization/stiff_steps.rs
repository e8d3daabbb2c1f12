//! Steps of stiff motions by the exponential, compared with numbers in 60 digits.

use nalgebra::{SMatrix, matrix, vector};
use newton_euler::linearization::Linearized;

/// `x'' = -k x - c x' + u`
struct Oscillator {
    k: f64,
    c: f64,
}

impl Linearized<2, 1> for Oscillator {
    const STATES: [&'static str; 2] = ["x", "v"];
    const INPUTS: [&'static str; 1] = ["u"];
    const A_PATTERN: [[bool; 2]; 2] = [[false, true], [true; 2]];
    const B_PATTERN: [[bool; 1]; 2] = [[false], [true]];

    fn a(&self) -> SMatrix<f64, 2, 2> {
        matrix![0.0, 1.0; -self.k, -self.c]
    }

    fn b(&self) -> SMatrix<f64, 2, 1> {
        vector![0.0, 1.0]
    }
}

/// k, c, the step, P by rows and Q, from mpmath: `expm` of the exact matrix in 60 digits.
#[rustfmt::skip]
#[allow(clippy::unreadable_literal, reason = "printed by a program")]
const KNOWN: [[f64; 9]; 5] = [
    [1000000000.0, 1.0, 1.0, 0.5337080873077602, -9.112093914985723e-06, 9112.093914985722, 0.5337171994016752, 4.662919126922398e-10, -9.112093914985723e-06],
    [1000000000000.0, 0.001, 1.0, 0.936283868368928, -3.498185491622215e-07, 349818.5491622215, 0.9362838687187465, 6.371613163107208e-14, -3.498185491622215e-07],
    [1000000000.0, 1.0, 0.001, 0.9781967240281575, 6.491380344806741e-06, -6491.380344806741, 0.9781902326478127, 2.1803275971842455e-11, 6.491380344806741e-06],
    [1000000.0, 2000.0, 0.01, 0.0004993992273873332, 4.5399929762484843e-07, -0.4539992976248484, -0.0004085993678623636, 9.995006007726126e-07, 4.5399929762484843e-07],
    [1e-08, 1e-09, 1000.0, 0.995004166943026, 998.3336673013647, -9.983336673013647e-06, 0.9950031686093587, 499583.3056974055, 998.3336673013647],
];

#[test]
fn stiff_steps_are_exact_to_the_rounding_of_their_phase() {
    for [k, c, step, a, b, d, e, f, g] in KNOWN {
        let (p, q) = Oscillator { k, c }.discretized(step);
        let phase = (k.sqrt() * step).max(1.0);
        let bound = 10.0 * f64::EPSILON * phase;
        // entries of one kind: x by x and v by v, x by v, v by x, and those of the input
        let rate = k.sqrt();
        let found = [
            (p[(0, 0)], a, 1.0),
            (p[(0, 1)], b, 1.0 / rate),
            (p[(1, 0)], d, rate),
            (p[(1, 1)], e, 1.0),
            (q[0], f, 1.0 / k),
            (q[1], g, 1.0 / rate),
        ];
        for (entry, expected, size) in found {
            let error = (entry - expected).abs() / size;
            assert!(
                error < bound,
                "{k} {c} {step}: {entry} is {expected}, {error}"
            );
        }
    }
}

#[test]
fn what_is_no_number_has_no_step() {
    for k in [f64::NAN, f64::INFINITY] {
        let (p, q) = Oscillator { k, c: 1.0 }.discretized(1e-3);
        assert!(p.iter().chain(q.iter()).all(|entry| entry.is_nan()));
    }
    let (p, _) = Oscillator { k: -1e9, c: 0.0 }.discretized(1.0);
    assert!(p.iter().any(|entry| !entry.is_finite()));
}
