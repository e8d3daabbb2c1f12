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
    type Run = PathRun<B>;

    fn start(self, body: &B, time: f64, state: &B::State) -> PathRun<B> {
        PathRun {
            path: body.path(state),
            start: (time, state.clone()),
            time,
        }
    }
}

/// A motion along its path.
pub struct PathRun<B: Flow> {
    path: B::Path,
    /// The start of the path.
    start: (f64, B::State),
    time: f64,
}

impl<B: Flow> fmt::Debug for PathRun<B> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("PathRun")
            .field("start", &self.start.0)
            .field("time", &self.time)
            .finish_non_exhaustive()
    }
}

impl<B: Flow<Scalar = f64, State: Coordinates>> Run<B> for PathRun<B> {
    const PLACES: usize = 16;

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

    fn advance(
        &mut self,
        body: &B,
        end: f64,
        input: &B::Input,
    ) -> Result<(), IntegrationError<B::State>> {
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
        self.seek(body, next, end, input)
    }

    fn within(&self, _body: &B, time: f64, _input: &B::Input) -> B::State {
        self.path.at(time - self.start.0)
    }

    fn replace(&mut self, body: &B, state: &B::State) {
        self.path = body.path(state);
        self.start = (self.time, state.clone());
    }

    fn seek(
        &mut self,
        _body: &B,
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
