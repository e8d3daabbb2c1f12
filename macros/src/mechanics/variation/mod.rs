//! How expressions change with time and with the place of the body.

mod changes;
mod direction;
mod leaves;
mod potential;
mod rates;
mod slopes;
mod spring_arm;
mod system;
mod unit_loads;

pub use changes::changes;
pub use direction::Direction;
pub use leaves::Leaves;
pub use potential::{Derived, with_potentials};
pub use rates::{Rates, rates};
pub use slopes::Slopes;
pub use system::with_system_potentials;
pub use unit_loads::derive_unit_loads;
