//! Numbers: scalars, and computations that do not depend on their meaning.

pub(crate) mod brief;
pub(crate) mod count;
#[cfg(feature = "ensemble")]
pub mod lanes;
pub mod math;
pub mod scalar;
pub(crate) mod scale;
mod single;
pub(crate) mod twofold;
