//! Whole motions and single steps along series, as functions.

use core::ops::Range;

use super::TaylorSeries;
use crate::integrate::steps::error::IntegrationError;
use crate::integrate::steps::method::{Method, Run};
use crate::integrate::steps::setting::{self, Setting};
use crate::taylor::{Plain, Series, Taylor, after};

/// The state at the end of a span of time \[s\], from the state at its start. The input is held, or
/// moves from its given value. The error of each step is below `tolerance`; time may run backwards.
///
/// The tolerance is relative to position, attitude, velocity and angular velocity, each as a whole,
/// and absolute (m, rad, m/s, rad/s) where these are below 1. The error at the end is the sum of
/// the errors of all steps, each propagated by the motion. The order follows from the tolerance: 10, 12, 16 or 20.
///
/// ```
/// use newton_euler::{integrate, prelude::*};
///
/// rigid_body!(Handle {
///     motion: rotation,
///     inertia: principal(1, 2, 3)[kg * m ^ 2],
///     outputs: [taylor],
/// });
///
/// // A handle thrown spinning about its intermediate axis flips over.
/// let start = Rotation { angular_velocity: [0.01, 1.0, 0.01].into(), ..Rotation::default() };
/// let flipped = integrate::taylor(&Handle::default(), &start, &(), 0.0..19.55, 1e-12)?;
/// assert!(flipped.angular_velocity.y < -0.99);
/// # Ok::<(), integrate::IntegrationError<Rotation>>(())
/// ```
///
/// # Errors
/// [`IntegrationError`], if a time, the state or the tolerance is impossible, or the motion leaves
/// the range of numbers.
pub fn taylor<B: Taylor>(
    body: &B,
    state: &B::State,
    input: &B::Input,
    times: Range<f64>,
    tolerance: f64,
) -> Result<B::State, IntegrationError<B::State>> {
    let checked = setting::check(&times, [(Setting::Tolerance, tolerance)]);
    let checked = checked.and_then(|()| setting::check_state(state));
    checked.map_err(|invalid| IntegrationError::refused(invalid, times.start, state.clone()))?;
    let mut run = TaylorSeries { tolerance }.start(body, times.start, state);
    let reached = run.seek(body, times.end, times.end, input);
    let forwards = times.end >= times.start;
    reached.map_err(|error| error.named(body, input, forwards))?;
    Ok(run.state())
}

/// The state one step \[s\] later, by N coefficients, which give order N - 1. The input is held, or
/// moves from its given value.
#[must_use]
pub fn taylor_step<B: Taylor, const N: usize>(
    body: &B,
    time: f64,
    state: &B::State,
    input: &B::Input,
    step: f64,
) -> B::State {
    let (mut series, mut products) = (Series::<_, N>::default(), B::Products::from(Plain));
    body.expand(time, state, input, &mut products, &mut series);
    let coordinates = after::<B::State>(series.coefficients(), step);
    body.axes(time, state).state(&coordinates, time + step)
}
