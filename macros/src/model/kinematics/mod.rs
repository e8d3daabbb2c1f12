//! Frames, vectors in them, the state of a body and how it moves; and the workspace that they are
//! worked out in.

mod frame;
mod line;
mod point;
mod state;
pub mod turned_vector;
mod turning;
mod workspace;

pub use frame::{Attitude, Frame, Vector};
pub use point::Point;
pub use state::{Axis, State, Support, state_symbols};
pub use turned_vector::{Turn, Turns};
pub use workspace::Workspace;
