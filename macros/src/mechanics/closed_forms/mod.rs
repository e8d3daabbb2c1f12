//! Motions that are known in closed form, and which one a body has.

mod about_axis;
mod axial_torque;
mod axis_of_symmetry;
mod flow;
mod forms;
mod free_rotation;
mod lagrange_top;

pub use flow::derive_flow;
pub use forms::{Flow, Rotation};
pub use free_rotation::Free;
