//! Taylor series of motions, and their integrator.
#![allow(missing_docs, reason = "tests")]
#![allow(clippy::cast_precision_loss, reason = "orders and numbers of steps")]
#![allow(clippy::float_cmp, reason = "what is exact is compared exactly")]

mod choice;
mod constrained;
mod despun;
mod events;
mod functions;
mod motions;
mod moving;
mod products;
#[path = "../reference/mod.rs"]
mod reference;
mod rough;
mod scenes;
mod trajectories;
