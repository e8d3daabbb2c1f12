//! Joints: their syntax, which of them carry bodies and which close loops, and the motion of the
//! carried bodies.

mod armature;
mod axes;
mod closing;
mod drawing;
pub mod driven;
pub mod joint;
mod motion;
mod motion_values;
mod tree;

pub use armature::armatures;
