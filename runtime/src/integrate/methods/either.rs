//! A motion by one of two methods.

use crate::bodies::body::RigidBody;
use crate::bodies::switches::Stretch;
use crate::integrate::steps::error::IntegrationError;
use crate::integrate::steps::method::Run;

/// A motion by one of two methods, chosen at its start.
#[derive(Debug)]
pub enum EitherRun<F, S> {
    /// By the first method.
    First(F),
    /// By the second method.
    Second(S),
}

/// Calls a method of the run.
macro_rules! of_either {
    ($run:expr, $method:ident($($argument:expr),*)) => {
        match $run {
            EitherRun::First(run) => run.$method($($argument),*),
            EitherRun::Second(run) => run.$method($($argument),*),
        }
    };
}

impl<B: RigidBody<Scalar = f64>, F: Run<B>, S: Run<B>> Run<B> for EitherRun<F, S> {
    const PLACES: usize = if F::PLACES > S::PLACES {
        F::PLACES
    } else {
        S::PLACES
    };

    fn time(&self) -> f64 {
        of_either!(self, time())
    }

    fn state(&self) -> B::State {
        of_either!(self, state())
    }

    fn advance(
        &mut self,
        body: &B,
        end: f64,
        input: &B::Input,
    ) -> Result<(), IntegrationError<B::State>> {
        of_either!(self, advance(body, end, input))
    }

    fn tolerance(&self) -> Option<f64> {
        of_either!(self, tolerance())
    }

    fn heads_for(&mut self, end: f64) {
        of_either!(self, heads_for(end));
    }

    fn renew(&mut self) {
        of_either!(self, renew());
    }

    fn enter(&mut self, stretch: Stretch) {
        of_either!(self, enter(stretch));
    }

    fn replace(&mut self, body: &B, state: &B::State) {
        of_either!(self, replace(body, state));
    }

    fn within(&self, body: &B, time: f64, input: &B::Input) -> B::State {
        of_either!(self, within(body, time, input))
    }
}
