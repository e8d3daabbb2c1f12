//! Steady motions: the search for them, and what it finds.

mod conditions;
mod error;
mod lacking;
mod least_change;
mod newton;
mod point;
mod search;
mod slopes;
mod steady;
mod trimmed;

pub use conditions::{Condition, Conditions};
pub use error::{Off, Quantity, TrimError};
pub use search::{Search, Trim};
pub use trimmed::Trimmed;
