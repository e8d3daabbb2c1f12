//! The moving bodies, the times, and the limits of steps.

use alloc::vec::Vec;
use core::ops::Range;

use super::Members;
use crate::bodies::body::RigidBody;
use crate::bodies::columns::Generic;
use crate::integrate::{Pace, Situation, Stretch};

/// The limits of the steps of all members.
#[derive(Clone, Debug, PartialEq)]
pub struct Limits {
    /// The largest step \[s\].
    pub max_step: f64,
    /// Steps end at these times \[s\], in any order.
    pub breaks: Vec<f64>,
    /// The time at which the inputs were given, and the time until which they are held \[s\].
    pub held: Range<f64>,
    /// The end of the motion \[s\].
    pub end: f64,
    /// Whether time runs forwards.
    pub forwards: bool,
}

impl Limits {
    pub(super) fn pace(&self) -> Pace<core::slice::Iter<'_, f64>> {
        Pace {
            max_step: self.max_step,
            breaks: self.breaks.iter(),
        }
    }

    /// Whether a time comes before another.
    pub(super) fn is_before(&self, time: f64, other: f64) -> bool {
        if self.forwards {
            time < other
        } else {
            time > other
        }
    }

    /// What the run of a member is subject to.
    pub(super) fn of<'s, B: RigidBody>(
        &'s self,
        body: &'s B,
        input: &'s B::Input,
        pace: &'s Pace<core::slice::Iter<'s, f64>>,
    ) -> Situation<'s, B, core::slice::Iter<'s, f64>> {
        Situation {
            body,
            input,
            pace,
            held_until: self.held.end,
            end: self.end,
            forwards: self.forwards,
        }
    }

    /// The end of the next step of a member, before which its equations do not change; `None` if
    /// they change at a period lost in rounding. A stretch that is over is replaced.
    #[cfg_attr(not(unoptimized), inline(always))]
    pub(super) fn until<L: RigidBody>(
        &self,
        (body, input): (&L, &L::Input),
        stretch: &mut Stretch,
        now: f64,
        lane: usize,
    ) -> Option<f64> {
        let (held_until, end, forwards) = (self.held.end, self.end, self.forwards);
        if !self.is_before(now, stretch.next) {
            let given = stretch.given;
            let next = Stretch::of(body, input, (now, forwards, lane), self.breaks.iter());
            next.check(&(now..end)).ok()?;
            *stretch = Stretch { given, ..next };
        }
        let next = stretch.next;
        let limit = if forwards {
            next.min(held_until.min(end))
        } else {
            next.max(held_until.max(end))
        };
        Some(self.pace().limit(now, limit))
    }
}

/// The bodies, the method and the times.
pub(super) struct Plan<'e, M, B: Generic> {
    pub(super) method: M,
    pub(super) members: &'e Members<B>,
    /// The block of the first rows.
    pub(super) first: usize,
    /// From the start of all members whose motions are not kept to the end of the last step, or to a
    /// time within it.
    pub(super) times: Range<f64>,
    pub(super) limits: &'e Limits,
}
