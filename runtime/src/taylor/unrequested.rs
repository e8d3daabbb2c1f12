//! What rustc says if a series is expanded that was not requested.

use super::Taylor;
use super::arithmetic::Arithmetic;
use super::series::Series;
use crate::bodies::body::{RigidBody, Unrequested};
use crate::state::Coordinates;

/// No type implements this trait. A blanket implementation of [`Taylor`] requires it, so rustc
/// finds the methods of [`Taylor`], and reports in these words what is missing.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no `taylor`",
    label = "add `taylor` to its `outputs`"
)]
pub trait TaylorInOutputs: Unrequested + RigidBody<Scalar = f64, State: Coordinates> {}

#[doc(hidden)]
#[diagnostic::do_not_recommend]
impl<B: TaylorInOutputs> Taylor for B {
    type Products<A: Arithmetic, const N: usize> = A;

    fn expand<A: Arithmetic, const N: usize>(
        &self,
        _: f64,
        _: &Self::State,
        _: &Self::Input,
        _: &mut A,
        _: &mut Series<Self::State, N>,
    ) {
        self.never::<()>();
    }
}
