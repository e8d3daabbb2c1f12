//! Loads and constraints that are zero on one side of a threshold and nonzero on the other. Nothing
//! is claimed that holds on only one side, and both sides are computed.

mod constraints;
mod loads;
mod systems;
