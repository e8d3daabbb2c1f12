//! A method of order two with the momentum in world axes, which a free body keeps: rotations about
//!
//! ```text
//! ω + h/2 ω' + h²/12 ω' x ω
//! ```
//!
//! between two half kicks of the load. S. R. Buss, J. Comput. Phys. 164 (2000) 377, the "augmented second-order method".

use std::hint::black_box;

use nalgebra::UnitQuaternion;
use newton_euler::prelude::*;

use crate::by_hand::{Load, Turning};
use crate::method::Method;
use crate::problem::Problem;

pub fn method<L: Load>(problem: &Problem<Turning<L>>) -> Method<'_, Rotation> {
    let Turning { moments, load } = &problem.body;
    Method::fixed("Buss, augmented", move |steps| {
        let h = problem.seconds / f64::from(steps);
        let start = black_box(&problem.start);
        let mut attitude = start.attitude;
        let mut momentum = attitude * moments.component_mul(&start.angular_velocity);
        let mut kick = attitude * load.moment(&attitude) * (0.5 * h);
        for _ in 0..steps {
            momentum += kick;
            // in body axes: ω, and ω' = -J⁻¹ (ω x J ω)
            let inside = attitude.inverse_transform_vector(&momentum);
            let w = inside.component_div(moments);
            let rate = inside.cross(&w).component_div(moments);
            let mean = w + rate * (0.5 * h) + rate.cross(&w) * (h * h / 12.0);
            attitude *= UnitQuaternion::from_scaled_axis(mean * h);
            kick = attitude * load.moment(&attitude) * (0.5 * h);
            momentum += kick;
        }
        let inside = attitude.inverse_transform_vector(&momentum);
        Rotation {
            attitude,
            angular_velocity: inside.component_div(moments),
        }
    })
}
