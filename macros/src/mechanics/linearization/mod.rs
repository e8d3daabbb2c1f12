//! Linearization: the first derivatives of the rates of a state, on its tangent space.

mod blocks;
mod body;
mod changes;
mod sensitivity;
mod system;

pub use blocks::{Block, Linearization, Row};
pub use body::linearize_body;
pub use changes::Column;
pub use sensitivity::{sensitivity_of_body, sensitivity_of_system};
pub use system::linearize_system;
