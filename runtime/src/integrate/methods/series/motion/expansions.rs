//! The series of a step, and the series at its end, which checks the step.

use crate::integrate::steps::instructions::Expander;
use crate::integrate::steps::point::Point;
use crate::integrate::steps::stretch::Within;
use crate::taylor::{Series, Taylor};

/// The series of the last step, and the series at its end, if it is known.
pub(super) struct Expansions<B: Taylor, const N: usize> {
    pub(super) expander: Expander<B, N>,
    both: [Series<B::State, N>; 2],
    /// Whether the second of the two is the series of the step.
    is_second: bool,
    /// Whether the other one starts at its end.
    is_ahead: bool,
}

impl<B: Taylor, const N: usize> Default for Expansions<B, N> {
    fn default() -> Self {
        Self {
            expander: Expander::best(),
            both: [Series::default(), Series::default()],
            is_second: false,
            is_ahead: false,
        }
    }
}

impl<B: Taylor, const N: usize> Expansions<B, N> {
    /// The series of the step.
    #[cfg_attr(not(unoptimized), inline(always))]
    pub(super) fn series(&self) -> &Series<B::State, N> {
        let [first, second] = &self.both;
        if self.is_second { second } else { first }
    }

    /// Called when the next step begins elsewhere, or under another input.
    pub(super) fn forget(&mut self) {
        self.is_ahead = false;
    }

    /// The series of the next step.
    #[cfg_attr(not(unoptimized), inline(always))]
    pub(super) fn expand(&mut self, body: &Within<'_, B>, now: &Point<B::State>, input: &B::Input) {
        if self.is_ahead {
            (self.is_second, self.is_ahead) = (!self.is_second, false);
            return;
        }
        let [first, second] = &mut self.both;
        let series = if self.is_second { second } else { first };
        write(&mut self.expander, body, now, input, series);
    }

    /// The series of the step, and the series at its end, which the next step uses unless
    /// it is [forgotten](Self::forget).
    #[cfg_attr(not(unoptimized), inline(always))]
    pub(super) fn ahead(
        &mut self,
        body: &Within<'_, B>,
        end: &Point<B::State>,
        input: &B::Input,
    ) -> [&Series<B::State, N>; 2] {
        self.is_ahead = true;
        let [first, second] = &mut self.both;
        let (series, ahead) = if self.is_second {
            (second, first)
        } else {
            (first, second)
        };
        write(&mut self.expander, body, end, input, ahead);
        [series, ahead]
    }
}

#[cfg_attr(not(unoptimized), inline(always))]
fn write<B: Taylor, const N: usize>(
    expander: &mut Expander<B, N>,
    body: &Within<'_, B>,
    now: &Point<B::State>,
    input: &B::Input,
    series: &mut Series<B::State, N>,
) {
    let (time, state) = (body.side(now.time), now.state());
    match body.moved(input, now.time) {
        Some(moved) => expander.expand(body.body, time, &state, &moved, series),
        None => expander.expand(body.body, time, &state, input, series),
    }
}
