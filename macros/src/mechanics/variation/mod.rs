//! How expressions change with time and with the place of the body.

mod potential;
mod rates;
mod spring_arm;

pub use potential::with_potentials;
pub use rates::{Rates, rates};
