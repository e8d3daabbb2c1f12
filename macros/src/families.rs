//! Kinds of loads: the keys they are written under, and whether they are forces or moments.

use core::ops::Range;

/// The families of loads in (1.3) and (1.4), by the keys they are written under.
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
    /// The indices of the components of forces and linear quantities, or of moments and angular
    /// quantities. In the plane, the latter are about the normal.
    pub fn axes(self, is_planar: bool) -> Range<usize> {
        match (self, is_planar) {
            (Self::Force, true) => 0..2,
            (Self::Moment, true) => 2..3,
            (_, false) => 0..3,
        }
    }
}
