//! The moving bodies, the times, and the limits of steps.

use alloc::vec::Vec;
use core::ops::Range;

use super::Members;
use crate::bodies::columns::Generic;
use crate::integrate::Pace;

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
