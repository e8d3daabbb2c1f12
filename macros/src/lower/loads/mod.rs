//! Given and unknown loads, constraints and potentials.

mod constraint;
mod dependent;
mod link;
mod load;
mod potential;
mod reaction;
mod states;
mod uniform_field;

pub use states::check_states;
