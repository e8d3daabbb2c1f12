//! Taylor series of a motion: `outputs: [taylor]`.
//!
//! Where the equations of motion are smooth, the state is a power series in time. Its coefficients
//! follow one from another: coefficient n of a coordinate is 1/n of coefficient n - 1 of its rate,
//! and for each operation of the equations there is a rule for coefficient n of its result (A.
//! Griewank, A. Walther, Evaluating Derivatives, SIAM 2008, chapter 13).
//! [`rigid_body!`](crate::rigid_body) writes these rules out; [`integrate`](crate::integrate) takes
//! steps with them, of any order and with the error that is asked for.

use crate::bodies::body::RigidBody;
use crate::state::Coordinates;

mod arithmetic;
mod axes;
mod products;
mod series;

pub use arithmetic::{Arithmetic, Plain};
pub use axes::Axes;
pub use products::Products;
pub use series::Series;
pub(crate) use series::{after, increment, slope};

/// A body whose motion has Taylor series.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no `taylor`",
    label = "not among the `outputs` of its description",
    note = "write `outputs: [.., taylor]`"
)]
pub trait Taylor: RigidBody<Scalar = f64, State: Coordinates> {
    /// What is needed on the way, to be used again: see [`Products`].
    type Products<A: Arithmetic, const N: usize>: From<A>;

    /// The axes that [`expand`](Self::expand) sees a motion in, from a state on, where they are
    /// along those of the body: for all of it.
    #[inline]
    #[must_use]
    fn axes(&self, _time: f64, _state: &Self::State) -> Axes {
        Axes::BODY
    }

    /// Writes the first N coefficients of the motion through `state` at `time`, with the input
    /// held, or moving from there on; N is at least 2.
    ///
    /// State and series are in [`axes`](Self::axes) that may not be those of the body. `products`
    /// may be in any state.
    fn expand<A: Arithmetic, const N: usize>(
        &self,
        time: f64,
        state: &Self::State,
        input: &Self::Input,
        products: &mut Self::Products<A, N>,
        series: &mut Series<Self::State, N>,
    );

    /// The first N coefficients of the motion through `state` at `time`, in the axes of the body
    /// and with the input held, or moving from there on: all powers of time below N.
    ///
    /// # Panics
    /// If N is less than 2.
    #[must_use]
    fn series<const N: usize>(
        &self,
        time: f64,
        state: &Self::State,
        input: &Self::Input,
    ) -> Series<Self::State, N> {
        let mut series = Series::default();
        self.expand(
            time,
            state,
            input,
            &mut Self::Products::from(Plain),
            &mut series,
        );
        series.turn(&self.axes(time, state));
        series
    }
}
