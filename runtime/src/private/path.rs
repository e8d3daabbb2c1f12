//! Closed forms, constructed from the numbers of a description.

use nalgebra::{Matrix3, Unit, UnitQuaternion};

use crate::exact::{AxialTorque, FreeRotation, Gyrostat, LagrangeTop};
use crate::mechanics::inertia::InertiaTensor;
use crate::mechanics::principal::PrincipalAxes;
use crate::state::Rotation;

/// From a tensor that the constructor has checked: its entries xx, yy, zz, xy, yz, zx. Principal
/// axes are kept, in any order.
#[must_use]
pub fn principal_axes(entries: [f64; 6]) -> PrincipalAxes {
    let inertia = InertiaTensor::checked(entries);
    if inertia.off_diagonals().iter().all(|entry| *entry == 0.0) {
        return PrincipalAxes {
            moments: inertia.moments().into(),
            axes: UnitQuaternion::identity(),
        };
    }
    inertia.principal_axes()
}

/// From a body with these principal axes.
#[must_use]
pub fn rotation_about(principal: &PrincipalAxes, state: &Rotation) -> FreeRotation {
    let axes = principal.axes.to_rotation_matrix().into_inner();
    FreeRotation::principal(principal.moments.into(), &axes, state)
}

/// From the moments across an axis and along it, and its unit vector.
#[must_use]
pub fn symmetric_rotation(moments: [f64; 2], axis: [f64; 3], state: &Rotation) -> FreeRotation {
    FreeRotation::symmetric(moments, Unit::new_unchecked(axis.into()), state)
}

/// From principal moments along the axes of the body.
#[must_use]
pub fn rotation_along(moments: [f64; 3], state: &Rotation) -> FreeRotation {
    FreeRotation::principal(moments, &Matrix3::identity(), state)
}

/// From principal moments and the unit vectors of their axes.
#[must_use]
pub fn principal_rotation(
    moments: [f64; 3],
    axes: [[f64; 3]; 3],
    state: &Rotation,
) -> FreeRotation {
    FreeRotation::principal(moments, &Matrix3::from(axes), state)
}

/// From the moments across an axis and about it, its unit vector, and the couple per unit of its
/// arm, world axes.
#[must_use]
pub fn lagrange_top(
    moments: [f64; 2],
    axis: [f64; 3],
    couple: [f64; 3],
    state: &Rotation,
) -> LagrangeTop {
    LagrangeTop::new(
        moments,
        Unit::new_unchecked(axis.into()),
        couple.into(),
        state,
    )
}

/// From the unit vector of the axis, the rate of the rotation about it with its own rate, and the
/// acceleration along it.
#[must_use]
pub fn gyrostat(axis: [f64; 3], spin: [f64; 2], acceleration: f64, state: &Rotation) -> Gyrostat {
    Gyrostat::new(Unit::new_unchecked(axis.into()), spin, acceleration, state)
}

/// From the moments of inertia across an axis and about it, its unit vector, and the moment along
/// it.
#[must_use]
pub fn axial_torque(
    moments: [f64; 2],
    axis: [f64; 3],
    torque: f64,
    state: &Rotation,
) -> AxialTorque {
    AxialTorque::new(moments, Unit::new_unchecked(axis.into()), torque, state)
}
