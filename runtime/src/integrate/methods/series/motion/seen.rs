//! Steps that the equations agree to, and steps over places where there are no series.

use super::Motion;
use super::crossing::cross;
use super::permitted::GROWTH;
use crate::integrate::methods::adaptive::first;
use crate::integrate::methods::runge_kutta::DormandPrince8;
use crate::integrate::steps::agreement::{Agreement, Seen};
use crate::integrate::steps::equations::Equations;
use crate::integrate::steps::error::IntegrationError;
use crate::integrate::steps::size::larger;
use crate::taylor::{Taylor, increment};

/// How much shorter a step is than those before it, where the motion may not be smooth.
const SUDDEN: f64 = 1.0 / 8.0;
/// How much longer a crossing may be than the one before.
const GROW: f64 = 6.0;

impl<B: Taylor, const N: usize> Motion<'_, B, N> {
    /// Goes along the series for at most so long \[s\], as far as the equations agree; where they
    /// do not at all, over the place.
    #[inline(always)]
    pub(super) fn follow(
        &mut self,
        mut length: f64,
        end: f64,
        input: &B::Input,
        (tolerance, is_held): (f64, bool),
    ) -> Result<f64, IntegrationError<B::State>> {
        let (time, rest, mut is_refused) = (self.now.time, self.now.rest(end), false);
        loop {
            let is_last = length >= rest.abs();
            let step = if is_last { rest } else { length.copysign(rest) };
            let is_lost = (time + step) - time == 0.0 && !is_last;
            if is_lost || step.is_nan() {
                let passed = is_refused.then(|| self.pass(f64::NAN, end, input, tolerance));
                return passed.flatten().ok_or_else(|| {
                    let state = self.state();
                    if step.is_nan() {
                        IntegrationError::not_finite(time, state)
                    } else {
                        IntegrationError::StepTooSmall { time, state, step }
                    }
                });
            }
            let goes_on = is_held && !is_last;
            match self.agreed(step, is_last.then_some(end), input, (tolerance, goes_on)) {
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

    /// Looks, every now and then, whether the motion chatters.
    #[inline(always)]
    pub(super) fn look(
        &mut self,
        rest: f64,
        input: &B::Input,
        tolerance: f64,
    ) -> Result<(), IntegrationError<B::State>> {
        if !self.watch.is_due() {
            return Ok(());
        }
        let equations = Seen {
            equations: Equations {
                body: &self.within,
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

    /// Takes a step, to a time if it is known, if the equations agree to it; or says after what
    /// time \[s\] they do not. One that is longer than those before it is looked at throughout. A
    /// step that `goes_on` is held against the rates of the next one.
    #[inline(always)]
    fn agreed(
        &mut self,
        step: f64,
        end: Option<f64>,
        input: &B::Input,
        (tolerance, goes_on): (f64, bool),
    ) -> Result<(), f64> {
        let is_usual = step.abs() <= GROWTH * self.looked_at;
        if is_usual && goes_on && self.led(step, input, tolerance) {
            return Ok(());
        }
        let agreement = Agreement {
            equations: &Seen {
                equations: Equations {
                    body: &self.within,
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

    /// Takes a step, if the series from its end on begins with the rates that it ends with.
    #[inline(always)]
    fn led(&mut self, step: f64, input: &B::Input, tolerance: f64) -> bool {
        let mut change = increment::<B::State>(self.expansions.series().coefficients(), step);
        let Some(end) = self.now.moved(&mut change) else {
            return false;
        };
        let after = self.now.after(&change, step);
        let [series, ahead] = self.expansions.ahead(&self.within, &after, input);
        let agreement = Agreement {
            equations: &Seen {
                equations: Equations {
                    body: &self.within,
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

    /// Takes a Runge–Kutta step, where the motion is not smooth: of any length, where series permit
    /// no step, or of a multiple of what they do permit; none, if that is too long.
    #[cold]
    pub(super) fn pass(
        &mut self,
        permitted: f64,
        end: f64,
        input: &B::Input,
        tolerance: f64,
    ) -> Option<f64> {
        let equations = Seen {
            equations: Equations {
                body: &self.within,
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
