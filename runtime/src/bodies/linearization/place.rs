//! The kinds of the coordinates of a state that precede their rates.

/// A coordinate of the tangent space that precedes the rates: its kind decides how it changes when
/// the world rotates.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    /// A component of a position, in world axes.
    Position(usize),
    /// A rotation about a body axis, for an attitude relative to the world.
    Attitude(usize),
    /// The angle of a body that is free in the plane.
    Heading,
    /// A component of the axis of a rod, in world axes.
    Axis(usize),
    /// A rotation of one body relative to another.
    Relative(usize),
    /// An angle about the axis of a joint.
    Angle,
    /// A length along the axis of a joint.
    Length,
}

impl Place {
    /// Its component index in a vector; zero for a scalar.
    pub(super) fn component(self) -> usize {
        match self {
            Self::Position(part)
            | Self::Attitude(part)
            | Self::Axis(part)
            | Self::Relative(part) => part,
            Self::Heading | Self::Angle | Self::Length => 0,
        }
    }

    /// Whether a rotation of the world rotates it, so that its rate follows.
    pub(super) fn turns(self) -> bool {
        matches!(self, Self::Attitude(_) | Self::Heading | Self::Axis(_))
    }

    /// Whether it is an angle, or equivalent to one.
    pub(super) fn is_angle(self) -> bool {
        !matches!(self, Self::Position(_) | Self::Length)
    }
}
