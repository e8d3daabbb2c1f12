//! The context in which the parts of a system are read: the names, the bodies.

pub mod body;
mod kept;
pub mod names;
pub mod reader;
