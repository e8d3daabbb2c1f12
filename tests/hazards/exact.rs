//! Exact rationals and numbers of 400 bits, and the errors of doubles compared with them.

use dashu_float::{FBig, round::mode::HalfEven};
use dashu_ratio::RBig;
use nalgebra::Vector3;

/// Units in the last place of one.
pub const ULP: f64 = f64::EPSILON;
/// The same in single precision.
pub const ULP32: f64 = f32::EPSILON as f64;

const BITS: usize = 400;

pub type Real = FBig<HalfEven, 2>;
pub type Exact = [RBig; 3];
/// By rows.
pub type Tensor = [Exact; 3];

/// The value of a double.
pub fn rational(x: f64) -> RBig {
    RBig::try_from(x).expect("a finite number")
}

/// The value of a decimal.
pub fn decimal(digits: &str) -> RBig {
    let (mantissa, exponent) = digits.split_once('e').unwrap_or((digits, "0"));
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let integer: RBig = format!("{whole}{fraction}").parse().expect("digits");
    let places = isize::try_from(fraction.len()).expect("a few places");
    let exponent: isize = exponent.parse().expect("an exponent");
    integer * RBig::from(10).pow(exponent - places)
}

/// The value of a double, to be computed with.
pub fn real(x: f64) -> Real {
    Real::try_from(x)
        .expect("a finite number")
        .with_precision(BITS)
        .value()
}

pub fn vector(v: &Vector3<f64>) -> Exact {
    [v.x, v.y, v.z].map(rational)
}

pub fn nearest(x: &RBig) -> f64 {
    x.to_f64().value()
}

pub fn rounded(v: &Exact) -> Vector3<f64> {
    Vector3::from(v.each_ref().map(nearest))
}

pub fn dot(a: &Exact, b: &Exact) -> RBig {
    &a[0] * &b[0] + &a[1] * &b[1] + &a[2] * &b[2]
}

pub fn cross(a: &Exact, b: &Exact) -> Exact {
    [(1, 2), (2, 0), (0, 1)].map(|(i, k)| &a[i] * &b[k] - &a[k] * &b[i])
}

pub fn times(j: &Tensor, a: &Exact) -> Exact {
    j.each_ref().map(|row| dot(row, a))
}

/// `J x = right`, by cofactors.
pub fn solved(j: &Tensor, right: &Exact) -> Exact {
    let cofactors = [
        cross(&j[1], &j[2]),
        cross(&j[2], &j[0]),
        cross(&j[0], &j[1]),
    ];
    let determinant = dot(&j[0], &cofactors[0]);
    times(&cofactors, right).map(|component| component / &determinant)
}

/// Of a symmetric tensor.
pub fn symmetric([xx, yy, zz, xy, yz, zx]: [RBig; 6]) -> Tensor {
    [
        [xx, xy.clone(), zx.clone()],
        [xy, yy, yz.clone()],
        [zx, yz, zz],
    ]
}

/// Mass, center of mass and tensor about it of mass points.
pub fn of_points(points: &[(f64, Vector3<f64>)]) -> (RBig, Exact, Tensor) {
    let points: Vec<(RBig, Exact)> = points
        .iter()
        .map(|(m, at)| (rational(*m), vector(at)))
        .collect();
    let sum = |term: &dyn Fn(&RBig, &Exact) -> RBig| {
        points
            .iter()
            .fold(RBig::ZERO, |sum, (m, at)| sum + term(m, at))
    };
    let mass = sum(&|m, _| m.clone());
    let center = [0, 1, 2].map(|axis| sum(&|m, at| m * &at[axis]) / &mass);
    let second =
        |i: usize, k: usize| sum(&|m, at| m * (&at[i] - &center[i]) * (&at[k] - &center[k]));
    let [x, y, z] = [second(0, 0), second(1, 1), second(2, 2)];
    let off = [(0, 1), (1, 2), (2, 0)].map(|(i, k)| -second(i, k));
    let [xy, yz, zx] = off;
    let tensor = symmetric([&y + &z, &z + &x, &x + &y, xy, yz, zx]);
    (mass, center, tensor)
}

/// The relative error of a double; of what is not finite, NaN.
pub fn relative(computed: f64, exact: &RBig) -> f64 {
    if !computed.is_finite() {
        return f64::NAN;
    }
    let error = rational(computed) - exact;
    nearest(&(error / exact)).abs()
}

/// The largest error of a component over the largest component.
pub fn off(computed: &Vector3<f64>, exact: &Exact) -> f64 {
    if computed.iter().any(|component| !component.is_finite()) {
        return f64::NAN;
    }
    let errors = computed
        .iter()
        .zip(exact)
        .map(|(computed, exact)| nearest(&(rational(*computed) - exact)).abs());
    errors.fold(0.0, f64::max) / rounded(exact).amax()
}

/// The relative error of a double; of what is not finite, NaN.
pub fn relative_to(computed: f64, exact: &Real) -> f64 {
    if !computed.is_finite() {
        return f64::NAN;
    }
    let error = (real(computed) - exact) / exact;
    error.to_f64().value().abs()
}

/// To single precision.
#[expect(clippy::cast_possible_truncation, reason = "what is to be done")]
pub fn to_f32(x: f64) -> f32 {
    x as f32
}

/// The larger of two errors; NaN, if one is.
pub fn worse(a: f64, b: f64) -> f64 {
    if a.is_nan() || a > b { a } else { b }
}
