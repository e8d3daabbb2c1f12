//! Kinds of loads, by their keys and their nature.

use core::ops::Range;

/// The families of loads of (1.3) and (1.4), by their keys.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Family {
    Reaction,
    Joint,
    External,
    Field,
}

/// A force or a moment.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum LoadKind {
    Force,
    Moment,
}

impl LoadKind {
    /// The components of forces and linear quantities, or of moments and angular quantities: in the
    /// plane, the latter are about its normal.
    pub fn axes(self, is_planar: bool) -> Range<usize> {
        match (self, is_planar) {
            (Self::Force, true) => 0..2,
            (Self::Moment, true) => 2..3,
            (_, false) => 0..3,
        }
    }
}
