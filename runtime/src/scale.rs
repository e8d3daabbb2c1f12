//! Powers of two, by which numbers are scaled without rounding.

use nalgebra::Vector3;

/// The power of two next below a positive number; 0 for zero and for what is not finite.
pub(crate) fn exponent(largest: f64) -> i32 {
    if largest > 0.0 && largest.is_finite() {
        libm::ilogb(largest)
    } else {
        0
    }
}

/// A vector times a power of two.
pub(crate) fn scaled(vector: &Vector3<f64>, exponent: i32) -> Vector3<f64> {
    vector.map(|component| libm::scalbn(component, exponent))
}
