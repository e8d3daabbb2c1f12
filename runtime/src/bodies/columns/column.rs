//! Types as columns of scalars.

use core::fmt::Debug;

use crate::bodies::body::{InvalidBody, RigidBody};
use crate::numbers::scalar::Scalar;
use crate::state::Coordinates;

/// A type that consists of scalars only.
pub trait Columns<T: Scalar>: Clone + Debug + Send + Sync {
    /// The number of its scalars.
    const COUNT: usize;

    /// Reads them from a source, in order.
    fn read(source: &mut impl Source<T>) -> Self;

    /// Writes them to a sink, in the same order.
    fn write(&self, sink: &mut impl Sink<T>);
}

/// A sequence of scalars to read.
pub trait Source<T> {
    /// The next scalar.
    fn take(&mut self) -> T;
}

/// A sequence of scalars to write.
pub trait Sink<T> {
    /// Writes the next scalar.
    fn put(&mut self, scalar: T);
}

/// A body over a scalar, all of whose parts are columns.
pub trait Columnar<T: Scalar>:
    RigidBody<
        Scalar = T,
        State: Columns<T> + Coordinates<Acceleration: Columns<T>>,
        Input: Columns<T>,
    > + Columns<T>
{
}

impl<T: Scalar, B: Columns<T>> Columnar<T> for B where
    B: RigidBody<
            Scalar = T,
            State: Columns<T> + Coordinates<Acceleration: Columns<T>>,
            Input: Columns<T>,
        >
{
}

/// A body that is generic over its scalar, at `f64`.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no body that is generic over its scalar, at `f64`",
    label = "not generic, or at another scalar",
    note = "describe it as `rigid_body!(Name::<T> {{ .. }})` and use `Name<f64>`"
)]
pub trait Generic: Columnar<f64> {
    /// The same body over another scalar, with the same columns.
    type With<T: Scalar>: Columnar<T>;

    /// Its parameters; `()` if it has none.
    type Params: Columns<f64>;

    /// The same as `new`.
    ///
    /// # Errors
    /// [`InvalidBody`], as for `new`.
    fn build(params: Self::Params) -> Result<Self, InvalidBody>;

    /// The parameters it was built from.
    fn parameters(&self) -> Self::Params;
}
