//! States of one's own: scalars that are integrated beside the motion.

use crate::symbolic::{Coordinate, Id};

/// A state, and what it changes by.
#[derive(Clone)]
pub struct Own {
    pub name: String,
    pub symbol: Id,
    /// Per second: of the state, inputs and time.
    pub rate: Id,
}

impl Own {
    /// It, as a coordinate of the motion.
    pub fn coordinate(&self) -> Coordinate {
        Coordinate {
            symbol: self.symbol,
            rate: self.rate,
        }
    }

    /// Its rate, by its name.
    pub fn named_rate(&self) -> (String, Vec<Id>) {
        (format!("{}_rate", self.name), vec![self.rate])
    }
}
