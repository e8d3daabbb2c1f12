//! Orthogonalization of vectors by rotations: singular values, by the one-sided method of Jacobi
//! (M. Hestenes, Inversion of matrices by biorthogonalization), which is accurate for small ones
//! as well as large ones.

/// A vector that can be rotated into another.
pub trait Turning: Copy {
    /// The scalar product.
    fn dot(&self, other: &Self) -> f64;

    /// `cosine * self + sine * other`
    #[must_use]
    fn sum(&self, cosine: f64, other: &Self, sine: f64) -> Self;
}

/// Sweeps through all pairs; ten do for a hundred vectors.
const SWEEPS: usize = 60;

/// Rotates vectors until each is orthogonal to all others, to rounding.
pub fn orthogonalize<T: Turning>(vectors: &mut [T]) {
    for _ in 0..SWEEPS {
        let mut is_done = true;
        for first in 0..vectors.len() {
            for second in first + 1..vectors.len() {
                let (a, b) = (vectors[first], vectors[second]);
                let (p, q, both) = (a.dot(&a), b.dot(&b), a.dot(&b));
                let product = libm::sqrt(p) * libm::sqrt(q);
                if both.abs() <= f64::EPSILON * product || !both.is_finite() {
                    continue;
                }
                is_done = false;
                let ratio = (q - p) / (2.0 * both);
                let tangent = libm::copysign(1.0, ratio) / (ratio.abs() + libm::hypot(1.0, ratio));
                let cosine = 1.0 / libm::hypot(1.0, tangent);
                let sine = tangent * cosine;
                vectors[first] = a.sum(cosine, &b, -sine);
                vectors[second] = b.sum(cosine, &a, sine);
            }
        }
        if is_done {
            return;
        }
    }
}
