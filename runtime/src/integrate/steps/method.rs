//! The interface of methods to [`Integration`](crate::integrate::Integration).

use super::error::IntegrationError;
use super::setting::Setting;
use crate::bodies::body::RigidBody;
use crate::bodies::switches::Stretch;

/// A method of integration for bodies of some kind.
pub trait Method<B: RigidBody<Scalar = f64>>: Copy + Send + Sync {
    /// A motion in progress.
    type Run: Run<B>;

    /// Begins the motion of a body at a state.
    fn start(self, body: &B, time: f64, state: &B::State) -> Self::Run;

    /// Its setting, with its value, if it has one. An integration refuses an impossible value
    /// before it begins.
    fn setting(&self) -> Option<(Setting, f64)> {
        None
    }
}

/// A method with a bound of the error of a step.
pub trait Tolerant: Sized {
    /// The method with this tolerance: relative to position, attitude, velocity and angular
    /// velocity, each as a whole, and absolute (m, rad, m/s, rad/s) where these are below 1. The
    /// error at the end is the sum of the errors of all steps, each propagated by the motion. A
    /// tolerance below rounding counts as 1e-18.
    #[must_use]
    fn with_tolerance(tolerance: f64) -> Self;
}

/// A motion in progress by some method, apart from the body, which is the same in all calls.
pub trait Run<B: RigidBody<Scalar = f64>>: Send {
    /// The number of points within a step at which events are searched.
    const PLACES: usize;

    /// The current time \[s\].
    fn time(&self) -> f64;

    /// The current state.
    fn state(&self) -> B::State;

    /// Takes one step towards `end` \[s\], which is not the current time, and not beyond; the input
    /// is held.
    ///
    /// # Errors
    /// [`IntegrationError`]; the motion stays where it is.
    fn advance(
        &mut self,
        body: &B,
        end: f64,
        input: &B::Input,
    ) -> Result<(), IntegrationError<B::State>>;

    /// The same; if mass or inertia change, checks that the body is possible at start and end.
    ///
    /// # Errors
    /// As for [`advance`](Self::advance), and [`IntegrationError::InvalidBody`].
    fn step(
        &mut self,
        body: &B,
        end: f64,
        input: &B::Input,
    ) -> Result<(), IntegrationError<B::State>> {
        if !B::CHANGES {
            return self.advance(body, end, input);
        }
        let (time, state) = (self.time(), self.state());
        let mut possible = body.possible(time, &state, input);
        if possible.is_ok() {
            self.advance(body, end, input)?;
            possible = body.possible(self.time(), &self.state(), input);
        }
        possible.map_err(|invalid| IntegrationError::InvalidBody {
            time,
            state,
            invalid,
        })
    }

    /// The state within the last step, which had this input.
    fn within(&self, body: &B, time: f64, input: &B::Input) -> B::State;

    /// The bound of the error of a step, if the method has one.
    fn tolerance(&self) -> Option<f64> {
        None
    }

    /// Called with the end of the motion \[s\], before its first step.
    fn heads_for(&mut self, _end: f64) {}

    /// Called when the input changes between steps.
    fn renew(&mut self) {}

    /// Called with the stretch of time of the next steps.
    fn enter(&mut self, _stretch: Stretch) {}

    /// Continues from another state at the same time.
    fn replace(&mut self, body: &B, state: &B::State);

    /// Advances until a time \[s\] lies within the last step, with steps that need not end
    /// there, but not beyond `end`.
    ///
    /// # Errors
    /// As for [`advance`](Self::advance).
    fn seek(
        &mut self,
        body: &B,
        time: f64,
        end: f64,
        input: &B::Input,
    ) -> Result<(), IntegrationError<B::State>> {
        let forwards = end >= self.time();
        let is_before = |now: f64| if forwards { now < time } else { now > time };
        while is_before(self.time()) {
            self.step(body, end, input)?;
        }
        Ok(())
    }
}
