//! All that generated code may name. Not for users: no promise of stability.

use nalgebra::Matrix3;
pub use nalgebra::{UnitQuaternion, Vector2, Vector3};
pub use newton_euler_macros::rigid_body;

pub use crate::body::{
    Balance, Energy, Flow, InvalidBody, Inverse, Momentum, Reactions, RigidBody, Singular,
};
pub use crate::columns::{Columns, Generic, Sink, Source};
pub use crate::constrained::{Constrained, Inconsistent, Violation};
pub use crate::exact::{
    AxialTorque, Flight, FreeRotation, GreatCircle, LagrangeTop, Parabola, Path, Pendulum,
};
use crate::inertia::check_turning;
pub use crate::integrate::{
    ClosedForm, DormandPrince, Integrate, Projected, Switches, TaylorSeries,
};
pub use crate::load::{Family, Load, PlanarLoad};
pub use crate::operations::{Operations, Stage};
pub use crate::scalar::Scalar;
pub use crate::state::{
    Hinge, Planar, PlanarAcceleration, PlanarTranslation, Rod, RodAcceleration, Rotation, Spatial,
    SpatialAcceleration, State, Translation,
};
pub use crate::structure::{Dependence, Structure, Structured, Symmetry};
pub use crate::taylor::{Arithmetic, Axes, Products, Series, Taylor};
pub use crate::wrench::{PlanarWrench, Wrench};

pub mod math;

/// The types that hold numbers, over any scalar.
pub mod generic {
    pub use crate::load::generic::*;
    pub use crate::state::generic::*;
    pub use crate::wrench::generic::*;
}

mod path;
mod projection;

pub use crate::principal::PrincipalAxes;
pub use path::{
    axial_torque, lagrange_top, principal_axes, principal_rotation, rotation_about, rotation_along,
    symmetric_rotation,
};
pub use projection::{Row, Size, check, project};

/// Every parameter by its name: all must be finite.
///
/// # Errors
/// [`InvalidBody::NotFinite`] with the first that is not.
pub fn check_finite<T: Scalar>(params: &[(&'static str, T)]) -> Result<(), InvalidBody> {
    for &(name, value) in params {
        if let Some(value) = find(value, |value| !value.is_finite()) {
            return Err(InvalidBody::NotFinite { name, value });
        }
    }
    Ok(())
}

/// The mass \[kg\]: finite and positive.
///
/// # Errors
/// [`InvalidBody::Mass`].
pub fn check_mass<T: Scalar>(value: T) -> Result<(), InvalidBody> {
    match find(value, |value| !is_positive(value)) {
        Some(value) => Err(InvalidBody::Mass { value }),
        None => Ok(()),
    }
}

/// The moment of inertia of a planar body, or of a rod \[kg m²\]: finite and positive.
///
/// # Errors
/// [`InvalidBody::PlanarInertia`].
pub fn check_planar_inertia<T: Scalar>(value: T) -> Result<(), InvalidBody> {
    match find(value, |value| !is_positive(value)) {
        Some(value) => Err(InvalidBody::PlanarInertia { value }),
        None => Ok(()),
    }
}

/// The entries xx, yy, zz, xy, yz, zx of an inertia tensor \[kg m²\]: that of a possible body, and invertible.
///
/// # Errors
/// [`InvalidBody::Inertia`] with the violated condition.
pub fn check_inertia<T: Scalar>(entries: [T; 6]) -> Result<(), InvalidBody> {
    for lane in 0..T::LANES {
        let [xx, yy, zz, xy, yz, zx] = entries.map(|entry| entry.lane(lane));
        let matrix = Matrix3::new(xx, xy, zx, xy, yy, yz, zx, yz, zz);
        check_turning(&matrix, T::EPSILON)?;
    }
    Ok(())
}

/// The first of the numbers of a scalar that is such.
fn find<T: Scalar>(scalar: T, is_such: impl Fn(f64) -> bool) -> Option<f64> {
    (0..T::LANES)
        .map(|lane| scalar.lane(lane))
        .find(|value| is_such(*value))
}

fn is_positive(value: f64) -> bool {
    value.is_finite() && value > 0.0
}

/// The first of these loads of which a component is infinite or not a number.
#[must_use]
pub fn lost_load<T: Scalar>(loads: &[(&'static str, &[T])]) -> Option<&'static str> {
    let is_lost = |part: &T| find(*part, |value| !value.is_finite()).is_some();
    let lost = loads.iter().find(|(_, parts)| parts.iter().any(is_lost));
    lost.map(|(name, _)| *name)
}

/// The reciprocal of the divisor of an unknown, where it depends on the configuration, given the largest of the terms it was
/// summed from.
///
/// # Errors
/// [`Singular`] if it is zero to [`Singular::TOLERANCE`] of that term in units of the scalar's precision, or not a number.
#[inline(always)]
pub fn reciprocal<T: Scalar>(unknown: &'static str, divisor: T, scale: T) -> Result<T, Singular> {
    let tolerance = Singular::TOLERANCE / f64::EPSILON * T::EPSILON;
    for lane in 0..T::LANES {
        let (value, scale) = (divisor.lane(lane), scale.lane(lane));
        let is_determined = value.abs() > tolerance * scale;
        if !is_determined {
            return Err(Singular {
                unknown,
                value,
                scale,
            });
        }
    }
    Ok(divisor.constant(1.0, 1.0) / divisor)
}

/// The same where there is no way to return an error, of each number for itself: where the divisor is nothing but rounding, what is computed
/// with it is not a number.
#[inline(always)]
#[must_use]
pub fn determined<T: Scalar>(divisor: T, scale: T) -> T {
    let eight = divisor.constant(8.0 * f64::EPSILON, 8.0 * f32::EPSILON);
    let is_determined = (eight * scale).less(divisor.abs());
    let reciprocal = divisor.constant(1.0, 1.0) / divisor;
    T::select(
        is_determined,
        reciprocal,
        divisor.constant(f64::NAN, f32::NAN),
    )
}

/// What recurrences read of the order n of a coefficient.
pub mod order {
    use crate::integrate::exact;

    /// n
    #[inline(always)]
    #[must_use]
    pub fn order(n: usize) -> f64 {
        exact(n)
    }

    /// 1/n
    #[inline(always)]
    #[must_use]
    pub fn inverse(n: usize) -> f64 {
        1.0 / exact(n)
    }

    /// Coefficient n of time, n > 0.
    #[inline(always)]
    #[must_use]
    pub fn time(n: usize) -> f64 {
        if n == 1 { 1.0 } else { 0.0 }
    }
}
