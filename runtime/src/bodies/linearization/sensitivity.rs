//! Derivatives of accelerations with respect to parameters.

use nalgebra::SMatrix;

use crate::bodies::body::{RigidBody, Unrequested, unrequested};

/// The first derivatives of the accelerations with respect to parameters, `outputs: [sensitivity]`.
///
/// ```
/// use newton_euler::prelude::*;
///
/// rigid_body!(Pendulum {
///     motion: pivot(hinge),
///     params: [arm = 0.5[m], radius = 0.2[m]],
///     mass: 2[kg],
///     inertia: mass * radius.powi(2),
///     points: [hinge = (0, arm)],
///     fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
///     outputs: [sensitivity],
/// });
///
/// let aside = Hinge { angle: 0.3, angular_velocity: 0.0 };
/// let found = Pendulum::default().sensitivity(0.0, &aside, &());
/// // w' = -g l sin(angle) / (r^2 + l^2)
/// let (square, pull) = (0.04 + 0.25_f64, -9.80665 * 0.3_f64.sin());
/// assert!((found.acceleration - pull * 0.5 / square).abs() < 1e-14);
/// assert!((found.angular_by_arm - pull * (0.04 - 0.25) / square.powi(2)).abs() < 1e-13);
/// assert!((found.angular_by_radius + pull * 0.5 * 0.4 / square.powi(2)).abs() < 1e-13);
/// // all of them, in columns
/// assert_eq!(PendulumSensitivity::PARAMS, ["arm", "radius"]);
/// assert_eq!(found.by_params()[(0, 1)], found.angular_by_radius);
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no `sensitivity`",
    label = "add `sensitivity` to its `outputs`"
)]
pub trait Sensitivity: RigidBody {
    /// A struct of the acceleration and of all blocks that are not zero in all states:
    /// `linear_by_area`, for a system `elbow_angular_by_length`. A block is a number, or a matrix
    /// with a row for each component of the acceleration and a column for each component of a
    /// vector parameter. The struct is [`ByParams`].
    type Sensitivity;

    /// The derivatives in this state, with state and input held. At a kink of the motion
    /// (`abs`, `min`, `if`), they are those of the active branch.
    fn sensitivity(
        &self,
        time: Self::Scalar,
        state: &Self::State,
        input: &Self::Input,
    ) -> Self::Sensitivity;
}

#[diagnostic::on_unimplemented(
    message = "`{Self}` has no `sensitivity`",
    label = "add `sensitivity` to its `outputs`"
)]
pub trait SensitivityInOutputs: Unrequested {}

unrequested! {
    impl Sensitivity for SensitivityInOutputs {
        type Sensitivity = ();
        fn sensitivity(Self::Scalar, &Self::State, &Self::Input) -> ();
    }
}

/// A sensitivity as a matrix, in doubles.
pub trait ByParams<const RATES: usize, const PARAMS: usize> {
    /// The names of the accelerations: `linear_x`, `elbow_angular`, and of the user-defined states
    /// whose rates follow.
    const RATES: [&'static str; RATES];
    /// The names of the components of the parameters.
    const PARAMS: [&'static str; PARAMS];

    /// A column for each component of the parameters, with zeros where there is no block.
    fn by_params(&self) -> SMatrix<f64, RATES, PARAMS>;
}
