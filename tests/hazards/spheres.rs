//! H7: bodies that are nearly spherical.

use nalgebra::{Matrix3, Vector3};
use newton_euler::gyroscopic;
use newton_euler::prelude::*;
use newton_euler::state::generic;

use crate::exact::{
    Exact, Tensor, ULP32, cross, decimal, off, rational, solved, symmetric, times, vector, worse,
};
use crate::table::Record;

/// Of `S`: xx, yy, zz, xy, yz, zx.
const FORM: [f64; 6] = [1.3, 1.7, 2.1, -0.12, -0.05, 0.07];

macro_rules! nearly {
    ($($module:ident: $epsilon:tt),+) => {
        $(mod $module {
            newton_euler::rigid_body!(Ball::<T> {
                motion: rotation,
                inertia: tensor {
                    xx: 1 + 1.3 * $epsilon,
                    yy: 1 + 1.7 * $epsilon,
                    zz: 1 + 2.1 * $epsilon,
                    xy: -0.12 * $epsilon,
                    yz: -0.05 * $epsilon,
                    zx: 0.07 * $epsilon,
                },
            });
        })+

        /// ε as it is written, and the acceleration in double and single precision.
        fn nearly_spherical(w: Vector3<f32>) -> Vec<(&'static str, Vector3<f64>, Vector3<f64>)> {
            let state = Rotation { angular_velocity: w.map(f64::from), ..Rotation::default() };
            let single = generic::Rotation { angular_velocity: w, ..generic::Rotation::default() };
            vec![$((
                stringify!($epsilon),
                $module::Ball::<f64>::default().acceleration(0.0, &state, &()),
                $module::Ball::<f32>::default().acceleration(0.0, &single, &()).map(f64::from),
            )),+]
        }
    };
}

nearly! { near_2: 1e-2, near_6: 1e-6, near_10: 1e-10, near_13: 1e-13 }

rigid_body!(Ball {
    motion: rotation,
    params: [xx, yy, zz, xy, yz, zx],
    inertia: tensor {
        xx: xx,
        yy: yy,
        zz: zz,
        xy: xy,
        yz: yz,
        zx: zx
    },
});

/// `-(w x J w)`
fn torque(j: &Tensor, w: &Exact) -> Exact {
    cross(&times(j, w), w)
}

fn matrix([xx, yy, zz, xy, yz, zx]: [f64; 6]) -> Matrix3<f64> {
    Matrix3::new(xx, xy, zx, xy, yy, yz, zx, yz, zz)
}

pub fn nearly() -> Vec<Record> {
    let w32 = Vector3::new(0.3_f32, -1.1, 0.7);
    let w = w32.map(f64::from);
    let rate = vector(&w);
    let (mut records, mut in_single) = (Vec::new(), 0.0);
    for (digits, double, single) in nearly_spherical(w32) {
        let epsilon: f64 = digits.parse().expect("a number");
        let unit = |k: usize| if k < 3 { 1.0 } else { 0.0 };
        let entries: [f64; 6] = core::array::from_fn(|k| unit(k) + epsilon * FORM[k]);
        let j = matrix(entries);
        let straightforward = -w.cross(&(j * w));
        let by = 1e-17 / epsilon;

        // as written
        let forms = ["1.3", "1.7", "2.1", "-0.12", "-0.05", "0.07"].map(decimal);
        let written = core::array::from_fn(|k| rational(unit(k)) + decimal(digits) * &forms[k]);
        let written = symmetric(written);
        let exact = solved(&written, &torque(&written, &rate));
        let inverse = j.try_inverse().expect("nearly the unit matrix");
        let plain = off(&(inverse * straightforward), &exact);
        let case = format!("numbers, ε = {digits}");
        records.push(Record::fails(case, plain, by).ours(off(&double, &exact), 1e-14));
        in_single = worse(in_single, off(&single, &exact));

        // of the doubles
        let given = symmetric(entries.map(rational));
        let exact = solved(&given, &torque(&given, &rate));
        let plain = off(&(inverse * straightforward), &exact);
        let [xx, yy, zz, xy, yz, zx] = entries;
        let ball = Ball::new(BallParams {
            xx,
            yy,
            zz,
            xy,
            yz,
            zx,
        })
        .expect("a ball");
        let state = Rotation {
            angular_velocity: w,
            ..Rotation::default()
        };
        let ours = off(&ball.acceleration(0.0, &state, &()), &exact);
        records.push(Record::fails(format!("params, ε = {digits}"), plain, by).ours(ours, 1e-14));

        let tensor = InertiaTensor::tensor(xx, yy, zz, xy, yz, zx).expect("a ball");
        let exact = torque(&given, &rate);
        let plain = off(&straightforward, &exact);
        let ours = off(&-gyroscopic::torque(&tensor, &w), &exact);
        records.push(Record::fails(format!("runtime, ε = {digits}"), plain, by).ours(ours, 1e-14));
    }
    records.push(Record::alone("numbers, all of these, f32").ours(in_single, 4.0 * ULP32));
    records
}
