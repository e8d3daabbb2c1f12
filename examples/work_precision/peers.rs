//! What else one would reach for, in Rust. Each is a function from a problem to a method, and a line in the lists.

mod buss;
mod dop853;
mod jolt;
mod moser_veselov;
mod munthe_kaas;
mod runge_kutta;
mod splitting;

use newton_euler::prelude::*;
use newton_euler::state::Coordinates;

use crate::by_hand::{Load, Turning};
use crate::method::Method;
use crate::problem::Problem;
pub use runge_kutta::Renormalized;

/// The peers for any body of N coordinates: `generated` is the one that was described, `by_hand` the same without the macro.
pub fn general<'p, const N: usize, S, B, C>(
    generated: &'p Problem<B>,
    by_hand: &'p Problem<C>,
) -> Vec<Method<'p, S>>
where
    S: Coordinates<Scalar = f64> + Renormalized,
    B: RigidBody<Scalar = f64, State = S, Input = ()>,
    C: RigidBody<Scalar = f64, State = S, Input = ()>,
{
    vec![
        dop853::method::<_, N>(DOP853, by_hand),
        dop853::method::<_, N>("DOP853 of the crate, generated", generated),
        runge_kutta::method(by_hand),
    ]
}

/// Those for bodies that only turn.
pub fn turning<L: Load>(problem: &Problem<Turning<L>>) -> Vec<Method<'_, Rotation>> {
    vec![
        munthe_kaas::method(problem),
        splitting::method(problem),
        buss::method(problem),
        moser_veselov::method(problem),
        jolt::method(problem),
    ]
}

/// What the others are compared with.
pub const DOP853: &str = "DOP853 of the crate, by hand";
