//! User-defined states, integrated with the motion: motors, controllers, fuel.
#![allow(clippy::float_cmp, reason = "what is exact is compared exactly")]

mod bodies;
mod controller;
mod kinds;
mod led;
mod motors;
mod potentials;
mod prescribed;
mod structure;
mod together;
mod written;

use newton_euler::state::Coordinates;

/// The largest difference of two lists of coordinates.
fn distance<S: Coordinates<Scalar = f64>>(a: &S, b: &S) -> f64 {
    let (a, b) = (a.coordinates(), b.coordinates());
    let pairs = a.as_ref().iter().zip(b.as_ref());
    pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}
