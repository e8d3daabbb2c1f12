//! How large a change of a state is, and which step that permits.

use crate::state::Coordinates;

use super::exact;

/// The size of a change of coordinates: of position, attitude, velocity, angular velocity each the largest component, relative to the largest
/// component of the quantity itself where that is above 1, absolute (m, rad, m/s, rad/s) below; and of these the largest. Of what is not a number,
/// not a number.
#[inline(always)]
pub(super) fn relative_size<S: Coordinates<Scalar = f64>>(
    change: &S::Array,
    coordinates: &S::Array,
) -> f64 {
    let (mut changes, mut wholes) = (change.as_ref().iter(), coordinates.as_ref().iter());
    let groups = S::GROUPS.iter().map(|count| {
        let size = largest(changes.by_ref().take(*count).map(|x| x.abs()));
        let whole = largest(wholes.by_ref().take(*count).map(|x| x.abs()));
        size / whole.max(1.0)
    });
    largest(groups)
}

#[inline(always)]
fn largest(sizes: impl Iterator<Item = f64>) -> f64 {
    sizes.fold(
        0.0,
        |largest, size| if largest >= size { largest } else { size },
    )
}

/// A tolerance, of what is finer than rounding the finest that there is; what is no tolerance is zero, which no step keeps.
pub(super) fn finest(tolerance: f64) -> f64 {
    if tolerance > 0.0 {
        tolerance.max(1e-18)
    } else {
        0.0
    }
}

/// `x^(1/k)` to a few parts in a hundred, which is all that a step needs: logarithm and power by the exponent of the double, and
/// straight lines in between. Of what is not a number, not a number.
#[inline(always)]
pub(super) fn root(x: f64, k: usize) -> f64 {
    const ONE: f64 = 4_503_599_627_370_496.0; // 2⁵²
    if !(x > 0.0 && x.is_finite()) {
        return x;
    }
    #[expect(clippy::cast_precision_loss, reason = "a few digits are enough")]
    let logarithm = x.to_bits() as f64 / ONE - 1023.0;
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "in the range of exponents"
    )]
    let bits = ((logarithm / exact(k) + 1023.0) * ONE) as u64;
    f64::from_bits(bits)
}
