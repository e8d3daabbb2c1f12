//! Lowering: from what was written to what was meant.

mod definitions;
mod description;
mod expressions;
mod inertia;
mod loads;

pub use definitions::outline;
pub use description::lower_description;
