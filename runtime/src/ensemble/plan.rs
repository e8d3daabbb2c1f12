//! The moving bodies, the times, and the limits of steps.

use alloc::vec::Vec;
use core::ops::Range;

use super::Members;
use crate::bodies::body::RigidBody;
use crate::bodies::columns::Generic;
use crate::integrate::{Pace, Stretch};

/// The limits of the steps of all members.
#[derive(Clone, Debug, PartialEq)]
pub struct Limits {
    /// The largest step \[s\].
    pub max_step: f64,
    /// Steps end at these times \[s\], in any order.
    pub breaks: Vec<f64>,
    /// The time at which the inputs were given \[s\].
    pub given: f64,
}

impl Limits {
    pub(super) fn pace(&self) -> Pace<core::slice::Iter<'_, f64>> {
        Pace {
            max_step: self.max_step,
            breaks: self.breaks.iter(),
        }
    }

    /// The time up to which the equations of a member do not change, at most the end; `None` if they
    /// change at a period lost in rounding. A stretch that is over is replaced.
    #[cfg_attr(not(unoptimized), inline(always))]
    pub(super) fn until<L: RigidBody>(
        &self,
        (body, input): (&L, &L::Input),
        stretch: &mut Stretch,
        (now, end, forwards): (f64, f64, bool),
        lane: usize,
    ) -> Option<f64> {
        let is_before = |time: f64| if forwards { now < time } else { now > time };
        if !is_before(stretch.next) {
            *stretch = Stretch::of(body, input, (now, forwards, lane), self.breaks.iter());
            stretch.check(&(now..end)).ok()?;
        }
        let next = stretch.next;
        Some(if forwards {
            next.min(end)
        } else {
            next.max(end)
        })
    }
}

/// The bodies, the method and the times.
pub(super) struct Plan<'e, M, B: Generic> {
    pub(super) method: M,
    pub(super) members: &'e Members<B>,
    /// The block of the first rows.
    pub(super) first: usize,
    pub(super) times: Range<f64>,
    pub(super) limits: &'e Limits,
}
