//! Loads, unknown ones, constraints and potentials.

mod constraint;
mod dependent;
mod link;
mod load;
mod potential;
mod reaction;
mod uniform_field;
