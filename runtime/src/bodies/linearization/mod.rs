//! Linearisation: what the motion changes by, to first order, with state and input; the steady
//! motions that Newton's method finds with it, and how the motion swings about them.
//!
//! The space of states is a product of straight lines and rotations; to first order a state changes
//! by an element x of its tangent space, what comes before the rates first and the rates behind it,
//! of a system joint by joint, and states of one's own last:
//!
//! ```text
//! position + dr,  attitude exp(e),  angle + da,  velocity + dv,  angular_velocity + dw
//!
//! x' = A x + B u        x = (dr, e, dv, dw),   e in body axes,   u: the change of the input
//! ```
//!
//! An attitude has three coordinates, and `e' = dw - w × e`. What a rod has instead, the unit vector
//! along its axis, has three as well; x is across the axis there.

mod conditions;
mod coordinated;
mod least_change;
mod matrices;
mod modes;
mod orthogonal;
mod place;
mod sensitivity;
mod steady;
mod tangent;
mod trim;
mod trim_error;

pub use conditions::{Condition, Conditions};
pub use coordinated::Coordinated;
pub use matrices::{Linearization, Linearized, place, rates_of_places};
pub use modes::{Mode, Modes};
pub use place::Place;
pub use sensitivity::Sensitivity;
pub use trim::{Search, Trim, Trimmed};
pub use trim_error::{Off, TrimError};
