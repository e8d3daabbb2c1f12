//! The vector law in twice the precision of doubles.
//!
//! Nothing here is shared with the macro or the runtime. All vectors are in world axes, and the
//! balances are those of a textbook, about G or about the held point. Unknown loads are what is
//! missing in both balances.

pub mod arithmetic;
pub mod constants;
pub mod constrained;
pub mod differences;
mod expected;
mod following;
mod inertia;
pub mod law;
#[allow(dead_code, reason = "asked for by random bodies alone")]
pub mod linearized;
pub mod loads;
pub mod number;
mod potentials;
mod regressed;
pub mod scene;
mod step;
mod tables;
pub mod unknowns;
pub mod vector;

pub use constants::Constants;
pub use expected::{Expected, expected};
