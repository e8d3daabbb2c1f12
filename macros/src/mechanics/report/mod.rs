//! What is told to the user: what was skipped, and what kind of body it is.

mod charges;
mod inertia_class;
mod skipped;
mod skipped_loads;

pub use charges::list_centers;
pub use inertia_class::classify;
pub use skipped::list_skipped;
