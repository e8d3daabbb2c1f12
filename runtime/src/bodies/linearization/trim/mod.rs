//! Steady motions: the search for them, and what it finds.

mod conditions;
mod error;
mod least_change;
mod point;
mod search;
mod steady;
mod trimmed;

pub use conditions::{Condition, Conditions};
pub use error::{Off, TrimError};
pub use search::{Search, Trim};
pub use trimmed::Trimmed;
