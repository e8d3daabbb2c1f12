//! The conditions on an inertia tensor, and the errors if one is violated.

use core::fmt;

use nalgebra::{Matrix3, Vector3};

use super::matrix::{exponent, scaled};
use crate::mechanics::principal::diagonalized;
use crate::numbers::messages::{Number, debug_as_display};

/// [`InertiaTensor::SLACK`](super::InertiaTensor::SLACK)
pub(super) const SLACK: f64 = 4.0 * f64::EPSILON;

const AXES: [&str; 3] = ["x", "y", "z"];
const ENTRIES: [[&str; 3]; 3] = [["xx", "xy", "zx"], ["xy", "yy", "yz"], ["zx", "yz", "zz"]];

/// The first violated condition of an inertia tensor, from the simplest to the most general.
#[derive(Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum InvalidInertia {
    /// An entry is infinite or NaN.
    NotFinite {
        /// Such as `"xy"`.
        entry: &'static str,
    },
    /// Opposite entries differ.
    Asymmetric {
        /// Such as `"xy"`.
        entry: &'static str,
        /// The entry above and the one below the diagonal \[kg m²\].
        values: [f64; 2],
    },
    /// A moment of inertia is negative.
    Negative {
        /// `"x"`, `"y"` or `"z"`.
        axis: &'static str,
        /// The moment about it \[kg m²\].
        moment: f64,
    },
    /// A moment exceeds the sum of the other two.
    Triangle {
        /// `"x"`, `"y"` or `"z"`.
        axis: &'static str,
        /// The moment about it \[kg m²\].
        moment: f64,
        /// The sum of the other two \[kg m²\].
        others: f64,
    },
    /// A product of inertia exceeds half the moment about the third axis.
    Product {
        /// Such as `"xy"`.
        entry: &'static str,
        /// Its magnitude \[kg m²\].
        product: f64,
        /// Half the moment about the third axis \[kg m²\].
        bound: f64,
    },
    /// The largest principal moment exceeds the sum of the other two.
    Principal {
        /// Principal moments, ascending \[kg m²\].
        moments: [f64; 3],
    },
    /// The moment of inertia about some axis is zero, although the body must be able to rotate
    /// about it.
    Singular,
    /// A mass is negative or not finite, or all masses are zero.
    Mass {
        /// The given value \[kg\].
        value: f64,
    },
}

impl fmt::Display for InvalidInertia {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::NotFinite { entry } => write!(f, "entry {entry} is not finite"),
            Self::Asymmetric { entry, values } => {
                let [upper, lower] = values.map(Number);
                write!(
                    f,
                    "not symmetric: entry {entry} is {upper} above the diagonal and {lower} below"
                )
            }
            Self::Negative { axis, moment } => {
                let moment = Number(moment);
                write!(f, "the moment about {axis} is negative: {moment}")
            }
            Self::Triangle {
                axis,
                moment,
                others,
            } => {
                let [moment, others] = [moment, others].map(Number);
                write!(
                    f,
                    "triangle inequality: the moment about {axis} is {moment}, more than the sum {others} of the other two"
                )
            }
            Self::Product {
                entry,
                product,
                bound,
            } => {
                let [product, bound] = [product, bound].map(Number);
                write!(
                    f,
                    "the product {entry} is {product} in magnitude, more than half the moment about the third axis, {bound}"
                )
            }
            Self::Principal { moments } => {
                let [a, b, c] = moments.map(Number);
                write!(
                    f,
                    "triangle inequality in principal axes: of the moments {a}, {b}, {c} the last exceeds the sum of the others"
                )
            }
            Self::Singular => write!(f, "there is no moment about some axis (a rod or a point)"),
            Self::Mass { value } => write!(f, "no body has the mass {} kg", Number(value)),
        }
    }
}

debug_as_display!(InvalidInertia);

impl core::error::Error for InvalidInertia {}

/// Finite and not negative.
pub(super) fn check_mass(value: f64) -> Result<(), InvalidInertia> {
    if value.is_finite() && value >= 0.0 {
        Ok(())
    } else {
        Err(InvalidInertia::Mass { value })
    }
}

/// The possible rounding of a moment, relative to the largest.
pub(super) fn slack(matrix: &Matrix3<f64>) -> f64 {
    slack_of(matrix, f64::EPSILON)
}

