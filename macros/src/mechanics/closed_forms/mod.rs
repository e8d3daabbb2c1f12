//! Motions in closed form, and their detection.

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
