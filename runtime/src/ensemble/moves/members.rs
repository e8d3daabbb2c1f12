//! All members: their division among threads, their count, and the errors of those that do not
//! reach the end.

use alloc::vec::Vec;
use core::fmt;
#[cfg(not(feature = "rayon"))]
use core::ops::Range;
use core::sync::atomic::{AtomicUsize, Ordering};

#[cfg(feature = "rayon")]
use rayon::iter::IntoParallelIterator as _;

use crate::bodies::columns::Columns;
use crate::ensemble::blocks::Blocks;
use crate::integrate::{IntegrationError, InvalidSetting};
use crate::numbers::count::real;
use crate::numbers::messages::debug_as_display;

/// A member whose motion ended early.
#[derive(Clone, Copy, PartialEq)]
pub struct MemberError<S> {
    /// The index of the member, from zero.
    pub index: usize,
    /// The reason, with the last good state.
    pub error: IntegrationError<S>,
}

impl<S> fmt::Display for MemberError<S> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "member {}: {}", self.index, self.error)
    }
}

debug_as_display!(MemberError<S>);

impl<S: 'static> core::error::Error for MemberError<S> {
    fn source(&self) -> Option<&(dyn core::error::Error + 'static)> {
        Some(&self.error)
    }
}

/// The error of an integration of all members.
#[derive(Clone, Copy, PartialEq)]
pub enum EnsembleError<S> {
    /// A setting that concerns all members is impossible. None has moved, unless the period of
    /// a controller is lost in the rounding of a later time.
    Setting(InvalidSetting),
    /// A member does not reach the end.
    Member(MemberError<S>),
}

impl<S> EnsembleError<S> {
    /// The error of a member, if it is one.
    #[must_use]
    pub fn member(&self) -> Option<&MemberError<S>> {
        match self {
            Self::Setting(_) => None,
            Self::Member(error) => Some(error),
        }
    }
}

impl<S> From<InvalidSetting> for EnsembleError<S> {
    fn from(invalid: InvalidSetting) -> Self {
        Self::Setting(invalid)
    }
}

impl<S> From<MemberError<S>> for EnsembleError<S> {
    fn from(error: MemberError<S>) -> Self {
        Self::Member(error)
    }
}

impl<S> fmt::Display for EnsembleError<S> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Setting(invalid) => invalid.fmt(f),
            Self::Member(error) => error.fmt(f),
        }
    }
}

debug_as_display!(EnsembleError<S>);

impl<S: 'static> core::error::Error for EnsembleError<S> {
    fn source(&self) -> Option<&(dyn core::error::Error + 'static)> {
        match self {
            Self::Setting(_) => None,
            Self::Member(error) => error.source(),
        }
    }
}

/// Stores the final states of members; returns the members that did not reach the end.
pub(super) fn put<S: Columns<f64>>(
    states: &mut Blocks<S>,
    ends: impl Iterator<Item = (usize, Result<S, IntegrationError<S>>)>,
) -> Vec<MemberError<S>> {
    let mut lost = Vec::new();
    for (index, end) in ends {
        match end {
            Ok(end) => states.set(index, &end),
            Err(error) => lost.push(MemberError { index, error }),
        }
    }
    lost
}

/// The number of completed members, and the observer.
pub(super) struct Done<F> {
    count: AtomicUsize,
    all: usize,
    observer: F,
}

impl<F: Fn(f64)> Done<F> {
    pub(super) fn of(all: usize, observer: F) -> Self {
        Self {
            count: AtomicUsize::new(0),
            all,
            observer,
        }
    }

    pub(super) fn add(&self, members: usize) {
        let before = self.count.fetch_add(members, Ordering::Relaxed);
        (self.observer)(real((before + members).min(self.all)) / real(self.all));
    }
}

/// All members, in all threads.
#[cfg(feature = "rayon")]
pub(in crate::ensemble) fn indices(count: usize) -> rayon::range::Iter<usize> {
    (0..count).into_par_iter()
}

/// All members.
#[cfg(not(feature = "rayon"))]
pub(in crate::ensemble) fn indices(count: usize) -> Range<usize> {
    0..count
}
