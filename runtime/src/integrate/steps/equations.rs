//! A body under a held input, as equations for the coordinates of its state.

use core::fmt;

use crate::bodies::body::RigidBody;
use crate::numbers::scalar::Scalar;
use crate::state::{Coordinates, State};

/// The interface for general solvers: `y' = f(t, y)`, where y are the coordinates of a state
/// ([`Coordinates`]). All inputs are held, including those that are `.moving`.
/// [`next_switch`](crate::integrate::next_switch) gives the times at which conditions switch.
///
/// With the feature `differential-equations` it implements `ODE` of the crate of that name for
/// `[f64; N]`, without a copy of the state:
///
/// ```
/// # #[cfg(feature = "differential-equations")] {
/// use differential_equations::prelude::{ExplicitRungeKutta, IVP};
/// use newton_euler::{integrate::Equations, prelude::*, state::Coordinates};
///
/// rigid_body!(Handle {
///     motion: rotation,
///     inertia: principal(1, 2, 3)[kg * m ^ 2],
/// });
///
/// let start = Rotation { angular_velocity: [0.01, 1.0, 0.01].into(), ..Rotation::default() };
/// let equations = Equations { body: &Handle::default(), input: &() };
/// let solution = IVP::ode(&equations, 0.0, 19.55, start.coordinates())
///     .method(ExplicitRungeKutta::dop853().rtol(1e-9).atol(1e-9))
///     .solve()
///     .unwrap();
/// let flipped = Rotation::from_coordinates(solution.last().unwrap().1);
/// assert!(flipped.angular_velocity.y < -0.99);
/// # }
/// ```
pub struct Equations<'b, B: RigidBody> {
    /// The body.
    pub body: &'b B,
    /// The input, which acts together with the body's own loads.
    pub input: &'b B::Input,
}

impl<B: RigidBody> Clone for Equations<'_, B> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<B: RigidBody> Copy for Equations<'_, B> {}

impl<B: RigidBody> fmt::Debug for Equations<'_, B> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Equations").finish_non_exhaustive()
    }
}

/// Equations for the coordinates of a state.
pub trait Rates {
    /// The state.
    type State: Coordinates;

    /// The derivatives of the coordinates.
    fn rates(
        &self,
        time: <Self::State as State>::Scalar,
        coordinates: &<Self::State as Coordinates>::Array,
    ) -> <Self::State as Coordinates>::Array;
}

impl<B: RigidBody<Scalar: Scalar, State: Coordinates>> Rates for Equations<'_, B> {
    type State = B::State;

    #[cfg_attr(not(unoptimized), inline(always))]
    fn rates(
        &self,
        time: B::Scalar,
        coordinates: &<B::State as Coordinates>::Array,
    ) -> <B::State as Coordinates>::Array {
        self.rates(time, coordinates)
    }
}

impl<B: RigidBody<Scalar: Scalar, State: Coordinates>> Equations<'_, B> {
    /// The derivatives of the coordinates.
    #[cfg_attr(not(unoptimized), inline(always))]
    pub fn rates(
        &self,
        time: B::Scalar,
        coordinates: &<B::State as Coordinates>::Array,
    ) -> <B::State as Coordinates>::Array {
        let state = B::State::from_coordinates(coordinates);
        state.rates(&self.body.acceleration(time, &state, self.input))
    }
}

#[cfg(feature = "differential-equations")]
impl<B, const N: usize> differential_equations::prelude::ODE<f64, [f64; N]> for Equations<'_, B>
where
    B: RigidBody<Scalar = f64, State: Coordinates<Scalar = f64, Array = [f64; N]>>,
{
    #[inline]
    fn diff(&self, time: f64, coordinates: &[f64; N], rates: &mut [f64; N]) {
        *rates = self.rates(time, coordinates);
    }
}
