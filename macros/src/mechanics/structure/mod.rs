//! Properties for integrators: symmetries, and dependencies of the accelerations.

mod claims;
mod symmetry;

pub use claims::{Dependence, QUANTITIES, Structure, derive_structure};
pub use symmetry::Symmetry;
