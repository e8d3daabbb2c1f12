//! A member in progress.

use core::ops::Range;

use crate::integrate::{Lengths, Stretch, Watch, compensated};

/// A member in progress.
#[derive(Clone, Copy)]
pub(super) struct Lane {
    /// Its index in the blocks; `None` for an empty lane.
    pub(super) member: Option<usize>,
    pub(super) state: Progress,
    pub(super) stretch: Stretch,
    pub(super) time: f64,
    /// The rounding error of the time.
    pub(super) late: f64,
    /// The time at which the next step must end.
    pub(super) limit: f64,
    /// The next step, zero if there is none, and whether it reaches the limit.
    pub(super) step: f64,
    pub(super) is_last: bool,
    pub(super) lengths: Lengths,
    pub(super) watch: Watch,
}

/// The progress of a member.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Progress {
    Going,
    There,
    Left,
}

impl Lane {
    pub(super) const EMPTY: Self = Self {
        member: None,
        state: Progress::Going,
        stretch: Stretch::ALL,
        time: 0.0,
        late: 0.0,
        limit: 0.0,
        step: 0.0,
        is_last: false,
        lengths: Lengths::NEW,
        watch: Watch::OF_A_PAIR,
    };

    /// The progress at the start.
    pub(super) fn at(member: Option<usize>, times: &Range<f64>) -> Self {
        let (time, limit) = (times.start, times.start);
        let mut watch = Watch::OF_A_PAIR;
        watch.heads_for(times.end);
        Self {
            member,
            stretch: Stretch {
                next: time,
                ..Stretch::ALL
            },
            time,
            limit,
            watch,
            ..Self::EMPTY
        }
    }

    pub(super) fn is_going(&self) -> bool {
        self.member.is_some() && self.state == Progress::Going
    }

    pub(super) fn rest(&self) -> f64 {
        (self.limit - self.time) + self.late
    }

    /// Chooses the next step; marks a member without a valid step as left.
    pub(super) fn choose(&mut self) {
        (self.step, self.is_last) = (0.0, false);
        if !self.is_going() {
            return;
        }
        let (step, is_last) = self.lengths.next(self.rest());
        let is_lost = step.is_nan() || (self.time + step) - self.time == 0.0 && !is_last;
        if is_lost || self.watch.is_due() {
            self.state = Progress::Left;
        } else {
            (self.step, self.is_last) = (step, is_last);
        }
    }

    /// Records an accepted step.
    pub(super) fn follow(&mut self) {
        self.watch.saw(self.step, self.is_last);
        (self.time, self.late) = if self.is_last {
            (self.limit, 0.0)
        } else {
            compensated(self.time, self.late, self.step)
        };
    }
}
