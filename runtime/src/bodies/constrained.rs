//! Bodies under constraints: the violation of the constraints, and its correction.
//!
//! The equations of motion keep the second derivative of a constraint at zero, `g̈ = 0`. Rounding
//! and the error of the steps remain in `ġ`, and `g` grows with time. [`Constrained::project`]
//! removes both, along
//!
//! ```text
//! q - M⁻¹ Aᵀ λ,   A M⁻¹ Aᵀ λ = g        A = ∂g/∂q:
//! the nearest state, in the metric of the kinetic energy
//! ```
//!
//! first in the positions, by Newton's method, then in the velocities, which are linear. In a
//! system, the metric is the kinetic energy of each coordinate by itself.

use core::fmt;

use crate::bodies::body::RigidBody;
use crate::numbers::messages::{Brief, debug_as_display};

/// A body whose motion is under constraints.
pub trait Constrained: RigidBody {
    /// An array of [`Violation`].
    type Violations: AsRef<[Violation]>;

    /// The values of all constraints in a state, and their rates: zero in a consistent state.
    fn violations(
        &self,
        time: Self::Scalar,
        state: &Self::State,
        input: &Self::Input,
    ) -> Self::Violations;

    /// Whether the state satisfies its constraints, in positions and in velocities, to rounding: no
    /// violation exceeds [`Inconsistent::ROUNDING`] times the value that it would have if the whole
    /// state violated the constraint. Integration calls it first.
    ///
    /// # Errors
    /// [`Inconsistent`] with the constraint of the largest violation; positions come first.
    fn check(
        &self,
        time: Self::Scalar,
        state: &Self::State,
        input: &Self::Input,
    ) -> Result<(), Inconsistent>;

    /// Moves the state to one that satisfies its constraints, in positions and in velocities, to
    /// rounding: the nearest, to first order in the violation. If a joint that closes a loop is
    /// turned by more than 60 degrees from its place, the coordinates are first turned one at a time
    /// until it is within 26 degrees, if they can turn it there.
    ///
    /// # Errors
    /// [`Inconsistent`] with the worst constraint that cannot be satisfied from here; the state is
    /// then the nearest that was found.
    fn project(
        &self,
        time: Self::Scalar,
        state: &mut Self::State,
        input: &Self::Input,
    ) -> Result<(), Inconsistent>;

    /// The constraint that depends on the others in this state, or nearly so, although not in
    /// general: at a change point of a linkage, or at a dead point of a driven joint, where the
    /// constraints do not determine the motion. The error of an integration names it. `None` by default;
    /// [`rigid_system!`](crate::rigid_system) and [`rigid_body!`](crate::rigid_body) implement it.
    fn dependent(
        &self,
        _time: Self::Scalar,
        _state: &Self::State,
        _input: &Self::Input,
    ) -> Option<&'static str> {
        None
    }
}

/// The violation of one constraint.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Violation {
    /// Its name in the description.
    pub name: &'static str,
    /// The value of the constraint; `None` for a velocity constraint.
    pub position: Option<f64>,
    /// Its rate; for a velocity constraint, its value.
    pub velocity: f64,
}

/// A state that violates its constraints: a start, or a state that projection cannot correct.
#[derive(Clone, Copy, PartialEq)]
pub struct Inconsistent {
    /// The constraint of the largest violation.
    pub constraint: &'static str,
    /// The size of the violation.
    pub violation: f64,
    /// Whether the violation is a velocity: the rate of the constraint, or the value of a velocity
    /// constraint.
    pub is_velocity: bool,
    /// Whether the state is a start. If so, [`Constrained::project`] finds the nearest consistent
    /// state, if there is one.
    pub is_start: bool,
}

impl Inconsistent {
    /// A residual of a constraint is a failure above this fraction of the terms of its sum.
    /// Newton's method continues to rounding in any case: this number decides only whether it
    /// succeeded.
    pub const TOLERANCE: f64 = 1e-9;

    /// The permitted violation of a start, as a fraction of its size: about a thousand roundings,
    /// from computing the start and from computing the constraint. A start printed with 12 digits
    /// is not accurate enough; [`Constrained::project`] corrects it.
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
                "inconsistent start: `{constraint}` is off by {} in {what}; `project` finds the nearest state that meets it",
                Brief(*violation)
            )
        } else {
            write!(
                f,
                "inconsistent state: `{constraint}` is violated by {} in {what}, and no state near by meets it",
                Brief(*violation)
            )
        }
    }
}

debug_as_display!(Inconsistent);

impl core::error::Error for Inconsistent {}
