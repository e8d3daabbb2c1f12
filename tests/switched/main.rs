//! Loads and constraints that are zero on one side of a threshold and nonzero on the other: nothing
//! is claimed that holds on one side alone, and both sides are computed.

mod constraints;
mod loads;
