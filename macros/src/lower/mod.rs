//! Lowering: from the written description to its meaning.

mod definitions;
mod description;
mod expressions;
mod inertia;
mod loads;
mod system;

pub use definitions::{FLOW, INVERSE, LINEARIZATION, Offer, REGRESSOR};
pub use description::{outline, read_body};
pub use expressions::{is_drive, is_unknown};
pub use system::{outline_system, read_system, targets};
