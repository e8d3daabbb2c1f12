//! Linearization: the first derivatives of the rates of a state, on its tangent space.

mod blocks;
mod body;
mod changes;
mod differentiated;
mod linearize;
mod system;

pub use blocks::{Block, Linearization, Row};
pub use body::differentiated_body;
pub use changes::Column;
pub use differentiated::{Differentiated, Tangent};
pub use linearize::{linearize, sensitivity};
pub use system::differentiated_system;
