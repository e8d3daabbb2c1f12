//! Properties for integrators: symmetries of the accelerations, and what these depend on.

mod claims;
mod symmetry;

pub use claims::{Dependence, QUANTITIES, Structure, derive_structure};
pub use symmetry::Symmetry;
