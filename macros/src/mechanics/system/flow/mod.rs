//! Motions of systems in closed form, joint by joint.

mod carried;
mod course;
mod obstacles;
mod output;

pub use course::{Counter, Course};
pub use output::{SystemFlow, derive_system_flow};
