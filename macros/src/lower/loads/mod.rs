//! Given and unknown loads, constraints and potentials.

mod constraint;
mod dependent;
mod link;
mod load;
mod potential;
mod reaction;
mod uniform_field;
