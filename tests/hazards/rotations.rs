//! H4, H5, H6: attitudes, and their exponential and logarithm.

use std::f64::consts::PI;

use dashu_ratio::RBig;
use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use newton_euler::attitude;
use newton_euler::integrate::{self, Classical4, DormandPrince8, Fixed};
use newton_euler::prelude::*;
use newton_euler::state::generic;

use crate::exact::{Real, ULP, ULP32, dot, nearest, rational, real, vector, worse};
use crate::table::Record;
use crate::{is_full, runge_kutta, steps};

rigid_body!(Brick::<T> {
    motion: rotation,
    inertia: principal(1, 2, 3)[kg * m ^ 2],
    outputs: [taylor],
});

const RATES: Vector3<f64> = Vector3::new(0.3, -0.8, 0.5);

/// How far the norm is from 1.
fn of_norm(attitude: &UnitQuaternion<f64>) -> f64 {
    let [x, y, z, w] = attitude.as_ref().coords.map(rational).into();
    let square = &x * &x + &y * &y + &z * &z + &w * &w;
    // of |q| half of that of |q|²
    (nearest(&(square - RBig::ONE)) / 2.0).abs()
}

/// How far `R Rᵀ` is from the unit matrix, R as it is in doubles: four times the deviation of the norm, and the rounding of R.
fn of_matrix(attitude: &UnitQuaternion<f64>) -> f64 {
    let r = attitude.to_rotation_matrix().into_inner();
    let rows = [0, 1, 2].map(|i| vector(&r.row(i).transpose()));
    let pairs = (0..3).flat_map(|i| (i..3).map(move |k| (i, k)));
    pairs.fold(0.0, |largest, (i, k)| {
        let unit = if i == k { RBig::ONE } else { RBig::ZERO };
        worse(largest, nearest(&(dot(&rows[i], &rows[k]) - unit)).abs())
    })
}

/// The largest of both; of matrices, short of a full run, in every hundredth state.
fn largest(states: impl Iterator<Item = UnitQuaternion<f64>>) -> [f64; 2] {
    states
        .enumerate()
        .fold([0.0, 0.0], |[norm, matrix], (k, attitude)| {
            let norm = worse(norm, of_norm(&attitude));
            let is_next = is_full() || k % 100 == 0;
            [
                norm,
                if is_next {
                    worse(matrix, of_matrix(&attitude))
                } else {
                    matrix
                },
            ]
        })
}

/// The classical Runge-Kutta method on the four components.
fn by_components(count: u32, h: f64) -> f64 {
    let rate = |q: &Quaternion<f64>| q * Quaternion::from_imag(RATES) * 0.5;
    let mut q = Quaternion::identity();
    for _ in 0..count {
        q = runge_kutta::step(rate, q, h);
    }
    (q.norm() - 1.0).abs()
}

pub fn norms() -> Vec<Record> {
    let (count, h) = (steps(100_000), 0.1 / RATES.norm());
    let plain = by_components(count, h);
    let by = 5e-11 * f64::from(count);
    let start = Rotation {
        angular_velocity: RATES,
        ..Rotation::default()
    };
    let brick = Brick::<f64>::default();
    let end = h * f64::from(count);
    let mut by_group = Some(start);
    let by_group = core::iter::from_fn(|| {
        by_group = by_group.map(|state| integrate::cf4_step(&brick, 0.0, &state, &(), h));
        by_group.map(|state| state.attitude)
    });
    let count = usize::try_from(count).expect("a number of steps");
    let motions = [
        ("`cf4`", largest(by_group.take(count))),
        ("`Fixed<Classical4>`", {
            let motion = brick.integrate(&start).method(Fixed {
                method: Classical4,
                step: h,
            });
            largest(
                motion
                    .steps(end)
                    .map(|step| step.expect("a motion").state.attitude),
            )
        }),
        ("`Fixed<DormandPrince8>`", {
            let motion = brick.integrate(&start).method(Fixed {
                method: DormandPrince8,
                step: h,
            });
            largest(
                motion
                    .steps(end)
                    .map(|step| step.expect("a motion").state.attitude),
            )
        }),
        ("`TaylorSeries`, 1e-12", {
            let motion = brick.integrate(&start).tolerance(1e-12);
            largest(
                motion
                    .steps(end)
                    .map(|step| step.expect("a motion").state.attitude),
            )
        }),
    ];
    let mut records = Vec::new();
    for (method, [norm, square]) in motions {
        records.push(Record::fails(format!("norm, {method}"), plain, by).ours(norm, 4.0 * ULP));
        records.push(Record::alone(format!("`R Rᵀ`, {method}")).ours(square, 1.5e-15));
    }
    records.push(in_single_precision(count));
    records
}

