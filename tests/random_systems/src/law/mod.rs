//! The law of each body separately, (1.3) and (1.4), with the loads of its joints as unknowns, in
//! 106 bits.

pub mod closed;
pub mod functions;
pub mod kind;
pub mod linear;
pub mod scene;
pub mod space;
