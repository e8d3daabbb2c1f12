//! A body and its loads: mass, inertia, loads, constraints; and its names.

mod composed;
mod constraint;
mod defaults;
mod inertia;
mod load;
mod mass;
mod outline;
mod possible;
mod potential;
mod reaction;
mod solids;
mod substance;
mod unweighed;

pub use composed::{Composed, Drawn, Origin};
pub use constraint::{Constraint, Level};
pub use defaults::Defaults;
pub use inertia::{ENTRIES, Inertia, displaced};
pub use load::Load;
pub use mass::Mass;
pub use outline::{Asked, Declared, Jointed, Outline};
pub use possible::{Matrix, Violation, is_flat, is_possible, least_moment, matrix, thinnest};
pub use potential::{Along, Charges, Displaced, Form, Potential, Potentials};
pub use reaction::Reaction;
pub use solids::{SOLIDS, Solid, is_solid, words};
pub use substance::Substance;
pub use unweighed::{Shared, Unweighed, UnweighedBody};
