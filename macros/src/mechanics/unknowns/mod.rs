//! Unknown loads: reactions, drives, and the constraints that they keep.

mod consistency;
mod constrained;
mod constraint_checks;
mod constraints;
mod drives;
mod inertial;
mod inverse;
mod left_over;
mod pushes;
mod reactions;
mod rows;
mod solvability;
mod unit;

pub use consistency::{Consistency, Reach, derive_consistency, derive_reach, reached, summed_size};
pub use constrained::{Activity, activity};
pub use constraint_checks::{dependent, lost, trivial};
pub use constraints::derive_constrained;
pub use inverse::derive_inverse;
pub use reactions::derive_reactions;
pub use rows::equations;
