//! Systems with hand-written equations, for the states that `rigid_system!` makes.
#![allow(dead_code, unused_imports, reason = "each test uses its part")]

mod assembly;
mod chain;
mod geared;
mod pendulum;

pub use assembly::{Assembly, AssemblyAcceleration, AssemblyState};
pub use chain::{CARTS, Chain, ChainAcceleration, ChainPath, ChainState};
pub use geared::{Geared, GearedAcceleration, GearedState};
pub use pendulum::{
    CENTERS, DoublePendulum, DoublePendulumAcceleration, DoublePendulumInput, DoublePendulumState,
    LENGTH, MASSES, MOMENTS,
};

use newton_euler::Scalar;

/// A constant as a scalar, made from one at hand.
#[inline(always)]
fn number<T: Scalar>(at_hand: T, value: f64) -> T {
    #[expect(clippy::cast_possible_truncation, reason = "to single precision")]
    at_hand.constant(value, value as f32)
}
