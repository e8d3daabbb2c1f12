//! How large a change of a state is, and how errors are measured.

use crate::state::Coordinates;

/// The size of a change of coordinates: of position, attitude, velocity, angular velocity each the largest component, relative to the largest
/// component of the quantity itself where that is above 1, absolute (m, rad, m/s, rad/s) below; and of these the largest. Of what is not a number,
/// not a number.
#[inline(always)]
pub(super) fn relative_size<S: Coordinates<Scalar = f64>>(
    change: &S::Array,
    coordinates: &S::Array,
) -> f64 {
    let mut first = 0;
    let groups = S::GROUPS.iter().map(|count| {
        let group = first..first + count;
        first += count;
        let size = |list: &S::Array| largest(list.as_ref()[group.clone()].iter().map(|x| x.abs()));
        size(change) / size(coordinates).max(1.0)
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
