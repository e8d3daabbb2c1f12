//! A step as it was taken: the motion from its start to its end.

use core::ops::Range;

use super::error::IntegrationError;
use super::event::{Event, Search};
use crate::state::Coordinates;
use crate::taylor::{Axes, after};

/// The number of places within a step at which the sign of a function is evaluated.
pub(in crate::integrate) const PLACES: usize = 16;

/// A step of a motion, and the motion within it.
#[derive(Debug)]
pub struct Step<'m, S: Coordinates<Scalar = f64>> {
    start: f64,
    end: f64,
    axes: Axes,
    coefficients: &'m [S::Array],
    /// The coordinates at the end, where the next step begins.
    last: &'m S::Array,
}

impl<'m, S: Coordinates<Scalar = f64>> Step<'m, S> {
    pub(in crate::integrate) fn new(
        times: Range<f64>,
        axes: Axes,
        coefficients: &'m [S::Array],
        last: &'m S::Array,
    ) -> Self {
        Self {
            start: times.start,
            end: times.end,
            axes,
            coefficients,
            last,
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
        self.end
    }

    /// The state at a time \[s\] between start and end, of the same accuracy as the end.
    #[inline]
    #[must_use]
    pub fn at(&self, time: f64) -> S {
        if time == self.end {
            return self.axes.state(self.last, time);
        }
        let coordinates = after::<S>(self.coefficients, time - self.start);
        self.axes.state(&coordinates, time)
    }

    /// The state at the start, which is the end of the step before.
    fn first(&self) -> S {
        match self.coefficients {
            [first, ..] => self.axes.state(first, self.start),
            [] => self.at(self.start),
        }
    }

    /// Where a function of time and state changes its sign within the step, in the order of the
    /// motion: the start does not count, the end does.
    ///
    /// The sign is evaluated at 16 points. An even number of zeros between two such points is
    /// missed. Zeros are found to the rounding of the function and of time. A function that stays
    /// zero has one where it becomes zero, and none if it is zero from the start.
    ///
    /// The last item is an error where the function is not a number:
    /// [`IntegrationError::EventNotANumber`].
    pub fn zeros<F: Fn(f64, &S) -> f64>(
        &self,
        function: F,
    ) -> impl Iterator<Item = Result<Event<S>, IntegrationError<S>>> {
        let value = function(self.start, &self.first());
        let mut search = Search::new(self.start..self.end, PLACES, value);
        core::iter::from_fn(move || search.next(|time| self.at(time), &function))
    }
}
