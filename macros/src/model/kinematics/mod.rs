//! Frames, vectors in them, the state of a body and its motion; and the workspace for all of
//! them.

mod algebra;
mod attitude;
mod line;
mod own;
mod pair;
mod point;
mod state;
pub mod turned_vector;
mod turning;
mod vector;
mod workspace;

pub use attitude::Attitude;
pub use own::Own;
pub use pair::Pair;
pub use point::Point;
pub use state::{Axis, State, Support, state_symbols};
pub use turned_vector::{Turn, Turns};
pub use vector::Vector;
pub use workspace::Workspace;
