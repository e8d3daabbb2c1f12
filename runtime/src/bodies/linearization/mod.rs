//! Linearization: the first derivatives of the motion with respect to state and input, the steady
//! motions that Newton's method finds with them, and the modes of small motions about these.
//!
//! The space of states is a product of straight lines and rotations. To first order a state changes
//! by an element x of its tangent space: first the coordinates, then their rates, for a system
//! joint by joint, and user-defined states last:
//!
//! ```text
//! position + dr,  attitude exp(e),  angle + da,  velocity + dv,  angular_velocity + dw
//!
//! x' = A x + B u        x = (dr, e, dv, dw),   e in body axes,   u: the change of the input
//! ```
//!
//! An attitude has three coordinates, and `e' = dw - w × e`. The unit vector along the axis of a
//! rod also has three; there x is perpendicular to the axis.

mod balanced;
mod coordinated;
mod coupled;
mod matrices;
mod modes;
mod orthogonal;
mod place;
mod resolvent;
mod sensitivity;
mod tangent;
mod trim;

pub use coordinated::Coordinated;
pub use matrices::{Linearization, Linearized, place, rates_of_places};
pub use modes::{Mode, Modes};
pub use place::Place;
pub use sensitivity::{ByParams, Sensitivity};
pub use trim::{Condition, Conditions, Off, Quantity, Search, Trim, TrimError, Trimmed};
