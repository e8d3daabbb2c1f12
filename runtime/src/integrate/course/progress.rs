//! A bar on standard error that shows the progress of a motion.

use core::ops::Range;
use core::sync::atomic::{AtomicU64, Ordering};
use core::time::Duration;
use std::sync::OnceLock;
use std::time::Instant;

use indicatif::{ProgressBar, ProgressStyle};

/// The number of parts of the bar.
const PARTS: u32 = 1000;

/// Motions that take less have no bar.
const PATIENCE: Duration = Duration::from_secs(1);

/// A bar for a span of time.
#[derive(Debug)]
pub(crate) struct Bar {
    begun: Instant,
    shown_as: OnceLock<ProgressBar>,
    span: Range<f64>,
    /// The part shown last.
    shown: AtomicU64,
}

impl Bar {
    pub(crate) fn new(span: Range<f64>) -> Self {
        Self {
            begun: Instant::now(),
            shown_as: OnceLock::new(),
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
        if part == self.shown.swap(part, Ordering::Relaxed) {
            return;
        }
        let elapsed = self.begun.elapsed();
        if elapsed >= PATIENCE {
            let bar = self.shown_as.get_or_init(|| bar(elapsed));
            bar.set_position(part);
        }
    }
}

/// A bar that knows how long the motion has taken.
fn bar(elapsed: Duration) -> ProgressBar {
    let style = ProgressStyle::with_template("{bar:40} {percent} %, {eta} left");
    let style = style.unwrap_or_else(|_| ProgressStyle::default_bar());
    let bar = ProgressBar::new(u64::from(PARTS)).with_style(style);
    bar.with_elapsed(elapsed)
}

impl Drop for Bar {
    fn drop(&mut self) {
        if let Some(bar) = self.shown_as.get() {
            bar.finish_and_clear();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_long_motions_have_a_bar() {
        let mut bar = Bar::new(0.0..2.0);
        bar.show(1.0);
        assert!(bar.shown_as.get().is_none());
        bar.begun -= PATIENCE;
        bar.show(1.0);
        assert!(bar.shown_as.get().is_none(), "there is nothing new to show");
        bar.show(1.5);
        assert_eq!(bar.shown_as.get().map(ProgressBar::position), Some(750));
    }
}