fn in_single_precision(count: usize) -> Record {
    let brick = Brick::<f32>::default();
    let mut state = generic::Rotation {
        angular_velocity: Vector3::new(0.3_f32, -0.8, 0.5),
        ..generic::Rotation::default()
    };
    let mut largest = 0.0;
    for _ in 0..count {
        state = integrate::cf4_step(&brick, 0.0, &state, &(), 0.1);
        let square: f64 = state
            .attitude
            .as_ref()
            .coords
            .iter()
            .map(|x| f64::from(*x).powi(2))
            .sum();
        largest = worse(largest, (square.sqrt() - 1.0).abs());
    }
    Record::alone("norm, `cf4`, f32").ours(largest, 4.0 * ULP32)
}

/// Along (3, -4, 12)/13.
fn along(angle: f64) -> Vector3<f64> {
    Vector3::new(3.0, -4.0, 12.0) * (angle / 13.0)
}

fn norm(v: [f64; 3]) -> Real {
    let square = v
        .map(|x| real(x) * real(x))
        .into_iter()
        .fold(real(0.0), |sum, x| sum + x);
    if square == real(0.0) {
        square
    } else {
        square.sqrt()
    }
}

/// The error of a component, relative to it, or to the least number above zero.
fn error(computed: f64, exact: &Real, least: f64) -> f64 {
    if !computed.is_finite() {
        return f64::NAN;
    }
    let error = (real(computed) - exact).to_f64().value().abs();
    error / exact.to_f64().value().abs().max(least)
}

/// The error of `exp(v)`: of the scalar over 1, of the vector relative to each component. For least see [`error`].
fn exponential_error(v: [f64; 3], computed: [f64; 4], least: f64) -> f64 {
    let angle = norm(v);
    let half = &angle / real(2.0);
    let ratio = if angle == real(0.0) {
        real(0.5)
    } else {
        half.sin() / &angle
    };
    let [w, imaginary @ ..] = computed;
    let of_w = (real(w) - half.cos()).to_f64().value().abs();
    let components = v.into_iter().zip(imaginary);
    components.fold(of_w, |largest, (v, q)| {
        worse(largest, error(q, &(real(v) * &ratio), least))
    })
}

/// `sin(|v|/2)/|v| v` and, as the formula of Rodrigues has it, `(1 - cos θ)/θ²`.
fn straightforward_exponential(v: &Vector3<f64>) -> f64 {
    let angle = v.norm();
    let ratio = (0.5 * angle).sin() / angle;
    let [x, y, z] = (v * ratio).into();
    let of_vector = exponential_error(
        (*v).into(),
        [(0.5 * angle).cos(), x, y, z],
        f64::MIN_POSITIVE,
    );
    let factor = (1.0 - angle.cos()) / (angle * angle);
    let exact = norm((*v).into());
    let of_factor = if exact == real(0.0) {
        (factor - 0.5).abs()
    } else {
        let half = (&exact / real(2.0)).sin() / &exact;
        error(factor, &(real(2.0) * &half * &half), f64::MIN_POSITIVE)
    };
    worse(of_vector, of_factor)
}

