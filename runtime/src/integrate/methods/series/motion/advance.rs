//! Single steps of a motion.

use super::Motion;
use crate::integrate::steps::error::IntegrationError;
use crate::integrate::steps::setting::{self, Setting};
use crate::integrate::steps::size::finest;
use crate::integrate::steps::step::Step;
use crate::taylor::{Taylor, increment};

impl<B: Taylor, const N: usize> Motion<'_, B, N> {
    /// Takes the longest step towards `end` \[s\] that `tolerance` permits (as in
    /// [`taylor`](crate::integrate::taylor())), with the given input from here on; none if
    /// the end is reached.
    ///
    /// # Errors
    /// [`IntegrationError`]; the motion stays where it is.
    pub fn step_towards(
        &mut self,
        end: f64,
        input: &B::Input,
        tolerance: f64,
    ) -> Result<Option<Step<'_, B::State>>, IntegrationError<B::State>> {
        // a caller that steps by hand may give another input each time, if there is any
        let is_held = size_of::<B::Input>() == 0;
        if !is_held {
            self.take_input();
        }
        self.advance_towards(end, input, tolerance, is_held)
    }

    /// The same, with the input of the previous step, or after [`renew`](Self::renew); `is_held` if
    /// the next step probably has the same input.
    pub(in crate::integrate::methods::series) fn advance_towards(
        &mut self,
        end: f64,
        input: &B::Input,
        tolerance: f64,
        is_held: bool,
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
        self.look(rest, input, tolerance)?;
        self.expand(input);
        let until = end;
        let end = match self.doubt {
            Some(doubt) if (doubt - time) * rest > 0.0 && (doubt - end) * rest < 0.0 => doubt,
            _ => end,
        };
        let permitted = self.permitted(tolerance);
        let passed = if permitted >= self.rough && permitted > 0.0 {
            None
        } else {
            self.pass(permitted, end, input, tolerance)
        };
        let step = match passed {
            Some(step) => step,
            None => self.follow(permitted, end, input, (tolerance, is_held && self.goes_on))?,
        };
        self.watch.saw(step, self.now.time == until);
        Ok(Some(self.taken(time, step)))
    }

    /// Takes a step of this length \[s\], with the given input from here on, whatever its
    /// error.
    ///
    /// # Errors
    /// [`IntegrationError::NotFinite`]; the motion stays where it is.
    pub fn step(
        &mut self,
        step: f64,
        input: &B::Input,
    ) -> Result<Step<'_, B::State>, IntegrationError<B::State>> {
        let time = self.now.time;
        self.take_input();
        self.expand(input);
        self.advance(step)?;
        Ok(self.taken(time, step))
    }

    /// Called when an input is given.
    fn take_input(&mut self) {
        self.within.given = self.now.time;
        self.renew();
    }

    /// The series at the current point.
    #[cfg_attr(not(unoptimized), inline(always))]
    fn expand(&mut self, input: &B::Input) {
        self.is_crossing = false;
        self.expansions.expand(&self.within, &self.now, input);
    }

    /// Advances along the series.
    #[cfg_attr(not(unoptimized), inline(always))]
    fn advance(&mut self, step: f64) -> Result<(), IntegrationError<B::State>> {
        let change = increment::<B::State>(self.expansions.series().coefficients(), step);
        if self.now.advance(change, step) {
            return Ok(());
        }
        let (time, state) = (self.now.time, self.state());
        Err(IntegrationError::lost(time, state))
    }
}
