//! A step as it was taken: the motion from its start to its end.

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
    length: f64,
    axes: Axes,
    coefficients: &'m [S::Array],
}

impl<'m, S: Coordinates<Scalar = f64>> Step<'m, S> {
    pub(in crate::integrate) fn new(
        start: f64,
        length: f64,
        axes: Axes,
        coefficients: &'m [S::Array],
    ) -> Self {
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
        let Self {
            start,
            length,
            axes,
            coefficients,
        } = *self;
        let state = move |time| axes.state::<S>(&after::<S>(coefficients, time - start), time);
        let value = function(start, &state(start));
        let mut search = Search::new(start, length, PLACES, value);
        core::iter::from_fn(move || search.next(state, &function))
    }
}
