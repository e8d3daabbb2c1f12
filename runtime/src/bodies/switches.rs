//! Times at which the equations of a body change.

use crate::numbers::scalar::Scalar;

/// Two times are equal if they differ by less than this fraction of the terms that they
/// are computed from.
const ROUNDING: f64 = 4.0 * f64::EPSILON;

/// The times at which the equations of a body change, as reported by
/// [`RigidBody::switches`](crate::body::RigidBody::switches). It keeps only what a step needs: the
/// next time, and whether one is now.
#[derive(Clone, Copy, Debug)]
pub struct Switches {
    now: f64,
    forwards: bool,
    /// The lane whose times these are.
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

    /// The equations before this time \[s\] differ from those after it. A non-finite time is
    /// ignored.
    pub fn at<T: Scalar>(&mut self, time: T) {
        self.put(time.lane(self.lane), 0.0);
    }

    /// Like [`at`](Self::at), for a time computed from terms of this size \[s\], and rounded
    /// accordingly.
    pub fn near<T: Scalar, S: Scalar>(&mut self, time: T, size: S) {
        self.put(time.lane(self.lane), size.lane(self.lane).abs());
    }

    /// The equations change at this time \[s\] and at every period before and after it.
    pub fn every<T: Scalar, S: Scalar>(&mut self, time: T, period: S) {
        let (time, period) = (time.lane(self.lane), period.lane(self.lane));
        let passed = libm::floor((self.now - time) / period);
        if passed.is_finite() {
            self.stretch.period = self.stretch.period.min(period.abs());
        }
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
    /// The end of the stretch in the direction of the motion \[s\]; infinite if it has none.
    pub(crate) next: f64,
    /// The time range of evaluations: each stage of a step, including one that falls on a switch,
    /// is evaluated on its own side of the switch.
    pub(crate) lower: f64,
    pub(crate) upper: f64,
    /// The time at which the input was given.
    pub(crate) given: f64,
    /// The shortest period of conditions on time \[s\]; infinite if none has a period.
    pub(crate) period: f64,
}

impl Stretch {
    /// All of time.
    pub(crate) const ALL: Self = Self {
        next: f64::INFINITY,
        lower: f64::NEG_INFINITY,
        upper: f64::INFINITY,
        given: 0.0,
        period: f64::INFINITY,
    };

    /// A stretch that is over now, under an input that is given now.
    pub(crate) fn until_now(now: f64) -> Self {
        Self {
            next: now,
            given: now,
            ..Self::ALL
        }
    }

    /// All of time, under an input that is given at a time \[s\].
    pub(crate) fn since(given: f64) -> Self {
        Self { given, ..Self::ALL }
    }
}
