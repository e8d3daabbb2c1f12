//! The arguments of an evaluation: time, state, inputs and parameters as lists of numbers.

use nalgebra::{Vector2, Vector3};
use newton_euler::prelude::*;
use newton_euler::state::Coordinates;

#[derive(Clone, Debug, Default)]
pub struct Given {
    pub time: f64,
    pub params: Vec<f64>,
    pub inputs: Vec<f64>,
    /// The coordinates of the state.
    pub state: Vec<f64>,
    /// The states of one's own.
    pub own: Vec<f64>,
    /// An acceleration, to ask for the residual in it.
    pub motion: Vec<f64>,
}

/// Of the descriptions with constants.
#[allow(dead_code, reason = "descriptions alone name it")]
pub const CONSTANT: f64 = 0.732_421_875;

/// Of those with functions.
#[allow(dead_code, reason = "descriptions alone name it")]
pub fn bump(x: f64) -> f64 {
    x / (1.0 + x * x)
}

#[allow(dead_code, reason = "descriptions alone name it")]
pub fn bump_slope(x: f64) -> f64 {
    let square = x * x;
    (1.0 - square) / ((1.0 + square) * (1.0 + square))
}

#[allow(dead_code, reason = "descriptions alone name it")]
pub fn bump_bend(x: f64) -> f64 {
    let (square, more) = (x * x, 1.0 + x * x);
    2.0 * x * (square - 3.0) / (more * more * more)
}

/// The state in the body's own type.
pub fn state<S: Coordinates<Scalar = f64>>(given: &Given) -> S {
    let mut array = S::Array::default();
    array.as_mut().copy_from_slice(&given.state);
    S::from_coordinates(&array)
}

/// The acceleration in the body's own type.
pub fn motion<A: Motion>(given: &Given) -> A {
    A::read(&given.motion)
}

pub trait Motion {
    fn read(numbers: &[f64]) -> Self;
}

impl Motion for f64 {
    fn read(numbers: &[f64]) -> Self {
        numbers[0]
    }
}

impl Motion for Vector2<f64> {
    fn read(numbers: &[f64]) -> Self {
        Self::new(numbers[0], numbers[1])
    }
}

impl Motion for Vector3<f64> {
    fn read(numbers: &[f64]) -> Self {
        Self::new(numbers[0], numbers[1], numbers[2])
    }
}

impl Motion for PlanarAcceleration {
    fn read(numbers: &[f64]) -> Self {
        Self {
            linear: Vector2::read(numbers),
            angular: numbers[2],
        }
    }
}

impl Motion for SpatialAcceleration {
    fn read(numbers: &[f64]) -> Self {
        Self {
            linear: Vector3::read(numbers),
            angular: Vector3::read(&numbers[3..]),
        }
    }
}

impl Motion for RodAcceleration {
    fn read(numbers: &[f64]) -> Self {
        Self {
            linear: Vector3::read(numbers),
            axis: Vector3::read(&numbers[3..]),
        }
    }
}
