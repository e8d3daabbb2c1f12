//! Times at which the equations of a body change.

use crate::numbers::scalar::Scalar;

/// A time is the same as another if they differ by less than this fraction of the terms that they
/// are computed from.
const ROUNDING: f64 = 4.0 * f64::EPSILON;

/// The times at which the equations of a body change, as
/// [`RigidBody::switches`](crate::body::RigidBody::switches) tells them. Of all that it is told, it
/// keeps what a step needs: which is next, and whether one is here.
#[derive(Clone, Copy, Debug)]
pub struct Switches {
    now: f64,
    forwards: bool,
    /// Of which of several numbers.
    lane: usize,
    pub(crate) stretch: Stretch,
}

impl Switches {
    pub(crate) fn new(now: f64, forwards: bool, lane: usize) -> Self {
        let next = if forwards {
            f64::INFINITY
        } else {
            f64::NEG_INFINITY
        };
        Self {
            now,
            forwards,
            lane,
            stretch: Stretch {
                next,
                ..Stretch::ALL
            },
        }
    }

    /// The equations before this time \[s\] are others than those after it. What is not finite is
    /// no time.
    pub fn at<T: Scalar>(&mut self, time: T) {
        self.put(time.lane(self.lane), 0.0);
    }

    /// The same, of a time that is rounded as terms of this size \[s\] are, from which it is
    /// computed.
    pub fn near<T: Scalar, S: Scalar>(&mut self, time: T, size: S) {
        self.put(time.lane(self.lane), size.lane(self.lane).abs());
    }

    /// At this time \[s\], and every so many seconds before and after.
    pub fn every<T: Scalar, S: Scalar>(&mut self, time: T, period: S) {
        let (time, period) = (time.lane(self.lane), period.lane(self.lane));
        let passed = libm::floor((self.now - time) / period);
        for count in [-1.0, 0.0, 1.0, 2.0] {
            let after = (passed + count) * period;
            self.put(time + after, time.abs() + after.abs());
        }
    }

    pub(crate) fn put(&mut self, time: f64, size: f64) {
        if !time.is_finite() {
            return;
        }
        let rounding = (ROUNDING * (time.abs() + size)).max(1e-300);
        let (before, after) = (time - rounding, time + rounding);
        let stretch = &mut self.stretch;
        if (time - self.now).abs() <= 2.0 * rounding {
            if self.forwards {
                stretch.lower = stretch.lower.max(after);
            } else {
                stretch.upper = stretch.upper.min(before);
            }
        } else if self.forwards && self.now < time && time < stretch.next {
            (stretch.next, stretch.upper) = (time, before);
        } else if !self.forwards && stretch.next < time && time < self.now {
            (stretch.next, stretch.lower) = (time, after);
        }
    }
}

/// A stretch of time in which the equations do not change.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stretch {
    /// Where it ends in the direction of the motion \[s\]; infinite if it does not.
    pub(crate) next: f64,
    /// Between which times they are evaluated, so that each stage of a step is on its own side of a
    /// switch, one that falls on it too.
    pub(crate) lower: f64,
    pub(crate) upper: f64,
    /// When the input was given.
    pub(crate) given: f64,
}

impl Stretch {
    /// All of time.
    pub(crate) const ALL: Self = Self {
        next: f64::INFINITY,
        lower: f64::NEG_INFINITY,
        upper: f64::INFINITY,
        given: 0.0,
    };
}
