//! The mass of a body, as far as it is known.

use crate::symbolic::Id;

/// The mass of a body.
#[derive(Clone, Copy, Debug)]
pub enum Mass {
    /// None was given.
    Absent,
    /// It was given, and an error in it is reported.
    Reported,
    Known(Id),
}

impl Mass {
    pub fn known(self) -> Option<Id> {
        match self {
            Self::Known(mass) => Some(mass),
            Self::Absent | Self::Reported => None,
        }
    }
}
