//! Constraints of a motion.

use proc_macro2::Ident;

use crate::errors::Extent;
use crate::symbolic::Id;

/// A scalar that the motion keeps at zero.
#[derive(Clone)]
pub struct Constraint {
    /// Its name; for a component of a vector, `pin.x`.
    pub name: String,
    /// The name in the description.
    pub place: Ident,
    /// The part that errors underline.
    pub extent: Extent,
    pub level: Level,
    pub value: Id,
    /// The user-defined states that it follows, each at its first place.
    pub states: Vec<(Id, Extent)>,
}

/// The level of a constraint.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Level {
    /// On the place of the body: differentiated twice.
    Position,
    /// On its motion: differentiated once.
    Velocity,
}

impl Level {
    /// The number of differentiations.
    pub fn derivatives(self) -> usize {
        match self {
            Self::Position => 2,
            Self::Velocity => 1,
        }
    }
}
