//! Counts as numbers.

/// A count as a number: exact below 2⁵³.
#[expect(clippy::cast_precision_loss, reason = "exact below 2⁵³")]
pub(crate) fn real(count: usize) -> f64 {
    count as f64
}

/// The same in single precision: exact below 2²⁴.
#[expect(clippy::cast_precision_loss, reason = "exact below 2²⁴")]
pub(crate) fn single(count: usize) -> f32 {
    count as f32
}
