//! The faster pair of Runge–Kutta methods for a tolerance.

use super::adaptive::{AdaptiveRun, DormandPrince, Verner};
use super::runge_kutta::{DormandPrince8, Verner9};
use crate::bodies::body::RigidBody;
use crate::bodies::switches::Stretch;
use crate::integrate::steps::error::IntegrationError;
use crate::integrate::steps::method::{Method, Run, Tolerant};
use crate::state::Coordinates;

/// Above this, twelve evaluations per step are faster; below, the higher order is
/// (`cargo run --release --example work_precision`).
const COARSE: f64 = 1e-5;

/// [`DormandPrince`] for tolerances above 1e-5, [`Verner`] below: the faster pair for each.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RungeKuttaPair {
    /// The bound of the error of a step: see [`Tolerant`].
    pub tolerance: f64,
}

impl Tolerant for RungeKuttaPair {
    fn with_tolerance(tolerance: f64) -> Self {
        Self { tolerance }
    }
}

impl<B: RigidBody<Scalar = f64, State: Coordinates>> Method<B> for RungeKuttaPair {
    type Run<'b>
        = PairRun<'b, B>
    where
        B: 'b;

    fn start<'b>(self, body: &'b B, time: f64, state: &B::State) -> Self::Run<'b> {
        let Self { tolerance } = self;
        if tolerance > COARSE {
            PairRun::Coarse(DormandPrince { tolerance }.start(body, time, state))
        } else {
            PairRun::Fine(Verner { tolerance }.start(body, time, state))
        }
    }
}

/// A motion by one of the pairs.
#[derive(Debug)]
pub enum PairRun<'b, B: RigidBody<Scalar = f64, State: Coordinates>> {
    /// By [`DormandPrince`].
    Coarse(AdaptiveRun<'b, B, DormandPrince8>),
    /// By [`Verner`].
    Fine(AdaptiveRun<'b, B, Verner9>),
}

/// Calls a method of the run.
macro_rules! of_either {
    ($run:expr, $method:ident($($argument:expr),*)) => {
        match $run {
            PairRun::Coarse(run) => run.$method($($argument),*),
            PairRun::Fine(run) => run.$method($($argument),*),
        }
    };
}

impl<B: RigidBody<Scalar = f64, State: Coordinates>> Run<B> for PairRun<'_, B> {
    const PLACES: usize = AdaptiveRun::<B, Verner9>::PLACES;

    fn body(&self) -> &B {
        of_either!(self, body())
    }

    fn time(&self) -> f64 {
        of_either!(self, time())
    }

    fn state(&self) -> B::State {
        of_either!(self, state())
    }

    fn advance(&mut self, end: f64, input: &B::Input) -> Result<(), IntegrationError<B::State>> {
        of_either!(self, advance(end, input))
    }

    fn heads_for(&mut self, end: f64) {
        of_either!(self, heads_for(end));
    }

    fn enter(&mut self, stretch: Stretch) {
        of_either!(self, enter(stretch));
    }

    fn replace(&mut self, state: &B::State) {
        of_either!(self, replace(state));
    }

    fn within(&self, time: f64, input: &B::Input) -> B::State {
        of_either!(self, within(time, input))
    }
}
