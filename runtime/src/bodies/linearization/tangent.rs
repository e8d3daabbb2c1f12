//! States and their rates as elements of the tangent space.

use nalgebra::{Quaternion, SVector, UnitQuaternion, Vector3};

use crate::mechanics::attitude;
use crate::state::Coordinates;

/// Corrections of the length of an axis: enough to go from half or twice the length to rounding.
const CORRECTIONS: usize = 8;

/// The state at the end of a displacement x: coordinates are added, attitudes rotated.
pub fn moved<S: Coordinates<Scalar = f64>, const N: usize>(state: &S, x: &SVector<f64, N>) -> S {
    let start = state.coordinates();
    let (mut change, mut end) = (S::Array::default(), start);
    let mut left = x.as_slice();
    let mut first = 0;
    for group in S::GROUPS {
        let to = &mut change.as_mut()[first..first + group];
        let (parts, rest) = left.split_at(to.len().min(3));
        left = rest;
        if let ([_, _, _, _], [x, y, z]) = (&to, parts) {
            let before = quaternion(&start.as_ref()[first..]);
            let after = attitude::generic::turned(&before, &Vector3::new(*x, *y, *z));
            to.copy_from_slice((after.coords - before.coords).as_slice());
        } else {
            to.copy_from_slice(parts);
        }
        first += group;
    }
    for _ in 0..CORRECTIONS {
        S::keep(&start, &mut change);
    }
    for (to, change) in end.as_mut().iter_mut().zip(change.as_ref()) {
        *to += change;
    }
    S::from_coordinates(&end)
}

/// The rate of a state: an attitude changes by its angular velocity.
pub fn rate<S: Coordinates<Scalar = f64>, const N: usize>(
    state: &S,
    acceleration: &S::Acceleration,
) -> SVector<f64, N> {
    let (at, rates) = (state.coordinates(), state.rates(acceleration));
    let half: usize = S::GROUPS[..S::GROUPS.len() / 2].iter().sum();
    let mut x = SVector::<f64, N>::zeros();
    let (mut first, mut place) = (0, 0);
    for group in &S::GROUPS[..S::GROUPS.len() / 2] {
        let size = (*group).min(3);
        let list = if *group == 4 {
            &at.as_ref()[half + place..]
        } else {
            &rates.as_ref()[first..]
        };
        x.as_mut_slice()[place..place + size].copy_from_slice(&list[..size]);
        first += group;
        place += size;
    }
    x.as_mut_slice()[place..].copy_from_slice(&rates.as_ref()[half..]);
    x
}

/// The coordinates of a state, arranged as in the tangent space; in place of an attitude, a vector
/// in world axes, expressed in body axes.
pub fn values<S: Coordinates<Scalar = f64>, const N: usize>(
    state: &S,
    vector: &Vector3<f64>,
) -> SVector<f64, N> {
    let at = state.coordinates();
    let mut x = SVector::<f64, N>::zeros();
    let (mut first, mut place) = (0, 0);
    for group in S::GROUPS {
        let size = (*group).min(3);
        let list = &at.as_ref()[first..];
        let to = &mut x.as_mut_slice()[place..place + size];
        if *group == 4 {
            let turned = quaternion(list).inverse_transform_vector(vector);
            to.copy_from_slice(turned.as_slice());
        } else {
            to.copy_from_slice(&list[..size]);
        }
        first += group;
        place += size;
    }
    x
}

fn quaternion(list: &[f64]) -> UnitQuaternion<f64> {
    UnitQuaternion::new_unchecked(Quaternion::new(list[3], list[0], list[1], list[2]))
}
