//! Bodies under constraints: how far a state is from them, and the way back.
//!
//! The equations of motion keep a constraint in its second derivative, `g̈ = 0`: what rounding and the error of the steps
//! leave in `ġ` stays, and `g` grows with time. [`Constrained::project`] takes it away again, along
//!
//! ```text
//! q - M⁻¹ Aᵀ λ,   A M⁻¹ Aᵀ λ = g        A = ∂g/∂q: the nearest state, in the metric of the kinetic energy
//! ```
//!
//! first in the positions, by Newton's method, then in the velocities, which enter linearly.

use core::fmt;

use crate::body::RigidBody;

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

    /// Moves the state to the nearest one that meets its constraints, in positions and in velocities, to rounding.
    ///
    /// # Errors
    /// [`Inconsistent`] with the worst constraint that cannot be met from here; the state is then as near as was found.
    fn project(
        &self,
        time: Self::Scalar,
        state: &mut Self::State,
        input: &Self::Input,
    ) -> Result<(), Inconsistent>;
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

/// A state that does not meet its constraints, and that no projection makes meet them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Inconsistent {
    /// The constraint that is violated most.
    pub constraint: &'static str,
    /// By how much.
    pub violation: f64,
}

impl Inconsistent {
    /// What is left of a constraint, as a fraction of the terms it is summed from, is a failure above this. Newton's method
    /// goes on to rounding in any case: this number decides only whether it got there.
    pub const TOLERANCE: f64 = 1e-9;
}

impl fmt::Display for Inconsistent {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self {
            constraint,
            violation,
        } = self;
        write!(
            f,
            "inconsistent state: `{constraint}` is violated by {violation:e}, and no state near by meets it"
        )
    }
}

impl core::error::Error for Inconsistent {}
