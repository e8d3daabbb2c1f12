//! H10, H11: inertias of any scale, and single precision.

use nalgebra::{Quaternion, SVector, UnitQuaternion, Vector3, Vector4};
use newton_euler::integrate;
use newton_euler::prelude::*;
use newton_euler::state::generic;

use crate::exact::{ULP32, decimal, off, rational, solved, symmetric, to_f32, vector};
use crate::table::Record;
use crate::{runge_kutta, steps};

rigid_body!(Body::<T> {
    motion: rotation,
    params: [xx, yy, zz, xy, yz, zx],
    inputs: [k = body(_, _, _)],
    inertia: tensor {
        xx: xx,
        yy: yy,
        zz: zz,
        xy: xy,
        yz: yz,
        zx: zx
    },
    moments: [drive = k],
});

macro_rules! written {
    ($($module:ident: $scale:tt),+) => {
        $(mod $module {
            newton_euler::rigid_body!(Body {
                motion: rotation,
                inputs: [k = body(_, _, _)],
                inertia: tensor {
                    xx: 1.3 * $scale,
                    yy: 1.7 * $scale,
                    zz: 2.1 * $scale,
                    xy: -0.12 * $scale,
                    yz: -0.05 * $scale,
                    zx: 0.07 * $scale,
                },
                moments: [drive = k],
            });
        })+

        /// The scale as it is written, and the acceleration under the couple times it.
        fn written() -> Vec<(&'static str, Vector3<f64>)> {
            vec![$((stringify!($scale), {
                let input = $module::BodyInput { k: COUPLE * $scale };
                $module::Body {}.acceleration(0.0, &Rotation::default(), &input)
            })),+]
        }
    };
}

written! { smallest: 1e-120, largest: 1e120 }

const FORM: [f64; 6] = [1.3, 1.7, 2.1, -0.12, -0.05, 0.07];
const COUPLE: Vector3<f64> = Vector3::new(0.3, -0.5, 0.7);

/// Adjugate over determinant.
macro_rules! by_adjugate {
    ($scalar:ty, $entries:expr, $k:expr) => {{
        let [xx, yy, zz, xy, yz, zx]: [$scalar; 6] = $entries;
        let rows = [
            Vector3::new(xx, xy, zx),
            Vector3::new(xy, yy, yz),
            Vector3::new(zx, yz, zz),
        ];
        let [a, b, c] = [
            rows[1].cross(&rows[2]),
            rows[2].cross(&rows[0]),
            rows[0].cross(&rows[1]),
        ];
        let k: Vector3<$scalar> = $k;
        let solved = Vector3::new(a.dot(&k), b.dot(&k), c.dot(&k)) / rows[0].dot(&a);
        solved.map(f64::from)
    }};
}

pub fn inertias() -> Vec<Record> {
    let mut records = Vec::new();
    for (digits, ours) in written() {
        let scale: f64 = digits.parse().expect("a number");
        let k = COUPLE * scale;
        let forms = ["1.3", "1.7", "2.1", "-0.12", "-0.05", "0.07"].map(decimal);
        let exact = solved(
            &symmetric(forms.map(|entry| entry * decimal(digits))),
            &vector(&k),
        );
        let plain = off(
            &by_adjugate!(f64, FORM.map(|entry| entry * scale), k),
            &exact,
        );
        let case = format!("numbers, {digits}");
        records.push(Record::fails(case, plain, 1.0).ours(off(&ours, &exact), 1e-15));
    }
    for decade in [-120, -110, 0, 110, 120] {
        let scale = 10_f64.powi(decade);
        let entries = FORM.map(|entry| entry * scale);
        let k = COUPLE * scale;
        let tensor = symmetric(entries.map(rational));
        let exact = solved(&tensor, &vector(&k));
        let plain = off(&by_adjugate!(f64, entries, k), &exact);
        let [xx, yy, zz, xy, yz, zx] = entries;
        let body = Body::new(BodyParams {
            xx,
            yy,
            zz,
            xy,
            yz,
            zx,
        })
        .expect("a body");
        let ours = body.acceleration(0.0, &Rotation::default(), &BodyInput { k });
        let inertia = InertiaTensor::tensor(xx, yy, zz, xy, yz, zx).expect("a body");
        let runtime = inertia.inverse().expect("no rod") * k;
        for (through, ours) in [("params", ours), ("runtime", runtime)] {
            let case = format!("{through}, 1e{decade}");
            let record = if decade == 0 {
                Record::holds(case, plain)
            } else {
                Record::fails(case, plain, 1.0)
            };
            records.push(record.ours(off(&ours, &exact), 1e-15));
        }
    }
    for scale in [1e-30_f32, 1e-20, 1.0, 1e24, 1e30] {
        let (entries, k) = (
            FORM.map(|entry| to_f32(entry) * scale),
            COUPLE.map(|x| to_f32(x) * scale),
        );
        let tensor = symmetric(entries.map(f64::from).map(rational));
        let exact = solved(&tensor, &vector(&k.map(f64::from)));
        let plain = off(&by_adjugate!(f32, entries, k), &exact);
        let [xx, yy, zz, xy, yz, zx] = entries;
        let body = Body::new(BodyParams {
            xx,
            yy,
            zz,
            xy,
            yz,
            zx,
        })
        .expect("a body");
        let ours = body.acceleration(0.0, &generic::Rotation::default(), &BodyInput { k });
        let case = format!("params, {scale:.0e}, f32");
        #[expect(clippy::float_cmp, reason = "one of the list")]
        let record = if scale == 1.0 {
            Record::holds(case, plain)
        } else {
            Record::fails(case, plain, 1.0)
        };
        records.push(record.ours(off(&ours.map(f64::from), &exact), 1e-6));
    }
    records
}

