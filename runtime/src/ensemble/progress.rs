//! Long runs with a bar on standard error.

use core::ops::Range;

use indicatif::{ProgressBar, ProgressStyle};

use super::Ensemble;
use crate::bodies::columns::Generic;

impl<B: Generic> Ensemble<B> {
    /// Like [`Self::cf4`], with a progress bar on standard error that shows the completed steps and
    /// the remaining time. Nothing is shown if standard error is not a terminal.
    pub fn cf4_with_progress(&mut self, times: Range<f64>, steps: usize) {
        let bar = ProgressBar::new(steps as u64).with_style(style());
        self.cf4_observed(times, steps, |done| bar.set_position(done as u64));
        bar.finish_and_clear();
    }
}

fn style() -> ProgressStyle {
    let template = "{bar:40} {pos}/{len} steps, {eta} left";
    ProgressStyle::with_template(template).unwrap_or_else(|_| ProgressStyle::default_bar())
}
