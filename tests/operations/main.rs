//! Operation counts of generated code.

mod bodies;
mod potentials;
