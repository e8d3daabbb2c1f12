//! Closed forms from the numbers of a description.

use nalgebra::{Matrix3, Unit};

use crate::exact::FreeRotation;
use crate::inertia::InertiaTensor;
use crate::state::Rotation;

/// Of a tensor that the constructor has checked: its entries xx, yy, zz, xy, yz, zx.
#[must_use]
pub fn free_rotation(entries: [f64; 6], state: &Rotation) -> FreeRotation {
    FreeRotation::new(&InertiaTensor::checked(entries), state)
}

/// Of the moments across an axis and along it, and its unit vector.
#[must_use]
pub fn symmetric_rotation(moments: [f64; 2], axis: [f64; 3], state: &Rotation) -> FreeRotation {
    FreeRotation::symmetric(moments, Unit::new_unchecked(axis.into()), state)
}

/// Of principal moments and the unit vectors of their axes.
#[must_use]
pub fn principal_rotation(
    moments: [f64; 3],
    axes: [[f64; 3]; 3],
    state: &Rotation,
) -> FreeRotation {
    FreeRotation::principal(moments, &Matrix3::from(axes), state)
}
