//! The commutator-free Lie group method of order four, CF4.
//!
//! E. Celledoni, A. Marthinsen, B. Owren, Commutator-free Lie group methods, Future Generation
//! Computer Systems 19 (2003)
//! 341. Four evaluations and five exponentials a step:
//!
//! ```text
//! k1 = f(y)    k2 = f(y exp(h k1/2))    k3 = f(y exp(h k2/2))
//! k4 = f(y exp(h k1/2) exp(h (k3 - k1/2)))
//! y₁ = y exp(h/12 (3 k1 + 2 k2 + 2 k3 - k4)) exp(h/12 (-k1 + 2 k2 + 2 k3 + 3 k4))
//! ```
//!
//! On straight lines this is the classical Runge-Kutta method. Its weights with a single
//! exponential at the end would give only order two in the attitude, because rotations do not
//! commute.

use core::ops::Range;

use crate::bodies::body::RigidBody;
use crate::integrate::steps::stretch::Given;
use crate::numbers::count::{real, single};
use crate::numbers::scalar::Scalar;
use crate::state::State;

/// The state one step \[s\] later. The input is held; a `.moving` input starts from its given
/// value.
///
/// The error of one step is of order step⁵, in all coordinates alike.
///
/// ```
/// use newton_euler::{integrate, prelude::*};
/// use newton_euler::nalgebra::Vector2;
///
/// struct Thrown;
///
/// impl RigidBody for Thrown {
///     type Scalar = f64;
///     type State = PlanarTranslation;
///     type Input = ();
///
///     fn acceleration(&self, _: f64, _: &PlanarTranslation, (): &()) -> Vector2<f64> {
///         Vector2::new(0.0, -9.8)
///     }
/// }
///
/// let later = integrate::cf4_step(&Thrown, 0.0, &PlanarTranslation::default(), &(), 2.0);
/// assert!((later.position.y + 19.6).abs() < 1e-14); // exact for parabolas
/// ```
#[must_use]
#[cfg_attr(not(unoptimized), inline(always))]
pub fn cf4_step<B: RigidBody<Scalar: Scalar>>(
    body: &B,
    time: B::Scalar,
    state: &B::State,
    input: &B::Input,
    step: B::Scalar,
) -> B::State {
    let body = Given { body, at: time };
    let rate = |time, state: &B::State| state.rate(&body.acceleration(time, state, input));
    let [half, two, three] = [
        step.constant(0.5, 0.5),
        step.constant(2.0, 2.0),
        step.constant(3.0, 3.0),
    ];
    let half_step = half * step;
    let middle = time + half_step;

    let k1 = rate(time, state);
    let between = state.moved(&(k1 * half_step));
    let k2 = rate(middle, &between);
    let k3 = rate(middle, &state.moved(&(k2 * half_step)));
    let k4 = rate(time + step, &between.moved(&((k3 - k1 * half) * step)));

    let twelfth = step / step.constant(12.0, 12.0);
    let inner = (k2 + k3) * two;
    state
        .moved(&((k1 * three + inner - k4) * twelfth))
        .moved(&((k4 * three + inner - k1) * twelfth))
}

/// The state at the end of a span of time \[s\], from the state at its start, in equal steps of
/// [`cf4_step`]; the input is held. Time may run backwards. With zero steps the state is returned
/// unchanged.
///
/// Step k begins at start + k · step, so times do not accumulate rounding. States do: the increment
/// of a step is rounded when it is added, and is lost if it is smaller than that rounding. Over
/// many small steps, and far from the origin, use
/// [`integrate`](crate::integrate::Integrate::integrate), which compensates.
///
/// ```
/// use newton_euler::{gyroscopic, integrate, prelude::*};
/// use newton_euler::nalgebra::Vector3;
///
/// struct Free(InertiaTensor);
///
/// impl RigidBody for Free {
///     type Scalar = f64;
///     type State = Rotation;
///     type Input = ();
///
///     fn acceleration(&self, _: f64, state: &Rotation, (): &()) -> Vector3<f64> {
///         let [xx, yy, zz] = self.0.moments();
///         -gyroscopic::torque(&self.0, &state.angular_velocity)
///             .component_div(&Vector3::new(xx, yy, zz))
///     }
/// }
///
/// // A handle thrown spinning about its intermediate axis flips over.
/// let handle = Free(InertiaTensor::principal(1.0, 2.0, 3.0)?);
/// let start = Rotation { angular_velocity: [0.01, 1.0, 0.01].into(), ..Rotation::default() };
/// let flipped = integrate::cf4(&handle, &start, &(), 0.0..19.55, 2000);
/// assert!(flipped.angular_velocity.y < -0.99);
/// # Ok::<(), newton_euler::inertia::InvalidInertia>(())
/// ```
#[must_use]
pub fn cf4<B: RigidBody<Scalar: Scalar>>(
    body: &B,
    state: &B::State,
    input: &B::Input,
    times: Range<B::Scalar>,
    steps: usize,
) -> B::State {
    let start = times.start;
    let count = |steps: usize| start.constant(real(steps), single(steps));
    let step = (times.end - start) / count(steps);
    (0..steps).fold(state.clone(), |state, k| {
        let time = start + count(k) * step;
        match body.input_after(input, time - start) {
            Some(moved) => cf4_step(body, time, &state, &moved, step),
            None => cf4_step(body, time, &state, input, step),
        }
    })
}
