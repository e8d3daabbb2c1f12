//! The equations of a system, and what else is asked of it, from its tree of bodies.

mod equations;
mod loads;
mod series;
mod totals;

pub use equations::{SystemEquations, derive_system, describe_system};
pub use loads::{derive_system_inverse, derive_system_reactions};
pub use series::derive_system_taylor;
pub use totals::{derive_system_energy, derive_system_momentum};
