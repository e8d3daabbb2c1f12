//! The step of a game engine, Jolt: half-implicit, of order one. The gyroscopic moment turns the momentum without changing its size.
//!
//! J. Rouwe, Jolt Physics, `MotionProperties::ApplyGyroscopicForceInternal`.

use std::hint::black_box;

use nalgebra::UnitQuaternion;
use newton_euler::prelude::*;

use crate::by_hand::{Load, Turning};
use crate::method::Method;
use crate::problem::Problem;

pub fn method<L: Load>(problem: &Problem<Turning<L>>) -> Method<'_, Rotation> {
    let Turning { moments, load } = &problem.body;
    Method::fixed("Jolt", move |steps| {
        let h = problem.seconds / f64::from(steps);
        let mut state = *black_box(&problem.start);
        for _ in 0..steps {
            let momentum = moments.component_mul(&state.angular_velocity);
            let turned = momentum - state.angular_velocity.cross(&momentum) * h;
            // a body at rest has nothing to turn
            let squares = momentum.norm_squared() / turned.norm_squared();
            let turned = if squares.is_finite() {
                turned * squares.sqrt()
            } else {
                turned
            };
            // the moment of the load at the start of the step
            let pushed = turned + load.moment(&state.attitude) * h;
            state.angular_velocity = pushed.component_div(moments);
            state.attitude *= UnitQuaternion::from_scaled_axis(state.angular_velocity * h);
        }
        state
    })
}
