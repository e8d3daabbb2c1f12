//! The context in which the parts of a system are read: the names, the bodies.

pub mod body;
mod felt;
mod kept;
pub mod names;
pub mod reader;
