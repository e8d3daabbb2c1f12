//! Matrices in coordinates in which their rows and columns have similar sizes.

use nalgebra::linalg::balancing::balance_parlett_reinsch;
use nalgebra::{Const, SMatrix, SVector};

/// `scale D⁻¹ A D`, where D is diagonal, and both have powers of two only, so that nothing is
/// rounded (B. Parlett and C. Reinsch, Balancing a matrix for calculation of eigenvalues and
/// eigenvectors).
pub struct Balanced<const N: usize> {
    /// `D⁻¹ A D`, divided by the scale.
    pub matrix: SMatrix<f64, N, N>,
    /// The diagonal of D.
    pub diagonal: SVector<f64, N>,
    /// The size of the largest entry of A.
    pub scale: f64,
}

impl<const N: usize> Balanced<N> {
    /// `None` if the matrix is not finite.
    pub fn of(matrix: &SMatrix<f64, N, N>) -> Option<Self> {
        if !matrix.iter().all(|entry| entry.is_finite()) {
            return None;
        }
        let largest = matrix.amax().max(f64::MIN_POSITIVE);
        let scale = libm::exp2(f64::from(libm::ilogb(largest)));
        let mut matrix = matrix / scale;
        let diagonal = balance_parlett_reinsch::<f64, Const<N>>(&mut matrix);
        Some(Self {
            matrix,
            diagonal,
            scale,
        })
    }
}
