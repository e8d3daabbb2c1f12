//! The classical method of order four on coordinates, the quaternion normalized after each step: what is found in most
//! simulators.
//!
//! W. Kutta, Zeitschrift für Mathematik und Physik 46 (1901) 435.

use std::hint::black_box;

use newton_euler::prelude::*;
use newton_euler::state::Coordinates;

use crate::method::Method;
use crate::problem::Problem;

/// A state whose coordinates are not independent.
pub trait Renormalized {
    /// With an attitude of unit length.
    #[must_use]
    fn renormalized(self) -> Self;
}

impl Renormalized for Hinge {
    #[inline(always)]
    fn renormalized(self) -> Self {
        self
    }
}

impl Renormalized for Rotation {
    #[inline(always)]
    fn renormalized(mut self) -> Self {
        self.attitude.renormalize();
        self
    }
}

impl Renormalized for Spatial {
    #[inline(always)]
    fn renormalized(mut self) -> Self {
        self.attitude.renormalize();
        self
    }
}

pub fn method<B>(problem: &Problem<B>) -> Method<'_, B::State>
where
    B: RigidBody<Scalar = f64, Input = (), State: Coordinates<Scalar = f64> + Renormalized>,
{
    Method::fixed("RK4 by hand", |steps| {
        let h = problem.seconds / f64::from(steps);
        (0..steps).fold(black_box(&problem.start).clone(), |state, k| {
            let y = state.coordinates();
            step(&problem.body, f64::from(k) * h, &y, h).renormalized()
        })
    })
}

/// `y + h/6 (k1 + 2 k2 + 2 k3 + k4)`
#[inline(always)]
fn step<B>(body: &B, t: f64, y: &Numbers<B>, h: f64) -> B::State
where
    B: RigidBody<Scalar = f64, Input = (), State: Coordinates<Scalar = f64>>,
{
    let k1 = rates(body, t, y);
    let k2 = rates(body, t + 0.5 * h, &moved(*y, 0.5 * h, &k1));
    let k3 = rates(body, t + 0.5 * h, &moved(*y, 0.5 * h, &k2));
    let k4 = rates(body, t + h, &moved(*y, h, &k3));
    let outer = moved(moved(*y, h / 6.0, &k1), h / 6.0, &k4);
    B::State::from_coordinates(&moved(moved(outer, h / 3.0, &k2), h / 3.0, &k3))
}

/// The coordinates of a body.
type Numbers<B> = <<B as RigidBody>::State as Coordinates>::Array;

/// Their derivatives with respect to time.
#[inline(always)]
pub fn rates<B>(body: &B, time: f64, numbers: &Numbers<B>) -> Numbers<B>
where
    B: RigidBody<Scalar = f64, Input = (), State: Coordinates<Scalar = f64>>,
{
    let state = B::State::from_coordinates(numbers);
    state.rates(&body.acceleration(time, &state, &()))
}

/// `y + h k`
#[inline(always)]
fn moved<A: AsRef<[f64]> + AsMut<[f64]>>(mut y: A, h: f64, k: &A) -> A {
    for (y, k) in y.as_mut().iter_mut().zip(k.as_ref()) {
        *y += h * k;
    }
    y
}
