//! H8, H8b: rotation about the intermediate axis, and how rounding affects it.

use std::f64::consts::TAU;

use nalgebra::{Matrix3, UnitQuaternion, Vector3};
use newton_euler::exact::FreeRotation;
use newton_euler::integrate::{self, Classical4, DormandPrince8, Fixed, Motion};
use newton_euler::prelude::*;
use newton_euler::state::generic;

use crate::exact::worse;
use crate::table::Record;
use crate::{runge_kutta, steps};

rigid_body!(Handle::<T> {
    motion: rotation,
    inertia: principal(1, 2, 3)[kg * m ^ 2],
    outputs: [flow, taylor],
});

/// From energy and angular momentum: `T = 4 K(k) √(J1 J2 J3 / ((J3 - J2) (L² - 2 E J1)))`,
/// `k² = (J2 - J1) (2 E J3 - L²) / ((J3 - J2) (L² - 2 E J1))`. Landau and Lifshitz, Mechanics, (37.8) to (37.12).
fn straightforward_period(w: &Vector3<f64>) -> f64 {
    let j = Vector3::new(1.0, 2.0, 3.0);
    let momentum = j.component_mul(w);
    let (twice_energy, square) = (momentum.dot(w), momentum.norm_squared());
    let pace = (j.z - j.y) * (square - twice_energy * j.x);
    let modulus = (j.y - j.x) * (twice_energy * j.z - square) / pace;
    let (mut a, mut b) = (1.0_f64, (1.0 - modulus).sqrt());
    for _ in 0..60 {
        (a, b) = (f64::midpoint(a, b), (a * b).sqrt());
    }
    TAU / a * (j.product() / pace).sqrt()
}

pub fn periods() -> Vec<Record> {
    // by 40-digit arithmetic
    let periods = [
        (1e-2, 33.194_997_008_915_49, 0.0),
        (1e-4, 65.109_084_209_575_28, 1e-11),
        (1e-6, 97.014_641_058_692_23, 1e-7),
        (1e-8, 128.920_196_017_516_1, 1e-4),
        (1e-10, 160.825_750_976_047_3, 0.1),
        (1e-12, 192.731_305_934_578_5, 0.1),
    ];
    let mut records = Vec::new();
    for (d, period, by) in periods {
        let state = Rotation {
            angular_velocity: Vector3::new(d, 1.0, 2.0 * d),
            ..Rotation::default()
        };
        let error = |found: f64| {
            let error = (found / period - 1.0).abs();
            if error.is_finite() { error } else { f64::NAN }
        };
        let plain = error(straightforward_period(&state.angular_velocity));
        let written = Handle::<f64>::default().path(&state).period();
        let runtime =
            FreeRotation::principal([1.0, 2.0, 3.0], &Matrix3::identity(), &state).period();
        let ours = [written, runtime].map(|found| error(found.expect("a period")));
        let case = format!("macro and runtime, d = {d:.0e}");
        let record = if by == 0.0 {
            Record::holds(case, plain)
        } else {
            Record::fails(case, plain, by)
        };
        records.push(record.ours(worse(ours[0], ours[1]), 1e-13));
    }
    records
}

/// By a tensor that was turned, and turned back, which leaves products of inertia of 1e-16: the largest component across the
/// intermediate axis.
fn by_full_tensor(count: u32, h: f64) -> f64 {
    let turn = UnitQuaternion::from_euler_angles(0.3, 0.4, 0.5)
        .to_rotation_matrix()
        .into_inner();
    let moments = Matrix3::from_diagonal(&Vector3::new(1.0, 2.0, 3.0));
    let j = turn.transpose() * (turn * moments * turn.transpose()) * turn;
    let inverse = j.try_inverse().expect("a body");
    let rate = |w: &Vector3<f64>| -inverse * w.cross(&(j * w));
    let (mut w, mut largest) = (Vector3::y(), 0.0);
    for _ in 0..count {
        w = runge_kutta::step(rate, w, h);
        largest = worse(largest, w.x.abs().max(w.z.abs()));
    }
    largest
}

fn across(state: &Rotation) -> f64 {
    let (w, q) = (state.angular_velocity, state.attitude);
    [w.x, w.z, q.i, q.k]
        .into_iter()
        .fold(0.0, |largest, x| worse(largest, x.abs()))
}

pub fn zeros() -> Vec<Record> {
    let count = steps(1_000_000);
    let h = 0.01;
    let end = f64::from(count) * h;
    let plain = by_full_tensor(10_000, h);
    let start = Rotation {
        angular_velocity: Vector3::y(),
        ..Rotation::default()
    };
    let handle = Handle::<f64>::default();

    let (mut by_group, mut of_group) = (start, 0.0);
    for _ in 0..count {
        by_group = integrate::cf4_step(&handle, 0.0, &by_group, &(), h);
        of_group = worse(of_group, across(&by_group));
    }
    let mut series = Motion::<_, 5>::new(&handle, 0.0, &start);
    let mut of_series = 0.0;
    for _ in 0..count {
        series.step(h, &()).expect("a motion");
        of_series = worse(of_series, across(&series.state()));
    }
    let of_fourth = {
        let motion = handle.integrate(&start).method(Fixed {
            method: Classical4,
            step: h,
        });
        motion.steps(end).fold(0.0, |largest, step| {
            worse(largest, across(&step.expect("a motion").state))
        })
    };
    let of_eighth = {
        let motion = handle.integrate(&start).method(Fixed {
            method: DormandPrince8,
            step: h,
        });
        motion.steps(end).fold(0.0, |largest, step| {
            worse(largest, across(&step.expect("a motion").state))
        })
    };
    let of_path = across(&handle.flow(&start, 1e9));

    let single = Handle::<f32>::default();
    let mut state = generic::Rotation {
        angular_velocity: Vector3::<f32>::y(),
        ..generic::Rotation::default()
    };
    let mut of_single = 0.0;
    for _ in 0..count {
        state = integrate::cf4_step(&single, 0.0, &state, &(), 0.01);
        let w = state.angular_velocity;
        of_single = worse(of_single, f64::from(w.x.abs().max(w.z.abs())));
    }
    vec![
        Record::fails(format!("`cf4`, {count} steps"), plain, 0.5).ours(of_group, 0.0),
        Record::fails(format!("`TaylorSeries`, {count} steps"), plain, 0.5).ours(of_series, 0.0),
        Record::fails(format!("`Fixed<Classical4>`, {count} steps"), plain, 0.5)
            .ours(of_fourth, 0.0),
        Record::fails(
            format!("`Fixed<DormandPrince8>`, {count} steps"),
            plain,
            0.5,
        )
        .ours(of_eighth, 0.0),
        Record::alone("closed form, 1e9 s").ours(of_path, 0.0),
        Record::alone(format!("`cf4`, {count} steps, f32")).ours(of_single, 0.0),
    ]
}
