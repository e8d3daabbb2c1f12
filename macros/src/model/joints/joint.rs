//! A joint to the ground: everything that the compiler needs to know about a kind of motion.

use core::ops::Range;

use crate::families::LoadKind;

use super::shape::Shape;

/// A joint between a body and the ground, as `motion` says it.
#[derive(Debug)]
pub struct Joint {
    /// Its word in a description.
    pub word: &'static str,
    /// Vectors have two components and moments are scalars.
    pub is_planar: bool,
    pub center: Center,
    pub orientation: Orientation,
    /// Its state, in the runtime's types.
    pub shape: &'static Shape,
    /// The balances that it omits, and why.
    pub missing: Option<&'static str>,
}

/// The motion of G.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Center {
    /// It has its own coordinates.
    Free,
    /// It follows from the body, one point of which is held in space.
    Held,
    /// It is not modelled, and its place is unknown.
    Unmodelled,
}

/// The kind of a body's attitude.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Orientation {
    /// It does not rotate.
    Fixed,
    /// An angle, about one axis.
    Angle,
    /// A quaternion.
    Quaternion,
    /// The direction of its axis; the rotation about it is not known.
    Line,
}

impl PartialEq for Joint {
    fn eq(&self, other: &Self) -> bool {
        self.word == other.word
    }
}

impl Eq for Joint {}

impl Joint {
    /// G has its own coordinates.
    pub fn translates(&self) -> bool {
        self.center == Center::Free
    }

    /// A point of the body is held.
    pub fn is_supported(&self) -> bool {
        self.center == Center::Held
    }

    /// The position of G is known.
    pub fn knows_position(&self) -> bool {
        match self.center {
            Center::Free | Center::Held => true,
            Center::Unmodelled => false,
        }
    }

    /// The body rotates.
    pub fn has_attitude(&self) -> bool {
        self.orientation != Orientation::Fixed
    }

    /// One angle gives the attitude.
    pub fn has_angle(&self) -> bool {
        self.orientation == Orientation::Angle
    }

    /// It rotates about a held axis.
    pub fn is_hinged(&self) -> bool {
        self.is_supported() && self.has_angle()
    }

    /// The axis of a hinge is written; in the plane it is z.
    pub fn has_written_axis(&self) -> bool {
        self.is_hinged() && !self.is_planar
    }

    /// The attitude is the axis alone.
    pub fn is_line(&self) -> bool {
        self.orientation == Orientation::Line
    }

    /// The inertia is one moment: about the normal of the plane, or about every axis across a rod.
    pub fn has_one_moment(&self) -> bool {
        self.is_planar || self.is_line()
    }

    /// Number of components of a vector.
    pub fn axes(&self) -> usize {
        if self.is_planar { 2 } else { 3 }
    }

    /// The components that a load of this kind has: in the plane a moment is about the normal.
    pub fn axes_of(&self, kind: LoadKind) -> Range<usize> {
        kind.axes(self.is_planar)
    }

    /// The components along which G moves.
    pub fn linear_axes(&self) -> Range<usize> {
        match self.center {
            Center::Free => 0..self.axes(),
            Center::Held | Center::Unmodelled => 0..0,
        }
    }

    /// The components of an angular acceleration, or of that of the axis of a rod; for a hinge,
    /// the component along its axis takes the place of z.
    pub fn angular_axes(&self) -> Range<usize> {
        match self.orientation {
            Orientation::Fixed => 0..0,
            Orientation::Angle => 2..3,
            Orientation::Quaternion | Orientation::Line => 0..3,
        }
    }
}
