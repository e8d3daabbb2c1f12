//! The context of reading the parts of a system: the names, the bodies.

pub mod body;
mod kept;
pub mod names;
pub mod reader;
