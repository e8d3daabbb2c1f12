//! A Runge–Kutta step over a place where a motion has no series, as a polynomial.

use crate::integrate::methods::adaptive::attempt;
use crate::integrate::methods::runge_kutta::{DormandPrince8, Embedded as _, moved};
use crate::integrate::steps::agreement::Agreement;
use crate::integrate::steps::equations::Rates;
use crate::integrate::steps::lengths::shrunk;
use crate::integrate::steps::point::Point;
use crate::state::Coordinates;

/// Coefficients of the polynomial.
pub(super) const ROWS: usize = 8;

/// The polynomial of degree 7 that matches the states and rates of a motion at 0, 1/3, 2/3 and 1 of
/// a step. The rows give its coefficients from 2 on by the changes until the last three points, and
/// the changes that the rates there would make, each minus the contribution of the initial rate.
const HERMITE: [[f64; 6]; 6] = [
    [0.0, -27.0, 60.75, -13.5, 12.0, -1.0],
    [243.0, 216.0, -546.75, 128.25, -119.0, 10.0],
    [-1215.0, -654.75, 1822.5, -459.0, 450.0, -38.25],
    [2247.75, 951.75, -2794.5, 769.5, -807.75, 69.75],
    [-1822.5, -668.25, 2004.75, -607.5, 688.5, -60.75],
    [546.75, 182.25, -546.75, 182.25, -222.75, 20.25],
];

/// A step, its increment of the coordinates, and its polynomial.
pub(super) struct Crossing<A> {
    pub(super) step: f64,
    pub(super) change: A,
    pub(super) coefficients: [A; ROWS],
}

/// A step of DOP853 of at most `longest` \[s\], which has a sign, and at least `least`, with an
/// error below the tolerance and a polynomial that agrees with the equations. With `is_last`, the
/// time remaining to the end may be lost in rounding.
pub(super) fn cross<E: Rates<State: Coordinates<Scalar = f64>>>(
    equations: &E,
    now: &Point<E::State>,
    (longest, is_last): (f64, bool),
    least: f64,
    tolerance: f64,
) -> Option<Crossing<<E::State as Coordinates>::Array>> {
    let (start, mut step) = (now.time, longest);
    let is_lost = |step: f64| (start + step) - start == 0.0 && !(is_last && step == longest);
    while step.abs() >= least && !is_lost(step) {
        let (mut change, error) =
            attempt::<DormandPrince8, _, _>(equations, start, &now.coordinates, step);
        if error > tolerance || error.is_nan() {
            step *= shrunk(tolerance, error, DormandPrince8::ESTIMATE);
            continue;
        }
        if now.moved(&mut change).is_some() {
            let coefficients = polynomial(equations, now, step, &change);
            let agreement = Agreement {
                equations,
                start,
                coefficients: &coefficients,
                tolerance,
            };
            if agreement.holds_throughout(now, step).is_ok() {
                return Some(Crossing {
                    step,
                    change,
                    coefficients,
                });
            }
        }
        step *= 0.5;
    }
    None
}

/// The polynomial of a step.
fn polynomial<E: Rates<State: Coordinates<Scalar = f64>>>(
    equations: &E,
    now: &Point<E::State>,
    step: f64,
    change: &<E::State as Coordinates>::Array,
) -> [<E::State as Coordinates>::Array; ROWS] {
    type Array<E> = <<E as Rates>::State as Coordinates>::Array;
    let (time, start) = (now.time, &now.coordinates);
    let first = equations.rates(time, start);
    // change and rate beyond those of the initial rate, at a fraction of the step
    let beyond = |part: f64, change: &Array<E>| {
        let end = moved::<E::State, _>(start, 1.0, [(1.0, change)]);
        let (mut change, mut rates) = (*change, equations.rates(time + part * step, &end));
        for (place, rate) in first.as_ref().iter().enumerate() {
            change.as_mut()[place] -= part * step * rate;
            rates.as_mut()[place] = step * (rates.as_ref()[place] - rate);
        }
        [change, rates]
    };
    let part = |part: f64| {
        let (mut change, _) = DormandPrince8::sums(equations, time, start, part * step);
        E::State::keep(start, &mut change);
        beyond(part, &change)
    };
    let [[a, b], [c, d]] = [part(1.0 / 3.0), part(2.0 / 3.0)];
    let [e, f] = beyond(1.0, change);
    let mut coefficients = [*start; ROWS];
    coefficients[1] = first;
    let mut unit = 1.0 / step;
    for (row, weights) in coefficients[2..].iter_mut().zip(HERMITE) {
        unit /= step;
        let [p, q, r, s, t, u] = weights.map(|weight| weight * unit);
        *row = Array::<E>::default();
        *row = moved::<E::State, _>(
            row,
            1.0,
            [(p, &a), (q, &b), (r, &c), (s, &d), (t, &e), (u, &f)],
        );
    }
    coefficients
}