rigid_body!(Handle::<T> {
    motion: rotation,
    inertia: principal(1, 2, 3)[kg * m ^ 2],
    outputs: [energy, momentum],
});

/// Energy and angular momentum, relative to what they were, of steps without compensation.
fn straightforward_drift(count: u32) -> [f64; 2] {
    type State = SVector<f32, 7>;
    let j = Vector3::new(1.0, 2.0, 3.0);
    let parts = |state: &State| {
        let q: Vector4<f32> = state.fixed_rows::<4>(0).into();
        let w: Vector3<f32> = state.fixed_rows::<3>(4).into();
        (Quaternion::from(q), w)
    };
    let rate = |state: &State| {
        let (q, w) = parts(state);
        let turning = (q * Quaternion::from_imag(w) * 0.5).coords;
        let angular = j.component_mul(&w).cross(&w).component_div(&j);
        State::from_iterator(turning.iter().chain(angular.iter()).copied())
    };
    let conserved = |state: &State| {
        let (q, w) = parts(state);
        let momentum = j.component_mul(&w);
        (
            w.dot(&momentum),
            UnitQuaternion::new_normalize(q) * momentum,
        )
    };
    let start = State::from([0.0, 0.0, 0.0, 1.0, 0.01, 1.0, 0.01]);
    let end = (0..count).fold(start, |state, _| runge_kutta::step(rate, state, 0.01));
    let ((energy, momentum), (after, turned)) = (conserved(&start), conserved(&end));
    [
        f64::from((after / energy - 1.0).abs()),
        f64::from((turned - momentum).norm() / momentum.norm()),
    ]
}

pub fn single_precision() -> Vec<Record> {
    let handle = Handle::<f32>::default();
    let start = generic::Rotation {
        angular_velocity: Vector3::new(0.01_f32, 1.0, 0.01),
        ..generic::Rotation::default()
    };
    let mut records = Vec::new();
    for count in [1000, 10_000, steps(1_000_000)] {
        let mut state = start;
        for _ in 0..count {
            state = integrate::cf4_step(&handle, 0.0, &state, &(), 0.01);
        }
        let limit = 50.0 * ULP32 * f64::from(count).sqrt();
        let energy =
            f64::from(handle.kinetic_energy(&state) / handle.kinetic_energy(&start) - 1.0).abs();
        let [before, after] = [start, state].map(|state| handle.angular_momentum(&state));
        let momentum = f64::from((after - before).norm() / before.norm());
        let plain = straightforward_drift(count);
        records.push(
            Record::holds(format!("energy, {count} steps of 0.01 rad"), plain[0])
                .ours(energy, limit),
        );
        records.push(
            Record::holds(format!("angular momentum, {count} steps"), plain[1])
                .ours(momentum, limit),
        );
    }
    records
}
