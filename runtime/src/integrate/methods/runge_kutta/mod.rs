//! Runge–Kutta methods, written out: no loops over tables, and nothing is multiplied by a zero of a
//! table.
//!
//! They move the coordinates of a state ([`Coordinates`]), of an attitude its quaternion, whose
//! length no motion changes; after each step it is unit to rounding. (M. Boyle, The integration of
//! angular velocity, Advances in Applied Clifford Algebras 27 (2017) 2345: that is as accurate as
//! methods on the group, and cheaper.) They are generic over the scalar, so that ensembles take
//! their steps in lanes.

use crate::bodies::body::RigidBody;
use crate::integrate::steps::equations::Equations;
use crate::integrate::steps::stretch::Given;
use crate::numbers::scalar::Scalar;
use crate::state::Coordinates;

mod classical;
mod dormand_prince;
mod midpoint;
mod tsitouras;
mod verner;

pub use classical::Classical4;
pub use dormand_prince::DormandPrince8;
pub use midpoint::Midpoint;
pub use tsitouras::Tsitouras5;
pub use verner::Verner9;

/// A Runge–Kutta method: a step from nothing but the state at its start.
pub trait RungeKutta: Copy + core::fmt::Debug + Send + Sync {
    /// The error of a motion in steps h is of order `h^ORDER`.
    const ORDER: usize;

    /// Whether a step is the solution of equations; where none is found, it is not a number.
    const IS_IMPLICIT: bool = false;

    /// What a step \[s\] adds to the coordinates.
    fn increment<B: RigidBody<Scalar: Scalar, State: Coordinates>>(
        equations: &Equations<'_, B>,
        time: B::Scalar,
        coordinates: &<B::State as Coordinates>::Array,
        step: B::Scalar,
    ) -> <B::State as Coordinates>::Array;
}

/// The state one step \[s\] later; the input is held, and what of it moves is given at the start.
///
/// ```
/// use newton_euler::integrate::{self, DormandPrince8};
/// use newton_euler::prelude::*;
///
/// rigid_body!(Pendulum {
///     motion: pivot(pin),
///     mass: 2[kg],
///     inertia: 0.3[kg * m ^ 2],
///     points: [pin = (0, 0.5)],
///     fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
///     reactions: [hold = world(_, _).at(pin)],
///     outputs: [energy],
/// });
///
/// let (pendulum, start) = (Pendulum::default(), Hinge { angle: 2.0, angular_velocity: 0.0 });
/// let later = integrate::runge_kutta_step::<DormandPrince8, _>(&pendulum, 0.0, &start, &(), 0.05);
/// let energy =
///     |state| pendulum.kinetic_energy(state) + pendulum.potential_energy(0.0, state, &());
/// assert!((energy(&later) - energy(&start)).abs() < 1e-13);
/// ```
#[must_use]
#[inline(always)]
pub fn runge_kutta_step<M: RungeKutta, B: RigidBody<Scalar: Scalar, State: Coordinates>>(
    body: &B,
    time: B::Scalar,
    state: &B::State,
    input: &B::Input,
    step: B::Scalar,
) -> B::State {
    let mut coordinates = state.coordinates();
    let body = &Given { body, at: time };
    let equations = Equations { body, input };
    let mut change = M::increment(&equations, time, &coordinates, step);
    B::State::keep(&coordinates, &mut change);
    for (coordinate, change) in coordinates.as_mut().iter_mut().zip(change.as_ref()) {
        *coordinate += *change;
    }
    B::State::from_coordinates(&coordinates)
}

/// `start + (h a₁ k₁ + h a₂ k₂ + ..)`, coordinate by coordinate.
#[inline(always)]
pub(super) fn moved<S: Coordinates, const M: usize>(
    start: &S::Array,
    step: S::Scalar,
    terms: [(f64, &S::Array); M],
) -> S::Array {
    let mut moved = change::<S, M>(step, terms);
    for (coordinate, start) in moved.as_mut().iter_mut().zip(start.as_ref()) {
        *coordinate += *start;
    }
    moved
}

/// `h a₁ k₁ + h a₂ k₂ + ..`, coordinate by coordinate.
///
/// The factors h a are those of all coordinates, and in equal steps of all steps: they are computed
/// once.
#[inline(always)]
fn change<S: Coordinates, const M: usize>(
    step: S::Scalar,
    terms: [(f64, &S::Array); M],
) -> S::Array {
    let factor = |weight: f64| number(step, weight) * step;
    let (first, rates) = terms[0];
    let mut change = *rates;
    for (place, coordinate) in change.as_mut().iter_mut().enumerate() {
        *coordinate *= factor(first);
        for (weight, rates) in &terms[1..] {
            *coordinate += factor(*weight) * rates.as_ref()[place];
        }
    }
    change
}

/// A coefficient as a scalar.
#[inline(always)]
pub(super) fn number<T: Scalar>(like: T, value: f64) -> T {
    #[expect(
        clippy::cast_possible_truncation,
        reason = "the nearest in single precision"
    )]
    like.constant(value, value as f32)
}

/// A method by its tableau: when each stage is evaluated, from which before; the sum that is the
/// step, and its differences to other methods.
macro_rules! tableau {
    (
        $(#[$doc:meta])* $name:ident: order $order:literal;
        stages { $($k:ident at $c:literal $(from $($a:literal $j:ident),+)?;)+ }
        sum { $($b:literal $s:ident),+ }
        $(difference { $($e:literal $t:ident),+ })*
    ) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
        pub struct $name;

        impl $name {
            /// The sum and the differences.
            #[inline(always)]
            pub(in crate::integrate) fn sums<E: Rates>(
                equations: &E,
                time: <E::State as State>::Scalar,
                coordinates: &<E::State as Coordinates>::Array,
                step: <E::State as State>::Scalar,
            ) -> [<E::State as Coordinates>::Array; 1 $(+ tableau!(@one $($e)+))*] {
                $(let $k = {
                    let stage = *coordinates;
                    $(let stage = moved::<E::State, _>(&stage, step, [$(($a, &$j)),+]);)?
                    equations.rates(time + number(step, $c) * step, &stage)
                };)+
                [
                    change::<E::State, _>(step, [$(($b, &$s)),+]),
                    $(change::<E::State, _>(step, [$(($e, &$t)),+]),)*
                ]
            }
        }

        impl RungeKutta for $name {
            const ORDER: usize = $order;

            #[inline(always)]
            fn increment<B: RigidBody<Scalar: Scalar, State: Coordinates>>(
                equations: &Equations<'_, B>,
                time: B::Scalar,
                coordinates: &<B::State as Coordinates>::Array,
                step: B::Scalar,
            ) -> <B::State as Coordinates>::Array {
                let [sum, ..] = Self::sums(equations, time, coordinates, step);
                sum
            }
        }
    };
    (@one $($weight:literal)+) => { 1 };
}
use tableau;
