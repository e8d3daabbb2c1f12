//! The runtime without the macro: motions in closed form.

mod axial_torque;
mod elliptic;
mod free_rotation;
mod lagrange_top;
mod pendulum;
#[path = "../reference/mod.rs"]
mod reference;
