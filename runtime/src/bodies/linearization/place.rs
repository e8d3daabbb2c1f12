//! What the coordinates of a state are, before their rates.

/// A coordinate of the tangent space, of those that come before the rates: what it does as the world is
/// turned.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    /// A component of a position, in world axes.
    Position(usize),
    /// A turn about a body axis, of a body whose attitude is to the world.
    Attitude(usize),
    /// The angle of a body that is free in the plane.
    Heading,
    /// A component of the axis of a rod, in world axes.
    Axis(usize),
    /// A turn of one body in another.
    Relative(usize),
    /// An angle about the axis of a joint.
    Angle,
    /// A length along the axis of a joint.
    Length,
}

impl Place {
    /// Which component of a vector it is; none of one.
    pub(super) fn component(self) -> usize {
        match self {
            Self::Position(part)
            | Self::Attitude(part)
            | Self::Axis(part)
            | Self::Relative(part) => part,
            Self::Heading | Self::Angle | Self::Length => 0,
        }
    }

    /// Whether a turn of the world turns it, so that its rate follows.
    pub(super) fn turns(self) -> bool {
        matches!(self, Self::Attitude(_) | Self::Heading | Self::Axis(_))
    }

    /// Whether it is an angle, or as good as one.
    pub(super) fn is_angle(self) -> bool {
        !matches!(self, Self::Position(_) | Self::Length)
    }
}
