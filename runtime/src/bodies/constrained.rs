//! Bodies under constraints: how far a state is from them, and the way back.
//!
//! The equations of motion keep a constraint in its second derivative, `g̈ = 0`: what rounding and
//! the error of the steps leave in `ġ` stays, and `g` grows with time. [`Constrained::project`]
//! takes it away again, along
//!
//! ```text
//! q - M⁻¹ Aᵀ λ,   A M⁻¹ Aᵀ λ = g        A = ∂g/∂q:
//! the nearest state, in the metric of the kinetic energy
//! ```
//!
//! first in the positions, by Newton's method, then in the velocities, which enter linearly.

use core::fmt;

use crate::bodies::body::RigidBody;

/// A body whose motion is under constraints.
pub trait Constrained: RigidBody {
    /// An array of [`Violation`].
    type Violations: AsRef<[Violation]>;

    /// The values of all constraints in a state, and their rates: zero if it is consistent.
    fn violations(
        &self,
        time: Self::Scalar,
        state: &Self::State,
        input: &Self::Input,
    ) -> Self::Violations;

    /// Whether the state meets its constraints, in positions and in velocities, to rounding: to the
    /// fraction [`Inconsistent::ROUNDING`] of what they would be if all of the state went across
    /// them. An integration begins with it.
    ///
    /// # Errors
    /// [`Inconsistent`] with the constraint that is violated most; positions come first.
    fn check(
        &self,
        time: Self::Scalar,
        state: &Self::State,
        input: &Self::Input,
    ) -> Result<(), Inconsistent>;

    /// Moves the state to the nearest one that meets its constraints, in positions and in
    /// velocities, to rounding.
    ///
    /// # Errors
    /// [`Inconsistent`] with the worst constraint that cannot be met from here; the state is then
    /// as near as was found.
    fn project(
        &self,
        time: Self::Scalar,
        state: &mut Self::State,
        input: &Self::Input,
    ) -> Result<(), Inconsistent>;

    /// The constraint that depends on the others in a state, or nearly so, though elsewhere it does not:
    /// at a dead point or a change point of a linkage, where they do not determine the motion. The
    /// error of an integration names it. None, unless it is said here:
    /// [`rigid_system!`](crate::rigid_system) and [`rigid_body!`](crate::rigid_body) do.
    fn dependent(
        &self,
        _time: Self::Scalar,
        _state: &Self::State,
        _input: &Self::Input,
    ) -> Option<&'static str> {
        None
    }
}

/// How far a state is from one constraint.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Violation {
    /// Its name in the description.
    pub name: &'static str,
    /// The value of the constraint; `None` if it is one of velocities.
    pub position: Option<f64>,
    /// Its rate; of a constraint of velocities, its value.
    pub velocity: f64,
}

/// A state that does not meet its constraints: a start, or one that no projection makes meet them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Inconsistent {
    /// The constraint that is violated most.
    pub constraint: &'static str,
    /// By how much.
    pub violation: f64,
    /// Whether that is a velocity: the rate of the constraint, or the value of a constraint of
    /// velocities.
    pub is_velocity: bool,
    /// Whether it is a start; [`Constrained::project`] finds the nearest state that meets all, if
    /// there is one.
    pub is_start: bool,
}

impl Inconsistent {
    /// What is left of a constraint, as a fraction of the terms it is summed from, is a failure
    /// above this. Newton's method goes on to rounding in any case: this number decides only
    /// whether it got there.
    pub const TOLERANCE: f64 = 1e-9;

    /// What a start may be off by, as a fraction of its size: some thousand roundings, of those who
    /// computed it and of what computes the constraint. Numbers of 12 digits are not enough, and
    /// are put on the constraints by [`Constrained::project`].
    pub const ROUNDING: f64 = 1e-12;
}

impl fmt::Display for Inconsistent {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self {
            constraint,
            violation,
            is_velocity,
            is_start,
        } = self;
        let what = if *is_velocity { "velocity" } else { "position" };
        if *is_start {
            write!(
                f,
                "inconsistent start: `{constraint}` is off by {violation:e} in {what}; `project` finds the nearest state that meets it"
            )
        } else {
            write!(
                f,
                "inconsistent state: `{constraint}` is violated by {violation:e} in {what}, and no state near by meets it"
            )
        }
    }
}

impl core::error::Error for Inconsistent {}
