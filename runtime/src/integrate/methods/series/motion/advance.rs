//! Single steps of a motion.

use super::Along;
use crate::integrate::steps::error::IntegrationError;
use crate::integrate::steps::setting::{self, Setting};
use crate::integrate::steps::size::finest;
use crate::integrate::steps::step::Step;
use crate::integrate::steps::stretch::Within;
use crate::taylor::{Taylor, increment};

impl<B: Taylor, const N: usize> Along<B, N> {
    /// Takes the longest step towards `end` \[s\] that a tolerance permits, with the input of the
    /// previous step, or after [`renew`](Self::renew); `is_held` if the next step probably has the same
    /// input. None if the end is reached.
    pub(in crate::integrate::methods::series) fn advance_towards(
        &mut self,
        body: &B,
        end: f64,
        input: &B::Input,
        (tolerance, is_held): (f64, bool),
    ) -> Result<Option<Step<'_, B::State>>, IntegrationError<B::State>> {
        let (time, rest) = (self.now.time, self.now.rest(end));
        let given = [(Setting::Tolerance, tolerance)];
        let tolerance = finest(tolerance);
        if rest.is_nan() || tolerance == 0.0 {
            let checked = setting::check(&(time..end), given);
            let refused = |invalid| IntegrationError::refused(invalid, time, self.state());
            checked.map_err(refused)?;
        }
        if rest == 0.0 {
            return Ok(None);
        }
        let within = &Within::new(body, &self.stretch);
        self.look(within, rest, input, tolerance)?;
        self.expand(within, input);
        let until = end;
        let end = match self.doubt {
            Some(doubt) if (doubt - time) * rest > 0.0 && (doubt - end) * rest < 0.0 => doubt,
            _ => end,
        };
        let permitted = self.permitted(tolerance);
        let passed = if permitted >= self.rough && permitted > 0.0 {
            None
        } else {
            self.pass(within, permitted, end, (input, tolerance))
        };
        let step = if let Some(step) = passed {
            step
        } else {
            let goes_on = is_held && self.goes_on;
            self.follow(within, (permitted, end), input, (tolerance, goes_on))?
        };
        self.watch.saw(step, self.now.time == until);
        Ok(Some(self.taken(time)))
    }

    /// Takes a step of this length \[s\], whatever its error.
    pub(super) fn advance_by(
        &mut self,
        body: &B,
        step: f64,
        input: &B::Input,
    ) -> Result<Step<'_, B::State>, IntegrationError<B::State>> {
        let time = self.now.time;
        self.expand(&Within::new(body, &self.stretch), input);
        let change = increment::<B::State>(self.expansions.series().coefficients(), step);
        if self.now.advance(change, step) {
            return Ok(self.taken(time));
        }
        Err(IntegrationError::lost(time, self.state()))
    }

    /// Called when an input is given.
    pub(super) fn take_input(&mut self) {
        self.stretch.given = self.now.time;
        self.renew();
    }

    /// The series at the current point.
    #[cfg_attr(not(unoptimized), inline(always))]
    fn expand(&mut self, within: &Within<'_, B>, input: &B::Input) {
        self.is_crossing = false;
        self.expansions.expand(within, &self.now, input);
    }
}