pub fn exponentials() -> Vec<Record> {
    let ranges: [(&str, &[f64], f64); 6] = [
        ("θ = 0", &[0.0], f64::NAN),
        (
            "θ = 1e-320 to 1e-160",
            &[1e-320, 1e-300, 1e-200, 1e-170, 1e-160],
            f64::NAN,
        ),
        ("θ = 1e-12 to 1e-7", &[1e-12, 1e-10, 1e-8, 1e-7], 1e-2),
        ("θ = 1e-6 to 1e-2", &[1e-6, 1e-5, 1e-4, 1e-3, 1e-2], 1e-5),
        ("θ = 0.09 to 3", &[0.09, 0.1, 0.11, 0.5, 1.0, 2.0, 3.0], 0.0),
        (
            "θ = π - 1e-1 to π - 1e-12, π",
            &[PI - 1e-1, PI - 1e-4, PI - 1e-8, PI - 1e-12, PI],
            0.0,
        ),
    ];
    let mut records = Vec::new();
    for (case, angles, by) in ranges {
        let (mut plain, mut ours) = (0.0, 0.0);
        for angle in angles {
            let v = along(*angle);
            plain = worse(plain, straightforward_exponential(&v));
            let q = attitude::exp(&v);
            ours = worse(
                ours,
                exponential_error(v.into(), [q.w, q.i, q.j, q.k], f64::MIN_POSITIVE),
            );
        }
        let record = if by == 0.0 {
            Record::holds(case, plain)
        } else {
            Record::fails(case, plain, by)
        };
        records.push(record.ours(ours, 4.0 * ULP));
    }
    let mut ours = 0.0;
    for angle in [
        0.0, 1e-42_f32, 1e-30, 1e-20, 1e-10, 1e-4, 0.09, 0.11, 1.0, 3.0,
    ] {
        let v = Vector3::new(3.0, -4.0, 12.0) * (angle / 13.0);
        let q: [f32; 4] = attitude::generic::exp(&v).as_ref().coords.into();
        let [x, y, z, w] = q.map(f64::from);
        ours = worse(
            ours,
            exponential_error(
                v.map(f64::from).into(),
                [w, x, y, z],
                f64::from(f32::MIN_POSITIVE),
            ),
        );
    }
    records.push(Record::alone("θ = 0, 1e-42 to 3, f32").ours(ours, 4.0 * ULP32));
    records
}

/// The angle of a quaternion, `2 atan2(|v|, |w|)`.
fn exact_angle(q: &Quaternion<f64>) -> Real {
    real(2.0) * norm([q.i, q.j, q.k]).atan2(&real(q.w.abs()))
}

/// The quaternion next to `exp(v)`.
fn exact_exponential(v: &Vector3<f64>) -> Quaternion<f64> {
    let angle = norm((*v).into());
    let half = &angle / real(2.0);
    let ratio = half.sin() / &angle;
    let imaginary = v.map(|x| (real(x) * &ratio).to_f64().value());
    Quaternion::from_parts(half.cos().to_f64().value(), imaginary)
}

pub fn logarithms() -> Vec<Record> {
    let ranges: [(&str, &[f64], f64); 4] = [
        (
            "θ = 1e-300 to 1e-8",
            &[1e-300, 1e-160, 1e-12, 1e-10, 1e-8],
            0.9,
        ),
        ("θ = 1e-7 to 1e-4", &[1e-7, 1e-6, 1e-5, 1e-4], 1e-3),
        ("θ = 1e-3 to 3", &[1e-3, 1e-2, 0.1, 0.5, 1.0, 2.0, 3.0], 0.0),
        (
            "θ = π - 1e-1 to π - 1e-12",
            &[PI - 1e-1, PI - 1e-4, PI - 1e-8, PI - 1e-12],
            0.0,
        ),
    ];
    let mut records = Vec::new();
    for (case, angles, by) in ranges {
        let (mut plain, mut ours) = (0.0, 0.0);
        for angle in angles {
            let q = exact_exponential(&along(*angle));
            let expected = exact_angle(&q);
            plain = worse(plain, error(2.0 * q.w.acos(), &expected, 0.0));
            let [rotation, opposite] =
                [q, -q].map(|q| attitude::log(&UnitQuaternion::new_unchecked(q)));
            assert_eq!(rotation, opposite, "q and -q are one attitude");
            let computed = norm(rotation.into());
            let off = (&computed - &expected) / &expected;
            ours = worse(ours, off.to_f64().value().abs());
        }
        let record = if by == 0.0 {
            Record::holds(case, plain)
        } else {
            Record::fails(case, plain, by)
        };
        records.push(record.ours(ours, 4.0 * ULP));
    }
    records
}
