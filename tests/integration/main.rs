//! `body.integrate(state)`: every method compared with closed forms and 40-digit trajectories;
//! samples, events, inputs and errors.

#![allow(clippy::float_cmp, reason = "the same to the bit")]

mod errors;
mod inputs;
mod late;
mod lost_loads;
mod midpoint;
mod moving_inputs;
mod observations;
mod orders;
mod periods;
#[path = "../reference/mod.rs"]
mod reference;
mod scenes;
mod settings;
mod switches;
