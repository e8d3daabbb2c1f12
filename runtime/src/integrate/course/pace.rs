//! The limits of the lengths of steps.

use core::borrow::Borrow;
use core::ops::Range;

use crate::integrate::steps::setting::{self, InvalidSetting, Setting};

/// The limit of the length of steps, and additional times at which they end.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pace<L> {
    /// \[s\]
    pub(crate) max_step: f64,
    /// Times \[s\], in any order.
    pub(crate) breaks: L,
}

impl<L> Pace<L> {
    /// The time at which a step from a given time must end, if other reasons end it at `limit`.
    pub(crate) fn limit(&self, time: f64, limit: f64) -> f64 {
        let rest = limit - time;
        if self.max_step < rest.abs() {
            time + self.max_step.copysign(rest)
        } else {
            limit
        }
    }
}

impl<L: Iterator<Item: Borrow<f64>> + Clone> Pace<L> {
    /// Checks all settings of an integration, before it begins: the times, the tolerance, the
    /// setting of the method, the period of the controller, the longest step and the breaks.
    pub(crate) fn check(
        &self,
        times: &Range<f64>,
        tolerance: f64,
        method: Option<(Setting, f64)>,
        period: Option<f64>,
    ) -> Result<(), InvalidSetting> {
        let own = [
            (Setting::Tolerance, tolerance),
            (Setting::MaxStep, self.max_step),
        ];
        let period = period.map(|period| (Setting::Period, period));
        let breaks = self.breaks.clone();
        let breaks = breaks.map(|time| (Setting::Break, *time.borrow()));
        let settings = own.into_iter().chain(method).chain(period).chain(breaks);
        setting::check(times, settings)
    }
}
