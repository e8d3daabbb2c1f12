//! What a joint to the ground is: all that the compiler asks of a kind of motion.

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
    /// Its state, as the runtime has it.
    pub shape: &'static Shape,
    /// The balances that it leaves out, and why.
    pub missing: Option<&'static str>,
}

/// How G moves.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Center {
    /// It has coordinates of its own.
    Free,
    /// With the body, of which a point is held in space.
    Held,
    /// That is not looked at, and where it is, is not known.
    Unmodelled,
}

/// What tells how a body is turned.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Orientation {
    /// It does not turn.
    Fixed,
    /// An angle, about one axis.
    Angle,
    /// A quaternion.
    Quaternion,
    /// The direction of its axis; how it is turned about it, is not known.
    Line,
}

impl PartialEq for Joint {
    fn eq(&self, other: &Self) -> bool {
        self.word == other.word
    }
}

impl Eq for Joint {}

impl Joint {
    /// G has coordinates of its own.
    pub fn translates(&self) -> bool {
        self.center == Center::Free
    }

    /// A point of the body is held.
    pub fn is_supported(&self) -> bool {
        self.center == Center::Held
    }

    /// Where G is, is known.
    pub fn knows_position(&self) -> bool {
        match self.center {
            Center::Free | Center::Held => true,
            Center::Unmodelled => false,
        }
    }

    /// The body turns.
    pub fn has_attitude(&self) -> bool {
        self.orientation != Orientation::Fixed
    }

    /// One angle tells how it is turned.
    pub fn has_angle(&self) -> bool {
        self.orientation == Orientation::Angle
    }

    /// It turns about an axis that is held.
    pub fn is_hinged(&self) -> bool {
        self.is_supported() && self.has_angle()
    }

    /// The axis of a hinge is written; in the plane it is z.
    pub fn has_written_axis(&self) -> bool {
        self.is_hinged() && !self.is_planar
    }

    /// Of the attitude there is the axis alone.
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
        match kind {
            LoadKind::Moment if self.is_planar => 2..3,
            LoadKind::Force | LoadKind::Moment => 0..self.axes(),
        }
    }

    /// The components along which G moves.
    pub fn linear_axes(&self) -> Range<usize> {
        match self.center {
            Center::Free => 0..self.axes(),
            Center::Held | Center::Unmodelled => 0..0,
        }
    }

    /// The components of an angular acceleration, or of that of the axis of a rod; about a hinge,
    /// that along its axis stands in the place of z.
    pub fn angular_axes(&self) -> Range<usize> {
        match self.orientation {
            Orientation::Fixed => 0..0,
            Orientation::Angle => 2..3,
            Orientation::Quaternion | Orientation::Line => 0..3,
        }
    }
}
