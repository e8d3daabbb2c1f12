//! The context in which the parts of a system are read: the names, the bodies.

pub mod body;
mod constraints;
mod following_loads;
pub mod names;
pub mod reader;
