//! The current point of a motion.

use super::error::IntegrationError;
use crate::numbers::scalar::Scalar;
use crate::state::Coordinates;

/// A time and a state that accumulate increments, with their rounding errors: over long
/// runs rounding grows with the square root of the number of steps instead of the number (W.
/// Kahan, Comm. ACM 8 (1965) 40).
pub(crate) struct Point<S: Coordinates<Scalar = f64>> {
    pub(crate) time: f64,
    pub(crate) coordinates: S::Array,
    /// The rounding error of the time, to be added to it.
    pub(crate) late: f64,
    pub(crate) lost: S::Array,
}

impl<S: Coordinates<Scalar = f64>> Point<S> {
    pub(in crate::integrate) fn new(time: f64, state: &S) -> Self {
        Self {
            time,
            coordinates: state.coordinates(),
            late: 0.0,
            lost: S::Array::default(),
        }
    }

    pub(in crate::integrate) fn state(&self) -> S {
        S::from_coordinates(&self.coordinates)
    }

    /// Another state at the same time.
    pub(in crate::integrate) fn replace(&mut self, state: &S) {
        self.coordinates = state.coordinates();
        self.lost = S::Array::default();
    }

    /// The time remaining until another.
    #[cfg_attr(not(unoptimized), inline(always))]
    pub(in crate::integrate) fn rest(&self, end: f64) -> f64 {
        (end - self.time) - self.late
    }

    /// The point after an increment, which is corrected; none if it is not finite.
    #[cfg_attr(not(unoptimized), inline(always))]
    pub(in crate::integrate) fn moved(&self, change: &mut S::Array) -> Option<S::Array> {
        S::keep(&self.coordinates, change);
        let (mut moved, mut is_finite) = (self.coordinates, true);
        for (coordinate, change) in moved.as_mut().iter_mut().zip(change.as_ref()) {
            *coordinate += change;
            is_finite &= coordinate.is_finite();
        }
        is_finite.then_some(moved)
    }

    /// Adds a corrected increment, in a step \[s\] or to a known time.
    #[cfg_attr(not(unoptimized), inline(always))]
    pub(in crate::integrate) fn follow(&mut self, change: &S::Array, step: f64, end: Option<f64>) {
        add(&mut self.coordinates, &mut self.lost, change);
        (self.time, self.late) = match end {
            Some(end) => (end, 0.0),
            None => compensated(self.time, self.late, step),
        };
    }

    /// The point after a step \[s\].
    #[cfg_attr(not(unoptimized), inline(always))]
    pub(in crate::integrate) fn after(&self, change: &S::Array, step: f64) -> Self {
        let Self {
            time,
            coordinates,
            late,
            lost,
        } = *self;
        let mut after = Self {
            time,
            coordinates,
            late,
            lost,
        };
        after.follow(change, step, None);
        after
    }

    /// Adds an increment of the coordinates in a step \[s\]. If the result is not finite, changes
    /// nothing and returns false.
    #[must_use]
    #[cfg_attr(not(unoptimized), inline(always))]
    pub(in crate::integrate) fn advance(&mut self, mut change: S::Array, step: f64) -> bool {
        let is_finite = self.moved(&mut change).is_some();
        if is_finite {
            self.follow(&change, step, None);
        }
        is_finite
    }

    /// The same, to a known time.
    #[must_use]
    #[cfg_attr(not(unoptimized), inline(always))]
    pub(in crate::integrate) fn arrive(&mut self, mut change: S::Array, end: f64) -> bool {
        let is_finite = self.moved(&mut change).is_some();
        if is_finite {
            self.follow(&change, 0.0, Some(end));
        }
        is_finite
    }

    pub(in crate::integrate) fn not_finite(&self) -> IntegrationError<S> {
        IntegrationError::lost(self.time, self.state())
    }

    pub(in crate::integrate) fn step_too_small(&self, step: f64) -> IntegrationError<S> {
        IntegrationError::StepTooSmall {
            time: self.time,
            state: self.state(),
            step,
        }
    }
}

/// Adds to all coordinates, and updates their rounding errors.
#[cfg_attr(not(unoptimized), inline(always))]
pub(crate) fn add<T: Scalar, A: AsRef<[T]> + AsMut<[T]>>(sums: &mut A, lost: &mut A, change: &A) {
    let places = sums.as_mut().iter_mut().zip(lost.as_mut());
    for ((sum, lost), change) in places.zip(change.as_ref()) {
        (*sum, *lost) = compensated(*sum, *lost, *change);
    }
}

/// A sum, and its rounding error.
#[cfg_attr(not(unoptimized), inline(always))]
pub(crate) fn compensated<T: Scalar>(sum: T, lost: T, change: T) -> (T, T) {
    let change = change + lost;
    let next = sum + change;
    (next, change - (next - sum))
}
