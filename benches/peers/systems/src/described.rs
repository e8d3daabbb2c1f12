//! The systems of `tests/reference/systems`.

#[allow(dead_code)]
#[path = "../../../../tests/systems/described.rs"]
mod described;

pub use described::*;
