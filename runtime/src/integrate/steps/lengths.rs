//! The control of step lengths by the errors of steps, for one motion or several at once.

use super::size::near_root;
#[cfg(feature = "ensemble")]
use crate::numbers::lanes::{Lanes, Register};
use crate::numbers::scalar::{Scalar, number};

/// The fraction of the step that the last error permits, and the bounds of its change.
const SAFETY: f64 = 0.9;
const SHRINK: f64 = 1.0 / 3.0;
const GROW: f64 = 6.0;

/// The control of step lengths.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Lengths<T> {
    /// The permitted length of the next step \[s\].
    permitted: T,
    /// The largest permitted growth.
    longest: T,
    /// The error of the last attempt, zero if it was accepted.
    error: T,
}

/// Begins with a step \[s\].
impl<T: Scalar> From<T> for Lengths<T> {
    #[cfg_attr(not(unoptimized), inline(always))]
    fn from(step: T) -> Self {
        Self {
            permitted: step,
            longest: number(step, GROW),
            error: number(step, 0.0),
        }
    }
}

impl<T: Scalar> Lengths<T> {
    /// One of two, number by number.
    #[cfg(feature = "ensemble")]
    #[cfg_attr(not(unoptimized), inline(always))]
    pub(crate) fn select(truth: T::Truth, first: Self, second: Self) -> Self {
        Self {
            permitted: T::select(truth, first.permitted, second.permitted),
            longest: T::select(truth, first.longest, second.longest),
            error: T::select(truth, first.error, second.error),
        }
    }

    /// Those of one lane.
    #[cfg(feature = "ensemble")]
    pub(crate) fn of_lane(&self, lane: usize) -> Lengths<f64> {
        Lengths {
            permitted: self.permitted.lane(lane),
            longest: self.longest.lane(lane),
            error: self.error.lane(lane),
        }
    }

    pub(in crate::integrate) fn error(&self) -> T {
        self.error
    }

    /// The next step \[s\] for a given remaining time, and whether it covers all of that.
    #[cfg_attr(not(unoptimized), inline(always))]
    pub(crate) fn next(&self, rest: T) -> (T, T::Truth) {
        let is_last = rest.abs().less_or_equal(self.permitted);
        let is_backwards = rest.less(number(rest, 0.0));
        let step = T::select(is_backwards, -self.permitted, self.permitted);
        (T::select(is_last, rest, step), is_last)
    }

    /// Whether a step is accepted with this error, which permits this share of it; also sets the
    /// length of the next step.
    #[cfg_attr(not(unoptimized), inline(always))]
    pub(crate) fn is_accepted(
        &mut self,
        (step, is_last): (T, T::Truth),
        (error, share): (T, T),
        tolerance: T,
    ) -> T::Truth {
        let is_accepted = error.less_or_equal(tolerance);
        let share = T::select(self.longest.less(share), self.longest, share);
        let next = step.abs() * share;
        // a step cut short at the end says little about the next
        let keeps = is_accepted & is_last & next.less(self.permitted);
        let (zero, one) = (number(step, 0.0), number(step, 1.0));
        *self = Self {
            permitted: T::select(keeps, self.permitted, next),
            longest: T::select(is_accepted, number(step, GROW), one),
            error: T::select(is_accepted, zero, error),
        };
        is_accepted
    }
}

#[cfg(feature = "ensemble")]
impl<S: Register> Lengths<Lanes<S>> {
    /// Replaces those of one lane.
    pub(crate) fn put(&mut self, lane: usize, lengths: &Lengths<f64>) {
        self.permitted.put(lane, lengths.permitted);
        self.longest.put(lane, lengths.longest);
        self.error.put(lane, lengths.error);
    }
}

/// The share of a step that its error permits, for an error of order k; for NaN the smallest.
#[cfg_attr(not(unoptimized), inline(always))]
pub(crate) fn shrunk(tolerance: f64, error: f64, k: usize) -> f64 {
    // no branch and no division: in lanes it is computed for all at once
    let share = SAFETY * near_root(tolerance, error, k);
    let share = if error > 0.0 { share } else { GROW };
    let is_long = share > SHRINK && error < f64::INFINITY && tolerance > 0.0;
    if is_long { share } else { SHRINK }
}

/// The error of a step by the sizes of its differences to methods of orders 5 and 3.
#[cfg_attr(not(unoptimized), inline(always))]
pub(in crate::integrate) fn combined<T: Scalar>(first: T, second: T) -> T {
    let squares = first * first + number(first, 0.01) * second * second;
    let error = first * (first / squares.sqrt());
    let is_normal = number(first, f64::MIN_POSITIVE).less_or_equal(squares)
        & squares.less_or_equal(number(first, f64::MAX));
    if T::agreed(is_normal) == Some(true) {
        return error;
    }
    // the squares are out of range
    let (zero, infinite) = (number(first, 0.0), number(first, f64::INFINITY));
    let scaled = first * (first / first.hypot(number(first, 0.1) * second));
    let scaled = T::select((first + second).equal(infinite), infinite, scaled);
    let scaled = T::select(first.equal(zero), zero, scaled);
    T::select(is_normal, error, scaled)
}
