//! User-defined states: scalars that are integrated with the motion.

use crate::symbolic::{Coordinate, Id};

/// A state, and its rate.
#[derive(Clone)]
pub struct Own {
    pub name: String,
    pub symbol: Id,
    /// Its time derivative, a function of the state, inputs and time.
    pub rate: Id,
}

impl Own {
    /// The state as a coordinate that moves with its rate.
    pub fn coordinate(&self) -> Coordinate {
        Coordinate {
            symbol: self.symbol,
            rate: self.rate,
        }
    }

    /// The name of its rate, and the rate.
    pub fn named_rate(&self) -> (String, Vec<Id>) {
        (format!("{}_rate", self.name), vec![self.rate])
    }
}
