//! Runge–Kutta methods, written out: no loops over tables, and no multiplications by zeros of a
//! table.
//!
//! They integrate the coordinates of a state ([`Coordinates`]). For an attitude these are its
//! quaternion, whose length no motion changes; after each step it is unit to rounding. (M. Boyle,
//! The integration of angular velocity, Advances in Applied Clifford Algebras 27 (2017) 2345: this
//! is as accurate as methods on the group, and cheaper.) The methods are generic over the scalar,
//! so ensembles take their steps in lanes.

use crate::bodies::body::RigidBody;
use crate::integrate::steps::equations::{Equations, Rates};
use crate::integrate::steps::stretch::Given;
use crate::numbers::scalar::{Scalar, number};
use crate::state::{Coordinates, State};

mod classical;
mod dormand_prince;
mod midpoint;
pub mod track;
mod tsitouras;
mod verner;

pub use classical::Classical4;
pub use dormand_prince::DormandPrince8;
pub use midpoint::Midpoint;
pub use tsitouras::Tsitouras5;
pub use verner::Verner9;

/// A Runge–Kutta method: a step that needs only the state at its start.
pub trait RungeKutta: Copy + core::fmt::Debug + Send + Sync {
    /// The error of a motion in steps h is of order `h^ORDER`.
    const ORDER: usize;

    /// Whether a step solves equations; if no solution is found, it is NaN.
    const IS_IMPLICIT: bool = false;

    /// The increment of the coordinates over a step \[s\].
    fn increment<B: RigidBody<Scalar: Scalar, State: Coordinates>>(
        equations: &Equations<'_, B>,
        time: B::Scalar,
        coordinates: &<B::State as Coordinates>::Array,
        step: B::Scalar,
    ) -> <B::State as Coordinates>::Array;
}

/// The state one step \[s\] later. The input is held; a `.moving` input starts from its given
/// value.
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
#[cfg_attr(not(unoptimized), inline(always))]
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
#[cfg_attr(not(unoptimized), inline(always))]
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
/// The factors h a are the same for all coordinates, and for all steps of equal length: they are
/// computed once.
#[cfg_attr(not(unoptimized), inline(always))]
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

/// A Runge–Kutta method with differences to methods of lower order, which estimate the error.
pub trait Embedded: RungeKutta {
    /// The estimated error is of order `h^ESTIMATE` in the step.
    const ESTIMATE: usize;

    /// One difference, or two.
    type Differences<A>: AsRef<[A]>;

    /// The increment of the coordinates, and the differences.
    fn sums<E: Rates>(
        equations: &E,
        time: <E::State as State>::Scalar,
        coordinates: &<E::State as Coordinates>::Array,
        step: <E::State as State>::Scalar,
    ) -> Sums<Self, <E::State as Coordinates>::Array>;
}

/// The increment of a step, and the differences to methods of lower order.
pub(in crate::integrate) type Sums<M, A> = (A, <M as Embedded>::Differences<A>);

/// Defines a method by its tableau: the time of each stage and its coefficients, the weights of the
/// step, and the differences to other methods with their additional stages.
macro_rules! tableau {
    (
        $(#[$doc:meta])* $name:ident: order $order:literal;
        stages $stages:tt
        sum $sum:tt
        $(error of order $estimate:literal {
            $(stages $further:tt)?
            $(difference $difference:tt)+
        })?
    ) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
        pub struct $name;

        impl RungeKutta for $name {
            const ORDER: usize = $order;

            #[cfg_attr(not(unoptimized), inline(always))]
            fn increment<B: RigidBody<Scalar: Scalar, State: Coordinates>>(
                equations: &Equations<'_, B>,
                time: B::Scalar,
                coordinates: &<B::State as Coordinates>::Array,
                step: B::Scalar,
            ) -> <B::State as Coordinates>::Array {
                tableau!(@stages B::State, (equations, time, coordinates, step) $stages);
                tableau!(@sum B::State, step, $sum)
            }
        }

        $(impl Embedded for $name {
            const ESTIMATE: usize = $estimate;

            type Differences<A> = [A; 0 $(+ tableau!(@one $difference))+];

            #[cfg_attr(not(unoptimized), inline(always))]
            fn sums<E: Rates>(
                equations: &E,
                time: <E::State as State>::Scalar,
                coordinates: &<E::State as Coordinates>::Array,
                step: <E::State as State>::Scalar,
            ) -> Sums<Self, <E::State as Coordinates>::Array> {
                tableau!(@stages E::State, (equations, time, coordinates, step) $stages);
                $(tableau!(@stages E::State, (equations, time, coordinates, step) $further);)?
                let sum = tableau!(@sum E::State, step, $sum);
                (sum, [$(tableau!(@sum E::State, step, $difference)),+])
            }
        })?
    };
    (
        @stages $state:ty, ($equations:ident, $time:ident, $coordinates:ident, $step:ident)
        { $($k:ident at $c:literal $(from $($a:literal $j:ident),+)?;)+ }
    ) => {
        $(let $k = {
            let stage = *$coordinates;
            $(let stage = moved::<$state, _>(&stage, $step, [$(($a, &$j)),+]);)?
            $equations.rates($time + number($step, $c) * $step, &stage)
        };)+
    };
    (@sum $state:ty, $step:ident, { $($weight:literal $k:ident),+ }) => {
        change::<$state, _>($step, [$(($weight, &$k)),+])
    };
    (@one $difference:tt) => { 1 };
}
use tableau;
