//! What all steps are made of: equations and where they change, points, sizes, errors, zeros within
//! a step.

pub mod agreement;
pub mod chatter;
pub mod equations;
pub mod error;
pub mod event;
pub mod instructions;
pub mod method;
pub mod point;
pub mod size;
pub mod step;
pub mod stretch;
