//! Steps that agree with the equations, and steps over places without series.

use super::Along;
use super::crossing::cross;
use super::permitted::GROWTH;
use crate::integrate::methods::adaptive::first;
use crate::integrate::methods::runge_kutta::DormandPrince8;
use crate::integrate::steps::agreement::{Agreement, Seen};
use crate::integrate::steps::equations::Equations;
use crate::integrate::steps::error::IntegrationError;
use crate::integrate::steps::size::larger;
use crate::integrate::steps::stretch::Within;
use crate::taylor::{Taylor, increment};

/// The ratio of a step to those before it below which the motion may not be smooth.
const SUDDEN: f64 = 1.0 / 8.0;
/// The largest growth from one crossing to the next.
const GROW: f64 = 6.0;

impl<B: Taylor, const N: usize> Along<B, N> {
    /// Follows the series for at most this time \[s\], as far as the equations agree; crosses the
    /// place if they do not agree at all.
    #[cfg_attr(not(unoptimized), inline(always))]
    pub(super) fn follow(
        &mut self,
        within: &Within<'_, B>,
        (mut length, end): (f64, f64),
        input: &B::Input,
        (tolerance, is_held): (f64, bool),
    ) -> Result<f64, IntegrationError<B::State>> {
        let (time, rest, mut is_refused) = (self.now.time, self.now.rest(end), false);
        loop {
            let is_last = length >= rest.abs();
            let step = if is_last { rest } else { length.copysign(rest) };
            let is_lost = (time + step) - time == 0.0 && !is_last;
            if is_lost || step.is_nan() {
                let passed =
                    is_refused.then(|| self.pass(within, f64::NAN, end, (input, tolerance)));
                return passed.flatten().ok_or_else(|| {
                    let state = self.state();
                    if step.is_nan() {
                        IntegrationError::lost(time, state)
                    } else {
                        IntegrationError::StepTooSmall { time, state, step }
                    }
                });
            }
            let goes_on = is_held && !is_last;
            match self.agreed(
                within,
                (step, is_last.then_some(end)),
                input,
                (tolerance, goes_on),
            ) {
                Ok(()) => {
                    self.length = step.abs();
                    self.looked_at = if is_last && self.looked_at > self.length {
                        self.looked_at
                    } else {
                        self.length
                    };
                    self.rough = larger(self.rough, SUDDEN * self.length);
                    return Ok(step);
                }
                Err(after) => {
                    self.doubt = Some(time + after);
                    let is_finite = self.expansions.series().is_finite();
                    length = if is_finite {
                        0.5 * step.abs()
                    } else {
                        f64::NAN
                    };
                    is_refused = true;
                }
            }
        }
    }

    /// Checks from time to time whether the motion chatters.
    #[cfg_attr(not(unoptimized), inline(always))]
    pub(super) fn look(
        &mut self,
        within: &Within<'_, B>,
        rest: f64,
        input: &B::Input,
        tolerance: f64,
    ) -> Result<(), IntegrationError<B::State>> {
        if !self.watch.is_due() {
            return Ok(());
        }
        let equations = Seen {
            equations: Equations {
                body: within,
                input,
            },
            axes: &self.axes,
        };
        let chatters = self.watch.chatters(&equations, &self.now, rest, tolerance);
        chatters.map_or(Ok(()), |step| {
            let (time, state) = (self.now.time, self.state());
            Err(IntegrationError::StepTooSmall { time, state, step })
        })
    }

    /// Takes a step, to a given time if it is known, if the equations agree with it; otherwise
    /// returns the time \[s\] of disagreement. A step longer than those before it is checked
    /// throughout. A step that `goes_on` is compared with the rates of the next one.
    #[cfg_attr(not(unoptimized), inline(always))]
    fn agreed(
        &mut self,
        within: &Within<'_, B>,
        (step, end): (f64, Option<f64>),
        input: &B::Input,
        (tolerance, goes_on): (f64, bool),
    ) -> Result<(), f64> {
        let is_usual = step.abs() <= GROWTH * self.looked_at;
        if is_usual && goes_on && self.led(within, step, input, tolerance) {
            return Ok(());
        }
        let agreement = Agreement {
            equations: &Seen {
                equations: Equations {
                    body: within,
                    input,
                },
                axes: &self.axes,
            },
            start: self.now.time,
            coefficients: self.expansions.series().coefficients(),
            tolerance,
        };
        let is_seen = is_usual && !goes_on;
        let change = is_seen.then(|| self.expansions.expander.holds(&agreement, &self.now, step));
        let change = match change.flatten() {
            Some(change) => change,
            None => self
                .expansions
                .expander
                .holds_throughout(&agreement, &self.now, step)?,
        };
        self.now.follow(&change, step, end);
        Ok(())
    }

    /// Takes a step, if the series at its end begins with its final rates.
    #[cfg_attr(not(unoptimized), inline(always))]
    fn led(&mut self, within: &Within<'_, B>, step: f64, input: &B::Input, tolerance: f64) -> bool {
        let mut change = increment::<B::State>(self.expansions.series().coefficients(), step);
        let Some(end) = self.now.moved(&mut change) else {
            return false;
        };
        let after = self.now.after(&change, step);
        let [series, ahead] = self.expansions.ahead(within, &after, input);
        let agreement = Agreement {
            equations: &Seen {
                equations: Equations {
                    body: within,
                    input,
                },
                axes: &self.axes,
            },
            start: self.now.time,
            coefficients: series.coefficients(),
            tolerance,
        };
        let rates = ahead.coefficients().get(1);
        let holds = rates.is_some_and(|rates| agreement.holds_to(rates, step, &end));
        if holds {
            self.now = after;
        } else {
            self.expansions.forget();
        }
        holds
    }

    /// Takes a Runge–Kutta step where the motion is not smooth: of any length if series permit
    /// no step, otherwise a multiple of the permitted step; none if that is too long.
    #[cold]
    pub(super) fn pass(
        &mut self,
        within: &Within<'_, B>,
        permitted: f64,
        end: f64,
        (input, tolerance): (&B::Input, f64),
    ) -> Option<f64> {
        let equations = Seen {
            equations: Equations {
                body: within,
                input,
            },
            axes: &self.axes,
        };
        let rest = self.now.rest(end);
        let [longest, least] = if permitted > 0.0 {
            [64.0, 2.0].map(|times| times * permitted)
        } else {
            // where one crossing follows another, steps grow
            let first = first::<DormandPrince8, _, _>(
                &equations,
                self.now.time,
                &self.now.coordinates,
                rest,
                tolerance,
            );
            [larger(first, GROW * self.length), 0.0]
        };
        let is_last = longest >= rest.abs();
        let longest = if is_last {
            rest
        } else {
            longest.copysign(rest)
        };
        let crossing = cross(&equations, &self.now, (longest, is_last), least, tolerance);
        let Some(crossing) = crossing else {
            self.rough = larger(0.0, SUDDEN * permitted);
            return None;
        };
        let step = crossing.step;
        let end = (is_last && step == rest).then_some(end);
        self.now.follow(&crossing.change, step, end);
        (self.crossing, self.is_crossing) = (crossing.coefficients, true);
        (self.length, self.looked_at) = (step.abs(), step.abs());
        self.rough = 0.5 * step.abs();
        Some(step)
    }
}
