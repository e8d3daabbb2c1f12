//! The kinds of joints, one by one.

mod ground;
mod planar;
