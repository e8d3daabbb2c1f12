//! Numbers: scalars and what is computed with them, whatever they measure.

pub(crate) mod count;
#[cfg(feature = "ensemble")]
pub mod lanes;
pub mod math;
pub mod scalar;
pub(crate) mod scale;
pub(crate) mod twofold;
