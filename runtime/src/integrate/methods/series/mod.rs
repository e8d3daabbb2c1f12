//! Taylor series as a method of integration.

use core::fmt;

use crate::bodies::switches::Stretch;
use crate::integrate::steps::error::IntegrationError;
use crate::integrate::steps::method::{Method, Run, Tolerant};
use crate::integrate::steps::setting::Setting;
use crate::integrate::steps::step;
use crate::taylor::Taylor;
use motion::Along;

pub mod functions;
pub mod motion;

/// Taylor series, with an order that follows from the tolerance: see
/// [`taylor()`](crate::integrate::taylor()). States within a step cost almost
/// nothing.
///
/// Steps are checked against the equations, and shortened until they agree. Where the
/// motion is not smooth, such as at rest under drag, a step of
/// [`DormandPrince`](crate::integrate::DormandPrince) is used. A smooth load that acts only for a
/// short part of a step may still fall between the checked points: state its time by
/// [`breaks`](crate::integrate::Integration::breaks) or limit steps by
/// [`max_step`](crate::integrate::Integration::max_step).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TaylorSeries {
    /// The bound of the error of a step: see [`Tolerant`].
    pub tolerance: f64,
}

impl Tolerant for TaylorSeries {
    fn with_tolerance(tolerance: f64) -> Self {
        Self { tolerance }
    }
}

/// Motions of the available orders, and code for any of them. Bodies with many
/// products prefer lower orders, tops higher ones; these orders are within a fifth of the best for
/// all problems of the example `work_precision`.
macro_rules! orders {
    ($($least:pat => $order:ident $count:literal,)*) => {
        enum Motions<B: Taylor> {
            $($order(Along<B, $count>),)*
        }

        impl<B: Taylor> Method<B> for TaylorSeries {
            type Run = SeriesRun<B>;

            fn start(self, body: &B, time: f64, state: &B::State) -> SeriesRun<B> {
                let motion = match self.tolerance {
                    $($least => Motions::$order(Along::new(body, time, state)),)*
                };
                SeriesRun { motion, tolerance: self.tolerance, start: time }
            }

            fn setting(&self) -> Option<(Setting, f64)> {
                Some((Setting::Tolerance, self.tolerance))
            }
        }

        /// Runs code on the motion, of whatever order.
        macro_rules! with {
            ($of:expr, $motion:ident => $what:expr) => {
                match $of {
                    $(Motions::$order($motion) => $what,)*
                }
            };
        }
    };
}

orders! {
    1e-4.. => Ten 11,
    1e-7.. => Twelve 13,
    1e-10.. => Sixteen 17,
    _ => Twenty 21,
}

/// A motion along its series.
pub struct SeriesRun<B: Taylor> {
    motion: Motions<B>,
    tolerance: f64,
    /// The start of the last step \[s\].
    start: f64,
}

impl<B: Taylor> fmt::Debug for SeriesRun<B> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("SeriesRun")
            .field("tolerance", &self.tolerance)
            .field("time", &self.time())
            .finish_non_exhaustive()
    }
}

impl<B: Taylor> Run<B> for SeriesRun<B> {
    const PLACES: usize = step::PLACES;

    fn time(&self) -> f64 {
        with!(&self.motion, motion => motion.time())
    }

    fn state(&self) -> B::State {
        with!(&self.motion, motion => motion.state())
    }

    fn advance(
        &mut self,
        body: &B,
        end: f64,
        input: &B::Input,
    ) -> Result<(), IntegrationError<B::State>> {
        let start = with!(&mut self.motion, motion => {
            let step = motion.advance_towards(body, end, input, (self.tolerance, true))?;
            step.map(|step| step.start())
        });
        if let Some(start) = start {
            self.start = start;
        }
        Ok(())
    }

    fn within(&self, _body: &B, time: f64, _input: &B::Input) -> B::State {
        with!(&self.motion, motion => motion.taken(self.start).at(time))
    }

    fn tolerance(&self) -> Option<f64> {
        Some(self.tolerance)
    }

    fn heads_for(&mut self, end: f64) {
        with!(&mut self.motion, motion => motion.heads_for(end));
    }

    fn renew(&mut self) {
        with!(&mut self.motion, motion => motion.renew());
    }

    fn enter(&mut self, stretch: Stretch) {
        with!(&mut self.motion, motion => motion.enter(stretch));
    }

    fn replace(&mut self, body: &B, state: &B::State) {
        with!(&mut self.motion, motion => motion.replace(body, state));
    }
}
