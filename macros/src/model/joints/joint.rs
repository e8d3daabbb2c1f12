//! What a joint to the ground is: all that the compiler asks of a kind of motion.

/// A joint between a body and the ground, as `motion` says it.
#[derive(Debug)]
pub struct Joint {
    /// Its word in a description.
    pub word: &'static str,
    /// Vectors have two components and moments are scalars.
    pub is_planar: bool,
    /// G has coordinates of its own.
    pub translates: bool,
    pub orientation: Orientation,
    pub held: Held,
    /// Where G is, is known.
    pub knows_position: bool,
    /// The runtime's type of its state.
    pub state: &'static str,
    /// The runtime's type of its acceleration, where that is linear and angular.
    pub acceleration: Option<&'static str>,
    /// The balances that it leaves out, and why.
    pub missing: Option<&'static str>,
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

/// What of a body is held in space.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Held {
    Nothing,
    Point,
    /// A point, and the axis through it.
    Axis,
}

impl PartialEq for Joint {
    fn eq(&self, other: &Self) -> bool {
        self.word == other.word
    }
}

impl Eq for Joint {}

impl Joint {
    /// A point of the body is held.
    pub fn is_supported(&self) -> bool {
        self.held != Held::Nothing
    }

    /// The body turns about one axis, by an angle.
    pub fn is_hinged(&self) -> bool {
        self.held == Held::Axis
    }

    /// The axis of a hinge is written; in the plane it is z.
    pub fn has_written_axis(&self) -> bool {
        self.is_hinged() && !self.is_planar
    }

    /// The body turns.
    pub fn has_attitude(&self) -> bool {
        self.orientation != Orientation::Fixed
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
}
