//! The interface of a description to the search for a steady motion.

use super::matrices::{Linearization, Linearized};
use super::place::Place;
use crate::bodies::constrained::Violation;
use crate::state::Coordinates;

/// A body or a system whose states and inputs are lists of numbers. `outputs: [linearization]`
/// implements it.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no `trim`",
    label = "needs `linearization` in its `outputs`, and the scalar `f64`"
)]
pub trait Coordinated<const STATES: usize, const INPUTS: usize>:
    Linearization<Scalar = f64, State: Coordinates, Linearization: Linearized<STATES, INPUTS>>
{
    /// The kinds of the coordinates that precede their rates.
    const PLACES: &'static [Place];

    /// The components of an input, in the order of [`Linearized::INPUTS`].
    fn components(input: &Self::Input) -> [f64; INPUTS];

    /// The input with these components.
    fn input(components: [f64; INPUTS]) -> Self::Input;

    /// The size of the largest term of each acceleration; zero for the coordinates.
    fn terms(&self, time: f64, state: &Self::State, input: &Self::Input) -> [f64; STATES];

    /// The violation of each constraint; none by default.
    fn each_violation(
        &self,
        _time: f64,
        _state: &Self::State,
        _input: &Self::Input,
        _each: &mut dyn FnMut(Violation),
    ) {
    }
}
