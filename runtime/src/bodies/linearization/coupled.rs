//! The parts of a linear motion that do not have an effect on each other and back.

use nalgebra::SMatrix;

/// For each coordinate, the first one of its part. Two coordinates are in one part if each has an
/// effect on the other, perhaps by way of others. The eigenvalues of a matrix are those of its parts
/// (the diagonal blocks of its block triangular form).
pub fn coupled<const N: usize>(matrix: &SMatrix<f64, N, N>, size: usize) -> [usize; N] {
    let mut affects = matrix.map(|entry| entry != 0.0);
    for by in 0..size {
        for to in 0..size {
            if affects[(to, by)] {
                for from in 0..size {
                    affects[(to, from)] |= affects[(by, from)];
                }
            }
        }
    }
    core::array::from_fn(|one| {
        let is_with = |other: &usize| affects[(one, *other)] && affects[(*other, one)];
        (0..one).find(is_with).unwrap_or(one)
    })
}

/// The rows and columns of some coordinates, and their number.
pub fn part<const N: usize>(
    matrix: &SMatrix<f64, N, N>,
    is_in: impl Fn(usize) -> bool,
) -> (SMatrix<f64, N, N>, usize) {
    let members = || (0..N).filter(|number| is_in(*number));
    let mut part = SMatrix::zeros();
    for (to, row) in members().enumerate() {
        for (by, column) in members().enumerate() {
            part[(to, by)] = matrix[(row, column)];
        }
    }
    (part, members().count())
}
