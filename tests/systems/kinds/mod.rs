//! Kinds of joints, one after another.

mod ground;
mod planar;
