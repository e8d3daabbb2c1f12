//! Motions in closed form, as a method of integration.

use core::fmt;

use crate::bodies::body::Flow;
use crate::bodies::path::Path;
use crate::integrate::steps::error::IntegrationError;
use crate::integrate::steps::method::{Method, Run, Tolerant};
use crate::state::Coordinates;

/// The closed form of [`Flow`]: no steps at all, and errors of rounding only. The tolerance has no
/// effect.
///
/// Events are searched at 16 points of every [`Path::pace`].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ClosedForm;

impl Tolerant for ClosedForm {
    fn with_tolerance(_: f64) -> Self {
        Self
    }
}

impl<B: Flow<Scalar = f64, State: Coordinates>> Method<B> for ClosedForm {
    type Run<'b>
        = PathRun<'b, B>
    where
        B: 'b;

    fn start<'b>(self, body: &'b B, time: f64, state: &B::State) -> PathRun<'b, B> {
        PathRun {
            body,
            path: body.path(state),
            start: (time, state.clone()),
            time,
        }
    }
}

/// A motion along its path.
pub struct PathRun<'b, B: Flow> {
    body: &'b B,
    path: B::Path,
    /// The start of the path.
    start: (f64, B::State),
    time: f64,
}

impl<B: Flow> fmt::Debug for PathRun<'_, B> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("PathRun")
            .field("start", &self.start.0)
            .field("time", &self.time)
            .finish_non_exhaustive()
    }
}

impl<B: Flow<Scalar = f64, State: Coordinates>> Run<B> for PathRun<'_, B> {
    const PLACES: usize = 16;

    fn body(&self) -> &B {
        self.body
    }

    fn time(&self) -> f64 {
        self.time
    }

    fn state(&self) -> B::State {
        let (start, state) = &self.start;
        if self.time.to_bits() == start.to_bits() {
            state.clone()
        } else {
            self.path.at(self.time - start)
        }
    }

    fn advance(&mut self, end: f64, input: &B::Input) -> Result<(), IntegrationError<B::State>> {
        let (time, rest) = (self.time, end - self.time);
        let step = self
            .path
            .pace(time - self.start.0)
            .min(rest.abs())
            .copysign(rest);
        let next = if step == rest { end } else { time + step };
        if next == time {
            let state = self.state();
            return Err(IntegrationError::StepTooSmall { time, state, step });
        }
        self.seek(next, end, input)
    }

    fn within(&self, time: f64, _input: &B::Input) -> B::State {
        self.path.at(time - self.start.0)
    }

    fn replace(&mut self, state: &B::State) {
        self.path = self.body.path(state);
        self.start = (self.time, state.clone());
    }

    fn seek(
        &mut self,
        time: f64,
        _end: f64,
        _input: &B::Input,
    ) -> Result<(), IntegrationError<B::State>> {
        let state = self.path.at(time - self.start.0);
        if !state.coordinates().as_ref().iter().sum::<f64>().is_finite() {
            let (time, state) = (self.time, self.state());
            return Err(IntegrationError::lost(time, state));
        }
        self.time = time;
        Ok(())
    }
}
