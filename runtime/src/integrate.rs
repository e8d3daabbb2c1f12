//! Integration of the motion, generic over bodies.
//!
//! One method of order four with fixed steps, enough to move bodies: [`cf4`], and [`cf4_projected`] for bodies under constraints. Attitudes stay rotations because states are
//! only ever moved along the group ([`State::moved`](crate::state::State::moved)).

mod commutator_free;
mod error;
mod instructions;
mod projected;
mod step;
mod taylor;

pub use commutator_free::{cf4, cf4_step};
pub use error::IntegrationError;
pub use projected::cf4_projected;
pub use step::{Event, Step};
pub use taylor::{Motion, taylor, taylor_step};

/// A number of steps: exact below 2⁵³.
#[expect(clippy::cast_precision_loss, reason = "exact below 2⁵³")]
pub(crate) fn exact(count: usize) -> f64 {
    count as f64
}

/// The same in single precision: exact below 2²⁴.
#[expect(clippy::cast_precision_loss, reason = "exact below 2²⁴")]
pub(crate) fn single(count: usize) -> f32 {
    count as f32
}
