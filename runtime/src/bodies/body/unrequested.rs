//! What rustc says if a method is called whose output was not requested.
//!
//! Each output has a trait here that no type implements. Its bodies would have the output, so rustc
//! finds the method, and says in the words of the trait what is missing.

use super::of_systems::{DrivenEnergy, DrivenMomentum, Jacobian, MassMatrix};
use super::outputs::{Balance, Energy, Flow, Inverse, Momentum, Reactions, Regressor};
use super::rigid_body::RigidBody;
use crate::bodies::path::Path;
use crate::state::State;

/// An output that is not requested. No type implements this.
pub trait Unrequested: RigidBody {
    /// The result of any method, in no body.
    fn never<T>(&self) -> T;
}

/// What bodies of such a trait would implement.
macro_rules! unrequested {
    ($(impl $output:ident for $of:ident {
        $(type $name:ident = $type:ty;)*
        $(const $constant:ident: $of_constant:ty = $value:expr;)?
        $(fn $method:ident($($argument:ty),*) -> $result:ty;)*
    })*) => { $(
        #[doc(hidden)]
        #[diagnostic::do_not_recommend]
        impl<B: $of> $output for B {
            $(type $name = $type;)*
            $(const $constant: $of_constant = $value;)?
            $(fn $method(&self, $(_: $argument),*) -> $result { self.never() })*
        }
    )* };
}

pub(crate) use unrequested;

#[diagnostic::on_unimplemented(
    message = "`{Self}` has no `balance`",
    label = "add `balance` to its `outputs`"
)]
pub trait BalanceInOutputs: Unrequested {}

#[diagnostic::on_unimplemented(
    message = "`{Self}` has no `energy`",
    label = "add `energy` to its `outputs`"
)]
pub trait EnergyInOutputs: Unrequested {}

#[diagnostic::on_unimplemented(
    message = "`{Self}` has no `momentum`",
    label = "add `momentum` to its `outputs`"
)]
pub trait MomentumInOutputs: Unrequested {}

#[diagnostic::on_unimplemented(
    message = "`{Self}` has no `reactions`",
    label = "add `reactions` to its `outputs`"
)]
pub trait ReactionsInOutputs: Unrequested {}

#[diagnostic::on_unimplemented(
    message = "`{Self}` has no `inverse`",
    label = "add `inverse` to its `outputs`"
)]
pub trait InverseInOutputs: Unrequested {}

#[diagnostic::on_unimplemented(
    message = "`{Self}` has no `regressor`",
    label = "add `regressor` to its `outputs`"
)]
pub trait RegressorInOutputs: Unrequested {}

#[diagnostic::on_unimplemented(
    message = "`{Self}` has no `flow`",
    label = "add `flow` to its `outputs`"
)]
pub trait FlowInOutputs: Unrequested {
    type Motion: Path<State = Self::State>;
}

#[diagnostic::on_unimplemented(
    message = "`{Self}` has no `mass_matrix`",
    label = "add `mass_matrix` to its `outputs`"
)]
pub trait MassMatrixInOutputs: Unrequested {}

#[diagnostic::on_unimplemented(
    message = "`{Self}` has no `jacobian`",
    label = "add `jacobian(body.point)` to its `outputs`"
)]
pub trait JacobianInOutputs: Unrequested {}

unrequested! {
    impl Balance for BalanceInOutputs {
        type Wrench = ();
        type Reactions = ();
        type Loads = ();
        fn applied(Self::Scalar, &Self::State, &Self::Input) -> ();
        fn residual(
            Self::Scalar, &Self::State, &<Self::State as State>::Acceleration, &(), &Self::Input
        ) -> ();
        fn loads(Self::Scalar, &Self::State, &Self::Input) -> ();
    }

    impl Energy for EnergyInOutputs {
        fn kinetic_energy(&Self::State) -> Self::Scalar;
        fn potential_energy(Self::Scalar, &Self::State, &Self::Input) -> Self::Scalar;
    }

    impl DrivenEnergy for EnergyInOutputs {
        fn kinetic_energy(Self::Scalar, &Self::State, &Self::Input) -> Self::Scalar;
        fn potential_energy(Self::Scalar, &Self::State, &Self::Input) -> Self::Scalar;
    }

    impl Momentum for MomentumInOutputs {
        type Linear = ();
        type Angular = ();
        fn linear_momentum(&Self::State) -> ();
        fn angular_momentum(&Self::State) -> ();
        fn angular_momentum_about_pole(Self::Scalar, &Self::State) -> ();
    }

    impl DrivenMomentum for MomentumInOutputs {
        type Linear = ();
        type Angular = ();
        fn linear_momentum(Self::Scalar, &Self::State, &Self::Input) -> ();
        fn angular_momentum(Self::Scalar, &Self::State, &Self::Input) -> ();
        fn angular_momentum_about_pole(Self::Scalar, &Self::State, &Self::Input) -> ();
    }

    impl Reactions for ReactionsInOutputs {
        type Reactions = ();
        fn reactions(Self::Scalar, &Self::State, &Self::Input) -> ();
    }

    impl Inverse for InverseInOutputs {
        type Drives = ();
        fn inverse(
            Self::Scalar, &Self::State, &<Self::State as State>::Acceleration, &Self::Input
        ) -> ();
    }

    impl Regressor for RegressorInOutputs {
        type Regressor = ();
        type Parameters = ();
        const PARAMETERS: &'static [&'static str] = &[];
        fn regressor(
            Self::Scalar, &Self::State, &<Self::State as State>::Acceleration, &Self::Input
        ) -> ();
        fn inertial_parameters() -> ();
    }

    impl Flow for FlowInOutputs {
        type Path = <Self as FlowInOutputs>::Motion;
        fn path(&Self::State) -> <Self as FlowInOutputs>::Motion;
    }

    impl MassMatrix for MassMatrixInOutputs {
        type Matrix = ();
        type Forces = ();
        fn mass_matrix(Self::Scalar, &Self::State, &Self::Input) -> ();
        fn generalized_forces(Self::Scalar, &Self::State, &Self::Input) -> ();
    }

    impl Jacobian for JacobianInOutputs {
        type Jacobians = ();
        fn jacobian(Self::Scalar, &Self::State, &Self::Input) -> ();
    }
}
