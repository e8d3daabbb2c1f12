//! The outputs that only systems have, one trait for each.

use super::rigid_body::RigidBody;

/// [`Energy`](super::Energy) of a system with joints of prescribed motion, `.driven(speed * t)`: it
/// depends on time and on inputs.
///
/// The drives of these joints do work on the system: with loads M and rates w, they supply the
/// power `M w`.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no `energy` that depends on time or an input",
    label = "add `energy` to its `outputs`",
    note = "if it depends on the state alone, the trait is `Energy`"
)]
pub trait DrivenEnergy: RigidBody {
    /// `½ m v² + ½ ω·Jω` of all bodies.
    fn kinetic_energy(
        &self,
        time: Self::Scalar,
        state: &Self::State,
        input: &Self::Input,
    ) -> Self::Scalar;

    /// Like [`Energy::potential_energy`](super::Energy::potential_energy).
    fn potential_energy(
        &self,
        time: Self::Scalar,
        state: &Self::State,
        input: &Self::Input,
    ) -> Self::Scalar;
}

/// [`Momentum`](super::Momentum) of a system with joints of prescribed motion: it depends on time
/// and on inputs.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no `momentum` that depends on time or an input",
    label = "add `momentum` to its `outputs`",
    note = "if it depends on the state alone, the trait is `Momentum`"
)]
pub trait DrivenMomentum: RigidBody {
    /// A vector in space or in the plane.
    type Linear;
    /// A vector, or in the plane a scalar.
    type Angular;

    /// `P = Σ m v_G`, world axes \[kg m/s\].
    fn linear_momentum(
        &self,
        time: Self::Scalar,
        state: &Self::State,
        input: &Self::Input,
    ) -> Self::Linear;

    /// Angular momentum about the center of mass of the system, world axes \[kg m²/s\].
    fn angular_momentum(
        &self,
        time: Self::Scalar,
        state: &Self::State,
        input: &Self::Input,
    ) -> Self::Angular;

    /// Angular momentum about the origin of the world, world axes \[kg m²/s\].
    fn angular_momentum_about_pole(
        &self,
        time: Self::Scalar,
        state: &Self::State,
        input: &Self::Input,
    ) -> Self::Angular;
}

/// The mass matrix of a system, `outputs: [mass_matrix]`: the equations of motion before they are
/// solved.
///
/// ```text
/// M q'' = f        M: inertias, symmetric and positive definite
/// ```
///
/// Rows and columns are in the order of the numbers of the acceleration
/// ([`Columns`](crate::columns::Columns)): joint by joint as they are written; for a free body G
/// along world axes, then the rotation along body axes.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no `mass_matrix`",
    label = "add `mass_matrix` to its `outputs`"
)]
pub trait MassMatrix: RigidBody {
    /// A square matrix.
    type Matrix;
    /// A column.
    type Forces;

    /// M: \[kg\] between slides, \[kg m²\] between hinges, \[kg m\] between both.
    fn mass_matrix(
        &self,
        time: Self::Scalar,
        state: &Self::State,
        input: &Self::Input,
    ) -> Self::Matrix;

    /// f \[N, N m\]: drives and loads along each degree of freedom, minus the Coriolis and
    /// centrifugal terms.
    fn generalized_forces(
        &self,
        time: Self::Scalar,
        state: &Self::State,
        input: &Self::Input,
    ) -> Self::Forces;
}

/// Jacobians of points of a system, `outputs: [jacobian(arm.tip)]`.
///
/// ```text
/// (v_P, w) = J q'        v_P: velocity of the point, w: angular velocity of its body, world axes
/// ```
///
/// A force F and a moment M on the body at P act along the joint coordinates as `Jᵀ (F, M)`.
/// A driven joint has no column.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no `jacobian`",
    label = "add `jacobian(body.point)` to its `outputs`"
)]
pub trait Jacobian: RigidBody {
    /// One field for each point, `arm_tip`: a matrix of six rows, in the plane three (x, y, angle),
    /// and a column for each rate of the state, joint by joint, in the order of
    /// [`Columns`](crate::columns::Columns) of the acceleration.
    type Jacobians;

    /// The Jacobians of all requested points.
    fn jacobian(
        &self,
        time: Self::Scalar,
        state: &Self::State,
        input: &Self::Input,
    ) -> Self::Jacobians;
}
