//! Workspace: a vector is a physical object, whatever axes its components were written in.
//!
//! A [`Vector`] is the sum of a part with components in body axes and a part with components in
//! world axes. Sums stay in the axes they were written in; only where components are read, or
//! where vectors of both kinds are multiplied, one of them is turned. So all body-fixed forces are
//! added before the one rotation, and the difference of two points of the body knows nothing of
//! where the body is (`docs/trust.md`, H9).

use crate::symbolic::{Components, Id};

/// Axes in which components are written.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Frame {
    Body,
    World,
}

impl Frame {
    pub fn other(self) -> Self {
        match self {
            Self::Body => Self::World,
            Self::World => Self::Body,
        }
    }

    /// As it is written.
    pub fn word(self) -> &'static str {
        match self {
            Self::Body => "body",
            Self::World => "world",
        }
    }
}

/// The rotation from body axes to world axes.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Attitude {
    /// The axes stay parallel.
    Fixed,
    /// A rotation by an angle about a unit vector, which is the same in both axes.
    Axis { angle: Id, direction: Components },
    /// A unit quaternion.
    Quaternion { scalar: Id, vector: Components },
    /// That of a rod: one direction of the body, a unit vector in body axes, is along `axis`, in
    /// world axes. No other axes turn with it: all components are written in those of the world.
    Line {
        direction: Components,
        axis: Components,
    },
}

/// A physical vector: the sum of its two parts.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Vector {
    pub body: Components,
    pub world: Components,
}
