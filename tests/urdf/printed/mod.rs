//! What the descriptions with files amount to, a file each.

mod arm;
mod gripper;
mod quadruped;
mod sensor;

pub use arm::*;
pub use gripper::*;
pub use quadruped::*;
pub use sensor::*;
