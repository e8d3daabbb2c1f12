//! What the parts of a system are read with: the names, the bodies.

pub mod body;
pub mod names;
pub mod reader;
