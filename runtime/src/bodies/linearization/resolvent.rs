//! How far a matrix is from one with a given eigenvalue.

use nalgebra::{Complex, SMatrix, SVector};

/// The smallest singular value of `A - z`, for the first `size` rows and columns of A: the size of
/// the least change of A after which z is an eigenvalue (L. N. Trefethen and M. Embree, Spectra and
/// Pseudospectra, 2). The result is an upper estimate, by inverse iteration.
pub fn distance<const N: usize>(matrix: &SMatrix<f64, N, N>, size: usize, z: Complex<f64>) -> f64 {
    let shifted = SMatrix::<Complex<f64>, N, N>::from_fn(|row, column| {
        let entry = Complex::new(matrix[(row, column)], 0.0);
        if row == column { entry - z } else { entry }
    });
    let Some(factors) = Factors::of(shifted, size) else {
        return 0.0;
    };
    // no symmetry of a motion has these proportions
    let mut angle = 1.0;
    let mut x = SVector::from_fn(|row, _| {
        angle += 1.618;
        let part = if row < size { libm::sin(angle) } else { 0.0 };
        Complex::new(part, 0.0)
    });
    let mut distance = f64::INFINITY;
    for _ in 0..ITERATIONS {
        x /= Complex::new(norm(&x), 0.0);
        let y = factors.solved(x);
        distance = distance.min(1.0 / norm(&y));
        x = factors.solved_adjoint(y);
    }
    distance
}

/// Inverse iterations: each reduces the other directions by the square of the ratio of two singular
/// values.
const ITERATIONS: usize = 3;

/// `P A = L U`, by elimination with row exchanges.
struct Factors<const N: usize> {
    /// U on and above the diagonal, and L, whose diagonal is one, below it.
    both: SMatrix<Complex<f64>, N, N>,
    /// The row that each row was exchanged with.
    exchanges: [usize; N],
    size: usize,
}

impl<const N: usize> Factors<N> {
    /// `None` if a pivot is zero.
    fn of(mut both: SMatrix<Complex<f64>, N, N>, size: usize) -> Option<Self> {
        let mut exchanges = [0; N];
        for pivot in 0..size {
            let square = |row: &usize| both[(*row, pivot)].norm_sqr();
            let largest = (pivot..size).max_by(|a, b| square(a).total_cmp(&square(b)))?;
            both.swap_rows(pivot, largest);
            exchanges[pivot] = largest;
            let divisor = both[(pivot, pivot)];
            if divisor.norm_sqr() == 0.0 {
                return None;
            }
            for row in pivot + 1..size {
                let factor = both[(row, pivot)] / divisor;
                both[(row, pivot)] = factor;
                for column in pivot + 1..size {
                    let part = factor * both[(pivot, column)];
                    both[(row, column)] -= part;
                }
            }
        }
        Some(Self {
            both,
            exchanges,
            size,
        })
    }

    /// `A⁻¹ x`
    fn solved(&self, mut x: SVector<Complex<f64>, N>) -> SVector<Complex<f64>, N> {
        for row in 0..self.size {
            x.swap_rows(row, self.exchanges[row]);
        }
        for row in 0..self.size {
            for column in 0..row {
                let part = self.both[(row, column)] * x[column];
                x[row] -= part;
            }
        }
        for row in (0..self.size).rev() {
            for column in row + 1..self.size {
                let part = self.both[(row, column)] * x[column];
                x[row] -= part;
            }
            x[row] /= self.both[(row, row)];
        }
        x
    }

    /// The same with the conjugate transpose of A.
    fn solved_adjoint(&self, mut x: SVector<Complex<f64>, N>) -> SVector<Complex<f64>, N> {
        for row in 0..self.size {
            for column in 0..row {
                let part = self.both[(column, row)].conj() * x[column];
                x[row] -= part;
            }
            x[row] /= self.both[(row, row)].conj();
        }
        for row in (0..self.size).rev() {
            for column in row + 1..self.size {
                let part = self.both[(column, row)].conj() * x[column];
                x[row] -= part;
            }
        }
        for row in (0..self.size).rev() {
            x.swap_rows(row, self.exchanges[row]);
        }
        x
    }
}

fn norm<const N: usize>(x: &SVector<Complex<f64>, N>) -> f64 {
    libm::sqrt(x.iter().map(Complex::norm_sqr).sum())
}
