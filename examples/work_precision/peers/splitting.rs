//! A geometric method of order two: half a kick, five rotations about principal axes, half a kick. Symplectic; no drift of energy.
//!
//! J. Touma, J. Wisdom, Astron. J. 107 (1994) 1189; S. Reich, Physica D 76 (1994) 375. Molecular dynamics knows it as `NO_SQUISH`: T. F.
//! Miller et al., J. Chem. Phys. 116 (2002) 8649.

use std::hint::black_box;

use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use newton_euler::prelude::*;

use crate::by_hand::{Load, Turning};
use crate::method::Method;
use crate::problem::Problem;

pub fn method<L: Load>(problem: &Problem<Turning<L>>) -> Method<'_, Rotation> {
    let Turning { moments, load } = &problem.body;
    Method::fixed("5 rotations, symplectic", move |steps| {
        let h = problem.seconds / f64::from(steps);
        let start = black_box(&problem.start);
        let mut attitude = start.attitude;
        let mut momentum = moments.component_mul(&start.angular_velocity);
        let mut kick = load.moment(&attitude) * (0.5 * h);
        for _ in 0..steps {
            momentum += kick;
            for (axis, share) in [(2, 0.5), (1, 0.5), (0, 1.0), (1, 0.5), (2, 0.5)] {
                let angle = share * h * momentum[axis] / moments[axis];
                turn(axis, angle, &mut attitude, &mut momentum);
            }
            kick = load.moment(&attitude) * (0.5 * h);
            momentum += kick;
        }
        Rotation {
            attitude,
            angular_velocity: momentum.component_div(moments),
        }
    })
}

/// Turns the body about one of its axes, and so the momentum back in its axes.
#[inline(always)]
fn turn(axis: usize, angle: f64, attitude: &mut UnitQuaternion<f64>, momentum: &mut Vector3<f64>) {
    let (sine, cosine) = (0.5 * angle).sin_cos();
    let mut turned = Quaternion::new(cosine, 0.0, 0.0, 0.0);
    turned.coords[axis] = sine;
    *attitude *= UnitQuaternion::new_unchecked(turned);
    // sine and cosine of the whole angle
    let (s, c) = (2.0 * sine * cosine, 1.0 - 2.0 * sine * sine);
    let (next, last) = ((axis + 1) % 3, (axis + 2) % 3);
    let (y, z) = (momentum[next], momentum[last]);
    momentum[next] = c * y + s * z;
    momentum[last] = c * z - s * y;
}