/// The same for entries computed with this relative precision.
fn slack_of(matrix: &Matrix3<f64>, epsilon: f64) -> f64 {
    SLACK / f64::EPSILON * epsilon * if is_diagonal(matrix) { 1.0 } else { 4.0 }
}

/// Whether there are no products.
pub(super) fn is_diagonal(matrix: &Matrix3<f64>) -> bool {
    matrix.m12 == 0.0 && matrix.m23 == 0.0 && matrix.m13 == 0.0
}

/// Checks that entries are finite, and that opposite entries are equal to the slack.
pub(super) fn check_symmetry(matrix: &Matrix3<f64>) -> Result<(), InvalidInertia> {
    let tolerance = slack(matrix) * matrix.diagonal().amax();
    for [row, column] in [[0, 1], [1, 2], [0, 2]] {
        let values = [matrix[(row, column)], matrix[(column, row)]];
        let entry = ENTRIES[row][column];
        if !values.iter().all(|value| value.is_finite()) {
            return Err(InvalidInertia::NotFinite { entry });
        }
        if (values[0] - values[1]).abs() > tolerance {
            return Err(InvalidInertia::Asymmetric { entry, values });
        }
    }
    Ok(())
}

/// Checks all conditions on a symmetric matrix.
pub(super) fn check(matrix: &Matrix3<f64>) -> Result<(), InvalidInertia> {
    check_swinging(matrix, f64::EPSILON)
}

/// Checks all conditions on a symmetric matrix of a body that can rotate about every axis, with
/// entries computed with this relative precision.
pub(crate) fn check_turning(matrix: &Matrix3<f64>, epsilon: f64) -> Result<(), InvalidInertia> {
    let moments = check_computed(matrix, epsilon)?;
    if moments.x <= slack_of(matrix, epsilon) * moments.z {
        return Err(InvalidInertia::Singular);
    }
    Ok(())
}

/// The same for a body on a hinge beside its G: a moment may be zero.
pub(crate) fn check_swinging(matrix: &Matrix3<f64>, epsilon: f64) -> Result<(), InvalidInertia> {
    check_computed(matrix, epsilon).map(|_| ())
}

/// The principal moments divided by a power of two, ascending, if all conditions hold.
fn check_computed(matrix: &Matrix3<f64>, epsilon: f64) -> Result<Vector3<f64>, InvalidInertia> {
    for (row, entries) in ENTRIES.iter().enumerate() {
        for (column, entry) in entries.iter().enumerate() {
            if !matrix[(row, column)].is_finite() {
                return Err(InvalidInertia::NotFinite { entry });
            }
        }
    }
    let exponent = exponent(matrix);
    let j = scaled(matrix, -exponent);
    let relative = slack_of(&j, epsilon);
    let slack = relative * j.diagonal().max();
    let restored = |value| libm::scalbn(value, exponent);
    for (a, axis) in AXES.into_iter().enumerate() {
        let moment = j[(a, a)];
        // of a rod along an axis of the body, only rounding may be left
        if moment < -slack {
            let moment = restored(moment);
            return Err(InvalidInertia::Negative { axis, moment });
        }
    }
    for (a, axis) in AXES.into_iter().enumerate() {
        let moment = j[(a, a)];
        let others = j[((a + 1) % 3, (a + 1) % 3)] + j[((a + 2) % 3, (a + 2) % 3)];
        if moment > others + slack {
            let [moment, others] = [moment, others].map(restored);
            return Err(InvalidInertia::Triangle {
                axis,
                moment,
                others,
            });
        }
    }
    for a in 0..3 {
        let [b, c] = [(a + 1) % 3, (a + 2) % 3];
        let [product, bound] = [j[(b, c)].abs(), 0.5 * j[(a, a)]];
        if product > bound + slack {
            let [product, bound] = [product, bound].map(restored);
            let entry = ENTRIES[b][c];
            return Err(InvalidInertia::Product {
                entry,
                product,
                bound,
            });
        }
    }
    let moments = diagonalized(&j).moments;
    if moments.z > moments.x + moments.y + relative * moments.z {
        let moments = moments.map(restored).into();
        return Err(InvalidInertia::Principal { moments });
    }
    Ok(moments)
}
