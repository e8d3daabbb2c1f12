//! Steps of equal length.

use core::fmt;
use core::ops::Range;

use super::runge_kutta::RungeKutta;
use super::runge_kutta::track::Track;
use crate::bodies::body::RigidBody;
use crate::bodies::switches::Stretch;
use crate::integrate::steps::equations::Equations;
use crate::integrate::steps::error::IntegrationError;
use crate::integrate::steps::method::{Method, Run};
use crate::integrate::steps::setting::{InvalidSetting, Setting};
use crate::integrate::steps::stretch::Within;

use crate::numbers::count::real;
use crate::state::Coordinates;

/// A method with equal steps, each not longer than `step` \[s\].
///
/// Each span between the start, changes of the input and the end is divided into the
/// least number of such steps.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fixed<M> {
    /// The method of each step.
    pub method: M,
    /// The longest step \[s\].
    pub step: f64,
}

impl<M> Fixed<M> {
    /// The number of steps in a span of time, if it is representable.
    pub(crate) fn count(&self, span: f64) -> Option<usize> {
        // rounding does not add a step
        let count = libm::ceil(span.abs() / self.step * (1.0 - 1e-12)).max(1.0);
        let is_valid = self.step > 0.0 && count < 9_007_199_254_740_992.0; // 2⁵³
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "whole, positive and below 2⁵³"
        )]
        is_valid.then_some(count as usize)
    }
}

impl<M: RungeKutta, B: RigidBody<Scalar = f64, State: Coordinates>> Method<B> for Fixed<M> {
    type Run = FixedRun<M, B>;

    fn start(self, _body: &B, time: f64, state: &B::State) -> Self::Run {
        FixedRun {
            track: Track::new(time, state),
            fixed: self,
            span: time..time,
            steps: Range::default(),
        }
    }

    fn setting(&self) -> Option<(Setting, f64)> {
        Some((Setting::Step, self.step))
    }
}

/// A motion in equal steps.
pub struct FixedRun<M, B: RigidBody<Scalar = f64, State: Coordinates>> {
    pub(crate) track: Track<B::State>,
    fixed: Fixed<M>,
    /// The span being divided, and its remaining steps.
    pub(crate) span: Range<f64>,
    pub(crate) steps: Range<usize>,
}

impl<M: RungeKutta, B: RigidBody<Scalar = f64, State: Coordinates>> fmt::Debug for FixedRun<M, B> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("FixedRun")
            .field("fixed", &self.fixed)
            .field("time", &self.track.now.time)
            .finish_non_exhaustive()
    }
}

impl<M: RungeKutta, B: RigidBody<Scalar = f64, State: Coordinates>> Run<B> for FixedRun<M, B> {
    const PLACES: usize = 4;

    fn time(&self) -> f64 {
        self.track.now.time
    }

    fn state(&self) -> B::State {
        self.track.now.state()
    }

    #[inline]
    fn advance(
        &mut self,
        body: &B,
        end: f64,
        input: &B::Input,
    ) -> Result<(), IntegrationError<B::State>> {
        let Track {
            stretch,
            now,
            before,
        } = &mut self.track;
        if self.steps.is_empty() || self.span.end != end {
            self.span = now.time..end;
            let Some(count) = self.fixed.count(end - now.time) else {
                let (setting, value) = (Setting::Step, self.fixed.step);
                let (time, state) = (now.time, now.state());
                let invalid = InvalidSetting { setting, value };
                return Err(IntegrationError::refused(invalid, time, state));
            };
            self.steps = 0..count;
        }
        let step = (end - self.span.start) / real(self.steps.end);
        let equations = Equations {
            body: &Within::new(body, stretch),
            input,
        };
        let (time, coordinates) = (now.time, now.coordinates);
        let change = M::increment(&equations, time, &coordinates, step);
        self.steps.start += 1;
        let next = if self.steps.is_empty() {
            end
        } else {
            self.span.start + real(self.steps.start) * step
        };
        if !now.arrive(change, next) {
            let rates = equations.rates(time, &coordinates);
            let is_finite = rates.as_ref().iter().all(|rate| rate.is_finite());
            let error = if M::IS_IMPLICIT && is_finite {
                let state = now.state();
                IntegrationError::StepTooLong { time, state, step }
            } else {
                now.not_finite()
            };
            return Err(error.of_step(step, (body, input)));
        }
        *before = (time, coordinates);
        Ok(())
    }

    fn enter(&mut self, stretch: Stretch) {
        self.track.stretch = stretch;
    }

    fn replace(&mut self, _body: &B, state: &B::State) {
        self.track.now.replace(state);
    }

    fn within(&self, body: &B, time: f64, input: &B::Input) -> B::State {
        self.track.within::<M, B>(body, time, input)
    }
}
