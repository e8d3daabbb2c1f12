//! A joint to the ground: everything that the compiler needs to know about a kind of motion.

use core::ops::Range;

use crate::families::LoadKind;

use super::shape::Shape;

/// A joint between a body and the ground, as `motion` names it.
#[derive(Debug)]
pub struct Joint {
    /// Its word in a description.
    pub word: &'static str,
    /// Whether vectors have two components and moments are scalars.
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
    /// It follows from the attitude, since one point of the body is held in space.
    Held,
    /// It is not modeled, and its place is unknown.
    Unmodeled,
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
    /// Whether G has its own coordinates.
    pub fn translates(&self) -> bool {
        self.center == Center::Free
    }

    /// Whether a point of the body is held.
    pub fn is_supported(&self) -> bool {
        self.center == Center::Held
    }

    /// Whether the position of G is known.
    pub fn knows_position(&self) -> bool {
        match self.center {
            Center::Free | Center::Held => true,
            Center::Unmodeled => false,
        }
    }

    /// Whether the body rotates.
    pub fn has_attitude(&self) -> bool {
        self.orientation != Orientation::Fixed
    }

    /// Whether a single angle gives the attitude.
    pub fn has_angle(&self) -> bool {
        self.orientation == Orientation::Angle
    }

    /// Whether the body rotates about a held axis.
    pub fn is_hinged(&self) -> bool {
        self.is_supported() && self.has_angle()
    }

    /// Whether the body rotates about an axis that is written; in the plane, the axis is always z.
    pub fn has_written_axis(&self) -> bool {
        self.is_hinged() && !self.is_planar
    }

    /// Whether the attitude is only an axis.
    pub fn is_line(&self) -> bool {
        self.orientation == Orientation::Line
    }

    /// Whether the inertia is a single moment: about the normal of the plane, or about every axis
    /// across a rod.
    pub fn has_one_moment(&self) -> bool {
        self.is_planar || self.is_line()
    }

    /// The number of components of a vector.
    pub fn axes(&self) -> usize {
        if self.is_planar { 2 } else { 3 }
    }

    /// The indices of the components that a load of this kind has. In the plane, a moment is about
    /// the normal.
    pub fn axes_of(&self, kind: LoadKind) -> Range<usize> {
        kind.axes(self.is_planar)
    }

    /// The indices of the components along which G moves.
    pub fn linear_axes(&self) -> Range<usize> {
        match self.center {
            Center::Free => 0..self.axes(),
            Center::Held | Center::Unmodeled => 0..0,
        }
    }

    /// The indices of the components of the angular acceleration; for a rod, of the acceleration of
    /// its axis. For a hinge, the component along its axis takes the place of z.
    pub fn angular_axes(&self) -> Range<usize> {
        match self.orientation {
            Orientation::Fixed => 0..0,
            Orientation::Angle => 2..3,
            Orientation::Quaternion | Orientation::Line => 0..3,
        }
    }
}
