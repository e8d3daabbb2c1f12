//! Vectors and matrices of 106 bits.

use crate::wide::Wide;

pub type Vec3 = [Wide; 3];
pub type Mat3 = [[Wide; 3]; 3];

pub const ZERO: Vec3 = [Wide::ZERO; 3];
pub const NONE: Mat3 = [ZERO; 3];

pub fn identity() -> Mat3 {
    diagonal([Wide::ONE; 3])
}

pub fn diagonal(entries: Vec3) -> Mat3 {
    let mut matrix = NONE;
    for (axis, entry) in entries.into_iter().enumerate() {
        matrix[axis][axis] = entry;
    }
    matrix
}

pub fn add(a: Vec3, b: Vec3) -> Vec3 {
    [0, 1, 2].map(|i| a[i] + b[i])
}

pub fn subtract(a: Vec3, b: Vec3) -> Vec3 {
    [0, 1, 2].map(|i| a[i] - b[i])
}

pub fn scale(a: Vec3, by: Wide) -> Vec3 {
    a.map(|part| part * by)
}

pub fn dot(a: Vec3, b: Vec3) -> Wide {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub fn cross(a: Vec3, b: Vec3) -> Vec3 {
    [(1, 2), (2, 0), (0, 1)].map(|(i, j)| a[i] * b[j] - a[j] * b[i])
}

pub fn unit(a: Vec3) -> Vec3 {
    scale(a, Wide::ONE / dot(a, a).sqrt())
}

pub fn size(a: Vec3) -> f64 {
    a.iter().fold(0.0, |size, part| part.high.abs().max(size))
}

pub fn apply(m: &Mat3, v: Vec3) -> Vec3 {
    m.map(|row| dot(row, v))
}

pub fn product(a: &Mat3, b: &Mat3) -> Mat3 {
    let columns = transposed(b);
    a.map(|row| columns.map(|column| dot(row, column)))
}

pub fn transposed(m: &Mat3) -> Mat3 {
    [0, 1, 2].map(|i| [0, 1, 2].map(|j| m[j][i]))
}

pub fn sum(a: &Mat3, b: &Mat3) -> Mat3 {
    [0, 1, 2].map(|i| add(a[i], b[i]))
}

pub fn times(m: &Mat3, by: Wide) -> Mat3 {
    m.map(|row| scale(row, by))
}

/// The matrix of `w x`.
pub fn crossing([x, y, z]: Vec3) -> Mat3 {
    let zero = Wide::ZERO;
    [[zero, -z, y], [z, zero, -x], [-y, x, zero]]
}
