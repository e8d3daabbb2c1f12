//! Constraints of a motion.

use proc_macro2::Ident;

use crate::errors::Extent;
use crate::symbolic::Id;

/// A scalar that the motion keeps at zero.
#[derive(Clone)]
pub struct Constraint {
    /// Its name, such as `pin.x` for a component of a vector.
    pub name: String,
    /// The name in the description.
    pub place: Ident,
    /// The part that errors underline.
    pub extent: Extent,
    pub level: Level,
    pub value: Id,
    /// The user-defined states that it depends on, each with the place where it is first mentioned.
    pub states: Vec<(Id, Extent)>,
}

/// What a constraint restricts.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Level {
    /// The place of the body: it is differentiated twice.
    Position,
    /// The velocities of the body: it is differentiated once.
    Velocity,
}

impl Level {
    /// How often the constraint is differentiated.
    pub fn derivatives(self) -> usize {
        match self {
            Self::Position => 2,
            Self::Velocity => 1,
        }
    }
}
