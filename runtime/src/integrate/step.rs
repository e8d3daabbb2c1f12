//! A step as it was taken: the motion from its start to its end.

use crate::state::Coordinates;
use crate::taylor::{Axes, after};

/// How often the sign of a function is looked at within a step.
const SAMPLES: usize = 16;

/// A step of a motion, and the motion within it.
#[derive(Debug)]
pub struct Step<'m, S: Coordinates<Scalar = f64>> {
    start: f64,
    length: f64,
    axes: Axes,
    coefficients: &'m [S::Array],
}

/// A zero of a function of time and state along a motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Event<S> {
    /// \[s\]
    pub time: f64,
    /// The state then.
    pub state: S,
    /// Whether the function grows with time.
    pub rises: bool,
}

impl<'m, S: Coordinates<Scalar = f64>> Step<'m, S> {
    pub(super) fn new(start: f64, length: f64, axes: Axes, coefficients: &'m [S::Array]) -> Self {
        Self {
            start,
            length,
            axes,
            coefficients,
        }
    }

    /// When it began \[s\].
    #[must_use]
    pub fn start(&self) -> f64 {
        self.start
    }

    /// When it ended \[s\].
    #[must_use]
    pub fn end(&self) -> f64 {
        self.start + self.length
    }

    /// The state at a time \[s\] between start and end, of the same accuracy as the end.
    #[inline]
    #[must_use]
    pub fn at(&self, time: f64) -> S {
        let coordinates = after::<S>(self.coefficients, time - self.start);
        self.axes.state(&coordinates, time)
    }

    /// Where a function of time and state changes its sign within the step, in the order of the motion: the start does not count, the
    /// end does.
    ///
    /// The sign is looked at in 16 places; of zeros closer to each other than these, an even number is not seen. A zero is found to
    /// the rounding of the function and of time.
    pub fn zeros<F: Fn(f64, &S) -> f64>(&self, function: F) -> impl Iterator<Item = Event<S>> {
        let Self {
            start,
            length,
            axes,
            coefficients,
        } = *self;
        let place = move |k: usize| length * (super::exact(k) / super::exact(SAMPLES));
        let state = move |rest| axes.state::<S>(&after::<S>(coefficients, rest), start + rest);
        let value = move |after: f64| function(start + after, &state(after));
        let mut before = value(0.0);
        (0..SAMPLES).filter_map(move |k| {
            let (from, to) = (place(k), place(k + 1));
            let last = core::mem::replace(&mut before, value(to));
            let crosses = last != 0.0 && (before == 0.0 || (last < 0.0) != (before < 0.0));
            if !crosses || before.is_nan() || last.is_nan() {
                return None;
            }
            let after = bracketed(&value, [from, to], [last, before]);
            Some(Event {
                time: start + after,
                state: state(after),
                rises: (last < 0.0) == (length > 0.0),
            })
        })
    }
}

/// The zero of a function between two places where it has different signs, by the method ITP.
///
/// I. F. D. Oliveira, R. H. C. Takahashi, An enhancement of the bisection method average performance preserving minmax
/// optimality, ACM Transactions on Mathematical Software 47 (2020) 5: regula falsi, truncated and kept so near to the middle that
/// no more steps are taken than by bisection and one.
fn bracketed(
    value: impl Fn(f64) -> f64,
    [mut a, mut b]: [f64; 2],
    [mut of_a, mut of_b]: [f64; 2],
) -> f64 {
    if of_b == 0.0 {
        return b;
    }
    let width = (b - a).abs();
    let finest = 0.5 * f64::EPSILON * width;
    // what bisection would have left after so many steps, and one more
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
        if of_next == 0.0 || !is_between {
            return next;
        }
        if (of_next < 0.0) == (of_a < 0.0) {
            (a, of_a) = (next, of_next);
        } else {
            (b, of_b) = (next, of_next);
        }
    }
    0.5 * (a + b)
}
