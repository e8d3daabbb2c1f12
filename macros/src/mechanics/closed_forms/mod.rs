//! Motions in closed form, and how they are found.

mod about_axis;
mod axial_torque;
mod axis_of_symmetry;
mod constants;
mod flow;
mod forms;
mod free_rotation;
mod gyrostat;
mod lagrange_top;
mod solid;

pub use about_axis::swing;
pub use constants::{at_rest, constants};
pub use flow::{derive_flow, symmetric};
pub use forms::{Flow, Rotation, dependence};
pub use free_rotation::{Free, free};
pub use gyrostat::{Gyrostat, Turning};
pub use solid::Solid;
