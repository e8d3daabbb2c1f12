//! A linearization in blocks, compared with the accelerations alone.

use std::hint::black_box;

use nalgebra::{UnitQuaternion, Vector3};
use newton_euler::prelude::*;

use crate::bodies::{Crazyflie, CrazyflieInput};
use crate::paired::paired;
use crate::table::Table;

const COUNT: u32 = 128;

type Case = (Spatial, CrazyflieInput);

fn case(i: u32) -> Case {
    let x = f64::from(i) * 0.37;
    let state = Spatial {
        position: Vector3::zeros(),
        attitude: UnitQuaternion::from_euler_angles(x, 2.0 * x, 3.0 * x),
        velocity: Vector3::zeros(),
        angular_velocity: Vector3::new(x.sin(), x.cos(), (2.0 * x).sin()),
    };
    let [thrust_1, thrust_2, thrust_3, thrust_4] =
        [1.0, 2.0, 3.0, 4.0].map(|k: f64| 0.07 + 0.01 * (k * x).sin());
    let input = CrazyflieInput {
        thrust_1,
        thrust_2,
        thrust_3,
        thrust_4,
    };
    (state, input)
}

/// The compiler cannot look into these calls; a linearization is not inlined either. Results stay
/// where they are made, because a copy of them would be timed, too.
#[inline(never)]
fn acceleration(body: &Crazyflie, (state, input): &Case) {
    black_box(&body.acceleration(0.0, state, input));
}

#[inline(never)]
fn linearization(body: &Crazyflie, (state, input): &Case) {
    black_box(&body.linearize(0.0, state, input));
}

pub fn measure(table: &mut Table) {
    let body = Crazyflie::default();
    let cases: Vec<Case> = (0..COUNT).map(case).collect();
    for (state, input) in &cases {
        let direct = body.acceleration(0.0, state, input);
        let found = body.linearize(0.0, state, input).acceleration;
        assert!((found.linear - direct.linear).norm() < 1e-13);
        assert!((found.angular - direct.angular).norm() < 1e-12);
    }
    let times = paired(
        COUNT,
        || {
            for case in black_box(&cases) {
                linearization(&body, case);
            }
        },
        || {
            for case in black_box(&cases) {
                acceleration(&body, case);
            }
        },
    );
    let what = "linearization of a quadrotor, against accelerations";
    table.row(what.to_owned(), times, Some(2.5));
}
