//! What the descriptions with files amount to, a file each.

mod arm;
mod classes;
mod coupled;
mod linkage;
mod quadruped;
mod swing;

pub use arm::*;
pub use classes::*;
pub use coupled::*;
pub use linkage::*;
pub use quadruped::*;
pub use swing::*;
