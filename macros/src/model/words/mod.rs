//! The meanings of symbols, the names of expressions, and their units.

mod check;
mod dimension;
mod doubtful;
mod foreign;
mod frame;
mod labels;
mod meanings;
pub mod shown;
mod unit;

pub use check::{Answers, Check, Checks, Claim};
pub use dimension::Dimension;
pub use doubtful::{Doubtful, why_not};
pub use foreign::{ForeignConstant, ForeignFunction};
pub use frame::{Frame, FrameWord};
pub use labels::{AXES, Labels};
pub use meanings::{Meaning, Meanings, Variable};
pub use shown::shown;
pub use unit::Unit;
