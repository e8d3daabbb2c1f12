//! `outputs: [linearization]`: A and B of bodies and systems of every kind beside dual numbers.
#![allow(clippy::float_cmp, reason = "what is exact is compared exactly")]

mod bodies;
mod oracle;
mod own;
mod systems;
