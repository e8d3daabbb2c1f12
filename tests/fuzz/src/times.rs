//! The durations of executions: a histogram in steps of an eighth of an octave.

use std::time::Duration;

const STEPS: f64 = 8.0;
const LEAST: f64 = 1e-7;

/// Times of many executions.
#[derive(Clone, Default)]
pub struct Times {
    counts: Vec<u64>,
    longest: Duration,
}

impl Times {
    pub fn add(&mut self, time: Duration) {
        let step = (time.as_secs_f64() / LEAST).max(1.0).log2() * STEPS;
        #[allow(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "a small positive number"
        )]
        let step = step as usize;
        if step >= self.counts.len() {
            self.counts.resize(step + 1, 0);
        }
        self.counts[step] += 1;
        self.longest = self.longest.max(time);
    }

    #[must_use]
    pub fn count(&self) -> u64 {
        self.counts.iter().sum()
    }

    /// The time that this part of the executions did not exceed, to an eighth of an octave.
    #[must_use]
    #[allow(clippy::cast_precision_loss, reason = "counts are small")]
    pub fn quantile(&self, part: f64) -> Duration {
        let wanted = self.count() as f64 * part;
        let mut seen = 0;
        for (step, count) in self.counts.iter().enumerate() {
            seen += count;
            if seen as f64 >= wanted {
                return Duration::from_secs_f64(LEAST * ((step + 1) as f64 / STEPS).exp2())
                    .min(self.longest);
            }
        }
        self.longest
    }

    #[must_use]
    pub fn longest(&self) -> Duration {
        self.longest
    }
}
