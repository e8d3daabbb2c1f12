//! The attitude of the frame of a body relative to the world.

use crate::symbolic::{Components, Id};

/// The rotation from the axes of a body to those of the world.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Attitude {
    /// The axes stay parallel.
    Fixed,
    /// A rotation by an angle about a unit vector, whose components are the same in both axes.
    Axis { angle: Id, direction: Components },
    /// A unit quaternion.
    Quaternion { scalar: Id, vector: Components },
    /// The attitude of a rod: the vector `direction` of the body, a unit vector in body axes,
    /// points along `axis`, in world axes. No other axes rotate with the rod, so all components are
    /// in world axes.
    Line {
        direction: Components,
        axis: Components,
    },
}

impl Attitude {
    /// The expressions that change as the body rotates.
    pub fn coordinates(self) -> Vec<Id> {
        match self {
            Self::Fixed => Vec::new(),
            Self::Axis { angle, .. } => vec![angle],
            Self::Quaternion { scalar, vector } => [&[scalar], &vector[..]].concat(),
            Self::Line { axis, .. } => axis.to_vec(),
        }
    }
}
