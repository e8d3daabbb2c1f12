//! Reports to the user: skipped terms, and the class of the body.

mod charges;
mod inertia_class;
mod skipped;
mod skipped_loads;

pub use charges::list_centers;
pub use inertia_class::classify;
pub use skipped::list_skipped;
