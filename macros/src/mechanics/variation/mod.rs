//! How expressions change with time and with the place of the body.

mod direction;
mod potential;
mod rates;
mod slopes;
mod spring_arm;
mod system;

pub use direction::Direction;
pub use potential::with_potentials;
pub use rates::{Rates, rates};
pub use system::with_system_potentials;
