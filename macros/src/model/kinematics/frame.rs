//! Frames, and how they are turned against the world.

use crate::symbolic::{Components, Id};

/// Axes in which components are written, by index: those of the ground, and those that turn with a
/// body.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct Frame(usize);

impl Frame {
    pub const WORLD: Self = Self(0);
    pub const BODY: Self = Self(1);

    pub fn index(self) -> usize {
        self.0
    }

    /// As it is written.
    pub fn word(self) -> &'static str {
        if self == Self::WORLD { "world" } else { "body" }
    }
}

/// The rotation from the axes of a body to those of the world.
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
