//! What integrators can make use of: symmetries, and what the accelerations depend on.

mod claims;
mod symmetry;

pub use claims::{Dependence, QUANTITIES, Structure, derive_structure};
pub use symmetry::Symmetry;
