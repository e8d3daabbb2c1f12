//! Proofs of zero, at a random state.

mod random_state;
mod zeros;

pub use random_state::RandomState;
pub use zeros::{all_vanish, cancels_in_half_turns, may_vanish, samples, vanishing};
