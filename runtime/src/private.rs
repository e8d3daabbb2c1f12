//! All that generated code may name. Not for users: no promise of stability.

pub use nalgebra::{UnitQuaternion, Vector2, Vector3};
pub use newton_euler_macros::rigid_body;

pub use crate::body::{
    Balance, Energy, InvalidBody, Inverse, Momentum, Reactions, RigidBody, Singular,
};
pub use crate::constrained::{Constrained, Inconsistent, Violation};
pub use crate::inertia::InertiaTensor;
pub use crate::load::{Family, Load, PlanarLoad};
pub use crate::operations::{Operations, Stage};
pub use crate::state::{
    Hinge, Planar, PlanarAcceleration, PlanarTranslation, Rod, RodAcceleration, Rotation, Spatial,
    SpatialAcceleration, State, Translation,
};
pub use crate::wrench::{PlanarWrench, Wrench};

pub mod math;
mod projection;

pub use projection::{Row, project};

/// Every parameter by its name: all must be finite.
///
/// # Errors
/// [`InvalidBody::NotFinite`] with the first that is not.
pub fn check_finite(params: &[(&'static str, f64)]) -> Result<(), InvalidBody> {
    match params.iter().find(|(_, value)| !value.is_finite()) {
        Some(&(name, value)) => Err(InvalidBody::NotFinite { name, value }),
        None => Ok(()),
    }
}

/// The mass \[kg\]: finite and positive.
///
/// # Errors
/// [`InvalidBody::Mass`].
pub fn check_mass(value: f64) -> Result<(), InvalidBody> {
    if value.is_finite() && value > 0.0 {
        Ok(())
    } else {
        Err(InvalidBody::Mass { value })
    }
}

/// The moment of inertia of a planar body, or of a rod \[kg m²\]: finite and positive.
///
/// # Errors
/// [`InvalidBody::PlanarInertia`].
pub fn check_planar_inertia(value: f64) -> Result<(), InvalidBody> {
    if value.is_finite() && value > 0.0 {
        Ok(())
    } else {
        Err(InvalidBody::PlanarInertia { value })
    }
}

/// The entries xx, yy, zz, xy, yz, zx of an inertia tensor \[kg m²\]: that of a possible body, and invertible.
///
/// # Errors
/// [`InvalidBody::Inertia`] with the violated condition.
pub fn check_inertia([xx, yy, zz, xy, yz, zx]: [f64; 6]) -> Result<(), InvalidBody> {
    InertiaTensor::tensor(xx, yy, zz, xy, yz, zx)?.inverse()?;
    Ok(())
}

/// The reciprocal of the divisor of an unknown, where it depends on the configuration, given the largest of the terms it was
/// summed from.
///
/// # Errors
/// [`Singular`] if it is zero to [`Singular::TOLERANCE`] of that term, or not a number.
#[inline]
pub fn reciprocal(unknown: &'static str, value: f64, scale: f64) -> Result<f64, Singular> {
    if value.abs() > Singular::TOLERANCE * scale {
        Ok(value.recip())
    } else {
        Err(Singular {
            unknown,
            value,
            scale,
        })
    }
}
