//! A Lie group method: the classical method of order four in the tangent space, moved to the group by one exponential.
//!
//! H. Munthe-Kaas, High order Runge-Kutta methods on manifolds, Applied Numerical Mathematics 29 (1999) 115. With `q = q₀ exp(σ)`,
//!
//! ```text
//! σ' = ω + σ x ω / 2 + σ x (σ x ω) / 12
//! ```

use std::hint::black_box;

use nalgebra::{UnitQuaternion, Vector3};
use newton_euler::prelude::*;

use crate::method::Method;
use crate::problem::Problem;

pub fn method<B>(problem: &Problem<B>) -> Method<'_, Rotation>
where
    B: RigidBody<Scalar = f64, Input = (), State = Rotation>,
{
    Method::fixed("RKMK4", |steps| {
        let h = problem.seconds / f64::from(steps);
        (0..steps).fold(*black_box(&problem.start), |state, k| {
            step(&problem.body, f64::from(k) * h, &state, h)
        })
    })
}

#[inline(always)]
fn step<B>(body: &B, t: f64, start: &Rotation, h: f64) -> Rotation
where
    B: RigidBody<Scalar = f64, Input = (), State = Rotation>,
{
    let at = |sigma: &Vector3<f64>, w: Vector3<f64>| Rotation {
        attitude: start.attitude * UnitQuaternion::from_scaled_axis(*sigma),
        angular_velocity: w,
    };
    // rates of σ and ω, where these have moved by so much
    let rates = |t: f64, [sigma, change]: [Vector3<f64>; 2]| {
        let w = start.angular_velocity + change;
        let turned = sigma.cross(&w);
        [
            w + turned * 0.5 + sigma.cross(&turned) / 12.0,
            body.acceleration(t, &at(&sigma, w), &()),
        ]
    };
    let times = |k: [Vector3<f64>; 2], h: f64| k.map(|k| k * h);
    let k1 = rates(t, [Vector3::zeros(); 2]);
    let k2 = rates(t + 0.5 * h, times(k1, 0.5 * h));
    let k3 = rates(t + 0.5 * h, times(k2, 0.5 * h));
    let k4 = rates(t + h, times(k3, h));
    let mean = |i: usize| (k1[i] + (k2[i] + k3[i]) * 2.0 + k4[i]) * (h / 6.0);
    at(&mean(0), start.angular_velocity + mean(1))
}
