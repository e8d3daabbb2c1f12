//! Matrices of inertia tensors.

use nalgebra::Matrix3;

use crate::numbers::scale;

/// The power of two next below the largest entry, so that scaling by it is exact.
pub(super) fn exponent(matrix: &Matrix3<f64>) -> i32 {
    scale::exponent(matrix.amax())
}

/// The matrix times a power of two.
pub(super) fn scaled(matrix: &Matrix3<f64>, exponent: i32) -> Matrix3<f64> {
    matrix.map(|entry| libm::scalbn(entry, exponent))
}

/// The mean of a matrix and its transpose.
pub(super) fn symmetrized(matrix: &Matrix3<f64>) -> Matrix3<f64> {
    (matrix + matrix.transpose()) * 0.5
}

/// The inertia tensor tr(S) 1 - S of second moments S = ∫ r rᵀ dm, sums without cancellation.
pub(super) fn of_second_moments(second: &Matrix3<f64>) -> Matrix3<f64> {
    let s = second;
    Matrix3::new(
        s.m22 + s.m33,
        -s.m12,
        -s.m13,
        -s.m12,
        s.m33 + s.m11,
        -s.m23,
        -s.m13,
        -s.m23,
        s.m11 + s.m22,
    )
}
