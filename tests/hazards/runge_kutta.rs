//! The classical Runge-Kutta method, applied to the coordinates without any care for attitudes.

use std::ops::{Add, Mul};

use newton_euler::Scalar;

/// What a step of the classical method makes of a state.
pub fn step<T, S>(rate: impl Fn(&S) -> S, state: S, h: T) -> S
where
    T: Scalar,
    S: Copy + Add<Output = S> + Mul<T, Output = S>,
{
    let number = |value: u8| h.constant(f64::from(value), f32::from(value));
    let half = h / number(2);
    let k1 = rate(&state);
    let k2 = rate(&(state + k1 * half));
    let k3 = rate(&(state + k2 * half));
    let k4 = rate(&(state + k3 * h));
    state + (k1 + (k2 + k3) * number(2) + k4) * (h / number(6))
}
