//! Joints: how they are written, which carry and which close loops, and how what they carry moves.

mod armature;
mod axes;
mod closing;
mod drawing;
pub mod driven;
pub mod joint;
mod motion;
mod told;
mod tree;
