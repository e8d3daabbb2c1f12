//! What a motion keeps at zero.

use proc_macro2::Ident;

use crate::errors::Extent;
use crate::symbolic::Id;

/// A scalar that the motion keeps at zero.
#[derive(Clone)]
pub struct Constraint {
    /// Its name; of a component of a vector, `pin.x`.
    pub name: String,
    /// The name as it was written.
    pub place: Ident,
    /// What errors underline.
    pub extent: Extent,
    pub level: Level,
    pub value: Id,
}

/// What a constraint speaks of.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Level {
    /// Of where the body is: differentiated twice.
    Position,
    /// Of how it moves: differentiated once.
    Velocity,
}

impl Level {
    /// How often it is differentiated.
    pub fn derivatives(self) -> usize {
        match self {
            Self::Position => 2,
            Self::Velocity => 1,
        }
    }
}
