//! Loads and constraints that are nothing on one side of a number and something on the other: nothing is claimed that
//! holds on one side alone, and both sides are computed.

mod constraints;
mod loads;
