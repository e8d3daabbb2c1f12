//! A bar on standard error that shows the progress of a motion.

use core::ops::Range;
use core::sync::atomic::{AtomicU64, Ordering};

use indicatif::{ProgressBar, ProgressStyle};

/// The number of parts of the bar.
const PARTS: u32 = 1000;

/// A bar for a span of time.
#[derive(Debug)]
pub(crate) struct Bar {
    shown_as: ProgressBar,
    span: Range<f64>,
    /// The part shown last.
    shown: AtomicU64,
}

impl Bar {
    pub(crate) fn new(span: Range<f64>) -> Self {
        let style = ProgressStyle::with_template("{bar:40} {percent} %, {eta} left");
        let style = style.unwrap_or_else(|_| ProgressStyle::default_bar());
        Self {
            shown_as: ProgressBar::new(u64::from(PARTS)).with_style(style),
            span,
            shown: AtomicU64::new(0),
        }
    }

    /// Shows the progress at a time.
    pub(crate) fn show(&self, time: f64) {
        let part = (time - self.span.start) / (self.span.end - self.span.start);
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "what is no part is shown as zero"
        )]
        let part = (part * f64::from(PARTS)) as u64;
        if part != self.shown.swap(part, Ordering::Relaxed) {
            self.shown_as.set_position(part);
        }
    }
}

impl Drop for Bar {
    fn drop(&mut self) {
        self.shown_as.finish_and_clear();
    }
}
