//! The faster method for a tolerance.

use super::adaptive::{AdaptiveRun, DormandPrince, Verner};
use super::either::EitherRun;
use super::runge_kutta::{DormandPrince8, Verner9};
use super::series::{SeriesRun, TaylorSeries};
use crate::bodies::body::RigidBody;
use crate::integrate::steps::method::{Method, Tolerant};
use crate::integrate::steps::setting::Setting;
use crate::state::Coordinates;
use crate::taylor::Taylor;

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

/// A motion by [`DormandPrince`] or [`Verner`].
pub type PairRun<B> = EitherRun<AdaptiveRun<B, DormandPrince8>, AdaptiveRun<B, Verner9>>;

impl<B: RigidBody<Scalar = f64, State: Coordinates>> Method<B> for RungeKuttaPair {
    type Run = PairRun<B>;

    fn start(self, body: &B, time: f64, state: &B::State) -> Self::Run {
        let Self { tolerance } = self;
        if tolerance > COARSE {
            EitherRun::First(DormandPrince { tolerance }.start(body, time, state))
        } else {
            EitherRun::Second(Verner { tolerance }.start(body, time, state))
        }
    }

    fn setting(&self) -> Option<(Setting, f64)> {
        Some((Setting::Tolerance, self.tolerance))
    }
}

/// [`TaylorSeries`] for tolerances of 10⁻ᴺ and below, [`RungeKuttaPair`] above: the faster of both
/// for bodies whose series gain from small tolerances alone.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SeriesBelow<const N: u32> {
    /// The bound of the error of a step: see [`Tolerant`].
    pub tolerance: f64,
}

impl<const N: u32> SeriesBelow<N> {
    /// 10⁻ᴺ
    #[expect(clippy::cast_precision_loss, reason = "powers of ten up to 10²²")]
    const FINE: f64 = 1.0 / 10_u64.pow(N) as f64;
}

impl<const N: u32> Tolerant for SeriesBelow<N> {
    fn with_tolerance(tolerance: f64) -> Self {
        Self { tolerance }
    }
}

impl<B: Taylor, const N: u32> Method<B> for SeriesBelow<N> {
    type Run = EitherRun<SeriesRun<B>, PairRun<B>>;

    fn start(self, body: &B, time: f64, state: &B::State) -> Self::Run {
        let Self { tolerance } = self;
        if tolerance <= Self::FINE {
            EitherRun::First(TaylorSeries { tolerance }.start(body, time, state))
        } else {
            EitherRun::Second(RungeKuttaPair { tolerance }.start(body, time, state))
        }
    }

    fn setting(&self) -> Option<(Setting, f64)> {
        Some((Setting::Tolerance, self.tolerance))
    }
}
