//! What the parts of a system are read with: the names, the bodies.

pub mod body;
mod kept;
pub mod names;
pub mod reader;
