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
use crate::integrate::IntegrationError;
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
