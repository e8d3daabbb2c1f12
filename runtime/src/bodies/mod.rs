//! Bodies: their interface to integrators, their outputs, and their compile-time properties.

pub mod body;
pub mod columns;
pub mod constrained;
mod facing;
pub mod linearization;
pub mod operations;
pub(crate) mod path;
pub(crate) mod projection;
pub mod structure;
pub(crate) mod switches;
