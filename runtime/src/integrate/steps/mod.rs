//! The parts of all steps: equations and the times at which they change, points, sizes, lengths, errors,
//! zeros within a step.

pub mod agreement;
pub mod chatter;
pub mod equations;
pub mod error;
pub mod event;
pub mod instructions;
pub mod lengths;
pub mod method;
pub mod point;
pub mod setting;
pub mod size;
pub mod step;
pub mod stretch;
