//! What the descriptions with files amount to, a file each.

mod arm;
mod linkage;
mod quadruped;
mod swing;

pub use arm::*;
pub use linkage::*;
pub use quadruped::*;
pub use swing::*;
