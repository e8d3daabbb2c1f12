//! The law of each body by itself, (1.3) and (1.4), the loads of its joints unknown, in 106 bits.

pub mod closed;
pub mod functions;
pub mod kind;
pub mod linear;
pub mod scene;
pub mod space;
