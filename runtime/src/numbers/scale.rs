//! Powers of two, by which numbers are scaled without rounding, and vectors of any size.

use nalgebra::Vector3;

use crate::numbers::twofold::Twofold;

/// The power of two next below a positive number; 0 for zero and for non-finite numbers.
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

/// Length and direction of a vector, at any scale; the length in twice the precision.
pub(crate) fn direction(vector: &Vector3<f64>) -> (Twofold, Vector3<f64>) {
    let exponent = exponent(vector.amax());
    let scaled = scaled(vector, -exponent);
    let square = |component: f64| Twofold::product(component, component);
    let length = (square(scaled.x) + square(scaled.y) + square(scaled.z)).sqrt();
    let direction = if length.value() == 0.0 {
        scaled
    } else {
        scaled / length.value()
    };
    (length.scaled(exponent), direction)
}
