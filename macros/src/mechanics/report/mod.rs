//! Reports to the user: skipped terms, and the class of the body.

mod charges;
mod inertia_class;
mod laws;
mod skipped;
mod skipped_loads;

pub use charges::list_centers;
pub use inertia_class::classify;
pub use laws::{Law, Left, Part, Term, list_laws, list_laws_of_system};
pub use skipped::list_skipped;
