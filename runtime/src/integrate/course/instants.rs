//! Times at equal intervals.

use core::ops::Range;

use crate::numbers::count::real;

/// A start, and times at equal intervals from it up to an end, inclusive.
#[derive(Clone, Debug)]
pub(crate) struct Instants {
    start: f64,
    end: f64,
    /// The interval, negative if time runs backwards \[s\].
    period: f64,
    /// The index of the next instant, and their number.
    next: usize,
    count: usize,
}

impl Instants {
    /// No instants.
    pub(crate) const NONE: Self = Self {
        start: 0.0,
        end: 0.0,
        period: 0.0,
        next: 0,
        count: 0,
    };

    /// With a period above the rounding of these times; the first instant is the start in any case.
    pub(crate) fn new(times: Range<f64>, period: f64) -> Self {
        let Range { start, end } = times;
        let intervals = (end - start).abs() / period;
        // the end is one of them, despite rounding of their number and times
        let rounding = f64::EPSILON * (end.abs() + start.abs()) / period;
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "from 0 to 2⁵³, if the period is not refused"
        )]
        let whole = (intervals * (1.0 + 1e-12) + rounding) as usize;
        Self {
            start,
            end,
            period: period.copysign(end - start),
            next: 0,
            count: whole.saturating_add(1),
        }
    }
}

impl Iterator for Instants {
    type Item = f64;

    fn next(&mut self) -> Option<f64> {
        if self.next == self.count {
            return None;
        }
        let passed = self.next;
        self.next += 1;
        if passed == 0 {
            return Some(self.start);
        }
        let time = self.start + self.period * real(passed);
        Some(if self.period > 0.0 {
            time.min(self.end)
        } else {
            time.max(self.end)
        })
    }
}
