//! Integration of the motion, generic over bodies.
//!
//! One method of order four with fixed steps, enough to move bodies: [`cf4`]. Attitudes stay rotations because states are
//! only ever moved along the group ([`State::moved`](crate::state::State::moved)).

mod commutator_free;

pub use commutator_free::{cf4, cf4_step};
