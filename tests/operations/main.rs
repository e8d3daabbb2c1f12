//! How many operations generated code has.

mod bodies;
mod potentials;
