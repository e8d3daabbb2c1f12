//! Taylor series of a motion: `outputs: [taylor]`.
//!
//! Where the equations of motion are smooth, the state is a power series in time. Its coefficients
//! follow one from another: coefficient n of a coordinate is 1/n of coefficient n - 1 of its rate,
//! and each operation of the equations has a rule for coefficient n of its result (A.
//! Griewank, A. Walther, Evaluating Derivatives, SIAM 2008, chapter 13).
//! [`rigid_body!`](crate::rigid_body) writes out these rules; [`integrate`](crate::integrate) takes
//! steps with them, of any order and with a given error.

use crate::bodies::body::RigidBody;
use crate::state::Coordinates;

mod arithmetic;
mod axes;
mod products;
mod series;
mod unrequested;

pub use arithmetic::{Arithmetic, Plain};
pub use axes::Axes;
pub use products::Products;
pub use series::Series;
pub(crate) use series::{after, increment, slope};

/// A body whose motion has Taylor series.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no `taylor`",
    label = "add `taylor` to its `outputs`"
)]
pub trait Taylor: RigidBody<Scalar = f64, State: Coordinates> {
    /// The reusable workspace: see [`Products`].
    type Products<A: Arithmetic, const N: usize>: From<A> + Send;

    /// The axes in which [`expand`](Self::expand) works for the whole motion from a state on. In
    /// that state they are along the body axes.
    #[inline]
    #[must_use]
    fn axes(&self, _time: f64, _state: &Self::State) -> Axes {
        Axes::BODY
    }

    /// Writes the first N coefficients of the motion through `state` at `time`. Inputs are held, or
    /// continue with their given rates; N is at least 2.
    ///
    /// State and series are in [`axes`](Self::axes) that may differ from the body axes. `products`
    /// may have any content.
    fn expand<A: Arithmetic, const N: usize>(
        &self,
        time: f64,
        state: &Self::State,
        input: &Self::Input,
        products: &mut Self::Products<A, N>,
        series: &mut Series<Self::State, N>,
    );

    /// The first N coefficients of the motion through `state` at `time`, in body axes: all powers
    /// of time below N. Inputs are held, or continue with their given rates.
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
