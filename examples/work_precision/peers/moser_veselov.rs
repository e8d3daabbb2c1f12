//! A variational method of order two, between two half kicks of the load: the step turns the body by the quaternion `(e₀, e)` that solves
//!
//! ```text
//! h J ω = 2 e₀ J e + 2 e x J e
//! ```
//!
//! J. Moser, A. P. Veselov, Commun. Math. Phys. 139 (1991) 217; by quaternions after E. Hairer, G. Vilmart, J. Phys. A 39 (2006) 13225.
//! It keeps momentum and symplectic form, and the energy of the free body.

use std::hint::black_box;

use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use newton_euler::prelude::*;

use crate::by_hand::{Load, Turning};
use crate::method::Method;
use crate::problem::Problem;

pub fn method<L: Load>(problem: &Problem<Turning<L>>) -> Method<'_, Rotation> {
    let Turning { moments, load } = &problem.body;
    Method::fixed("discrete Moser-Veselov", move |steps| {
        let h = problem.seconds / f64::from(steps);
        let start = black_box(&problem.start);
        let mut attitude = start.attitude;
        let mut momentum = moments.component_mul(&start.angular_velocity);
        let mut kick = load.moment(&attitude) * (0.5 * h);
        for _ in 0..steps {
            momentum += kick;
            let turn = turn(moments, &(momentum * (0.5 * h)));
            momentum = turn.inverse_transform_vector(&momentum);
            attitude *= turn;
            kick = load.moment(&attitude) * (0.5 * h);
            momentum += kick;
        }
        Rotation {
            attitude,
            angular_velocity: momentum.component_div(moments),
        }
    })
}

/// The turn of a step, from half of it times the momentum, by iteration to rounding: each round gains a factor of the angle. A step
/// too long for a solution is NaN.
#[inline(always)]
fn turn(moments: &Vector3<f64>, half: &Vector3<f64>) -> UnitQuaternion<f64> {
    let mut e = half.component_div(moments);
    for _ in 0..50 {
        let scalar = (1.0 - e.norm_squared()).sqrt();
        let next = (half - e.cross(&moments.component_mul(&e))).component_div(moments) / scalar;
        let change = (next - e).norm_squared();
        e = next;
        if change <= 1e-30 * e.norm_squared() {
            break;
        }
    }
    let scalar = (1.0 - e.norm_squared()).sqrt();
    UnitQuaternion::new_unchecked(Quaternion::from_parts(scalar, e))
}
