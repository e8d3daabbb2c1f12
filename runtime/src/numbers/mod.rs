//! Numbers: scalars, and computations that do not depend on their meaning.

pub(crate) mod count;
#[cfg(feature = "ensemble")]
pub mod lanes;
pub mod math;
pub(crate) mod messages;
pub mod scalar;
pub(crate) mod scale;
mod single;
pub(crate) mod twofold;
