//! Zeros of a function of time and state along a motion.

use core::ops::Range;

use super::error::IntegrationError;
use crate::numbers::count::real;

/// A zero of a function of time and state along a motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Event<S> {
    /// \[s\]
    pub time: f64,
    /// The state at that time.
    pub state: S,
    /// Whether the function increases with time.
    pub rises: bool,
}

/// A search for zeros within one step, in the order of the motion, excluding the start and
/// including the end.
///
/// The sign is evaluated at several points. An even number of zeros between two such points
/// is missed. Zeros are found to the rounding of the function and of time. A NaN value
/// ends the search with an error.
#[derive(Clone, Copy, Debug)]
pub(in crate::integrate) struct Search {
    start: f64,
    end: f64,
    places: usize,
    /// The number of evaluated points, and the value at the last of them.
    seen: usize,
    before: f64,
}

impl Search {
    /// A search in a step, from the value of the function at its start.
    pub(in crate::integrate) fn new(times: Range<f64>, places: usize, value: f64) -> Self {
        Self {
            start: times.start,
            end: times.end,
            places,
            seen: 0,
            before: value,
        }
    }

    /// The next zero, of a function of time and state along the states of a step.
    pub(in crate::integrate) fn next<S>(
        &mut self,
        state: impl Fn(f64) -> S,
        function: impl Fn(f64, &S) -> f64,
    ) -> Option<Result<Event<S>, IntegrationError<S>>> {
        let Self { start, end, .. } = *self;
        let length = end - start;
        let place = |k: usize| length * (real(k) / real(self.places));
        // the last place is the end to the bit: there the next step begins
        let time = |after: f64| {
            let time = start + after;
            if after == length {
                end
            } else if length > 0.0 {
                time.min(end)
            } else {
                time.max(end)
            }
        };
        let value = |after: f64| function(time(after), &state(time(after)));
        while self.seen < self.places {
            let [from, to] = [place(self.seen), place(self.seen + 1)];
            let (last, next) = (self.before, value(to));
            self.seen += 1;
            self.before = next;
            let crosses = last != 0.0 && (next == 0.0 || (last < 0.0) != (next < 0.0));
            let found = if last.is_nan() {
                Err(from)
            } else if next.is_nan() {
                Err(to)
            } else if crosses {
                bracketed(value, [from, to], [last, next])
            } else {
                continue;
            };
            let (Ok(after) | Err(after)) = found;
            let (time, state) = (time(after), state(time(after)));
            if found.is_err() {
                self.seen = self.places;
                return Some(Err(IntegrationError::EventNotANumber { time, state }));
            }
            let rises = (last < 0.0) == (length > 0.0);
            return Some(Ok(Event { time, state, rises }));
        }
        None
    }
}

/// The zero of a function between two points with different signs, by the method ITP.
///
/// I. F. D. Oliveira, R. H. C. Takahashi, An enhancement of the bisection method average
/// performance preserving minmax optimality, ACM Transactions on Mathematical Software 47 (2020) 5:
/// regula falsi, truncated and kept so near to the middle that it takes at most one step more than
/// bisection. If the function is NaN at a point, that point is the error.
fn bracketed(
    value: impl Fn(f64) -> f64,
    [mut a, mut b]: [f64; 2],
    [mut of_a, mut of_b]: [f64; 2],
) -> Result<f64, f64> {
    let width = (b - a).abs();
    let finest = 0.5 * f64::EPSILON * width;
    if of_b == 0.0 {
        return first_zero(value, [a, b], of_a, finest);
    }
    // the width that bisection would have left after as many steps, and one more
    let mut permitted = width;
    while (b - a).abs() > 2.0 * finest {
        let (middle, half) = (0.5 * (a + b), 0.5 * (b - a));
        let secant = (of_b * a - of_a * b) / (of_b - of_a);
        let side = 1.0_f64.copysign(middle - secant);
        let truncation = 0.2 / width * (b - a) * (b - a);
        let truncated = if truncation <= (middle - secant).abs() {
            secant + side * truncation
        } else {
            middle
        };
        let reach = (permitted - half.abs()).max(0.0);
        let next = if (truncated - middle).abs() <= reach {
            truncated
        } else {
            middle - side * reach
        };
        permitted *= 0.5;
        let of_next = value(next);
        let is_between = a.min(b) < next && next < a.max(b);
        if of_next.is_nan() {
            return Err(next);
        }
        if !is_between {
            return Ok(next);
        }
        if of_next == 0.0 {
            return first_zero(value, [a, next], of_a, finest);
        }
        if (of_next < 0.0) == (of_a < 0.0) {
            (a, of_a) = (next, of_next);
        } else {
            (b, of_b) = (next, of_next);
        }
    }
    Ok(0.5 * (a + b))
}

/// The start of the zero of a function that is zero at b, perhaps long before, and not at a.
fn first_zero(
    value: impl Fn(f64) -> f64,
    [mut a, mut b]: [f64; 2],
    of_a: f64,
    finest: f64,
) -> Result<f64, f64> {
    while (b - a).abs() > 2.0 * finest {
        let middle = 0.5 * (a + b);
        if middle == a || middle == b {
            break;
        }
        let there = value(middle);
        if there.is_nan() {
            return Err(middle);
        }
        if there != 0.0 && (there < 0.0) == (of_a < 0.0) {
            a = middle;
        } else {
            b = middle;
        }
    }
    Ok(b)
}
