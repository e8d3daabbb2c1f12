//! Checks of constructors and of motions that have ended.

use nalgebra::Matrix3;

use crate::bodies::body::{Impossible, InvalidBody};
use crate::mechanics::inertia::{InvalidInertia, check_swinging, check_turning};
use crate::numbers::scalar::Scalar;

/// Checks that all parameters are finite.
///
/// # Errors
/// [`InvalidBody::NotFinite`] with the first that is not.
pub fn check_finite<T: Scalar>(params: &[(&'static str, T)]) -> Result<(), InvalidBody> {
    not_finite(params).map_or(Ok(()), |(name, value)| {
        Err(InvalidBody::NotFinite { name, value })
    })
}

/// Checks that all values are finite that are computed from these parameters.
///
/// # Errors
/// [`InvalidBody::Derived`] with the first that is not.
pub fn check_derived<T: Scalar>(values: &[(&'static str, T)]) -> Result<(), InvalidBody> {
    not_finite(values).map_or(Ok(()), |(from, value)| {
        Err(InvalidBody::Derived { from, value })
    })
}

/// The first of these values that is not finite.
fn not_finite<T: Scalar>(values: &[(&'static str, T)]) -> Option<(&'static str, f64)> {
    let mut all = values.iter();
    all.find_map(|(name, value)| Some((*name, find(*value, |value| !value.is_finite())?)))
}

/// The mass \[kg\]: finite and positive.
///
/// # Errors
/// [`Impossible::Mass`].
pub fn check_mass<T: Scalar>(value: T) -> Result<(), Impossible> {
    match find(value, |value| !is_positive(value)) {
        Some(value) => Err(Impossible::Mass(value)),
        None => Ok(()),
    }
}

/// The moment of inertia of a planar body, of a rod, or about a hinge \[kg m²\]: finite and positive.
///
/// # Errors
/// [`Impossible::PlanarInertia`].
pub fn check_planar_inertia<T: Scalar>(value: T) -> Result<(), Impossible> {
    match find(value, |value| !is_positive(value)) {
        Some(value) => Err(Impossible::PlanarInertia(value)),
        None => Ok(()),
    }
}

/// The same for a body that swings about another point than its G, and may be a point mass.
///
/// # Errors
/// [`Impossible::PlanarInertia`].
pub fn check_swinging_planar_inertia<T: Scalar>(value: T) -> Result<(), Impossible> {
    match find(value, |value| !(is_positive(value) || value == 0.0)) {
        Some(value) => Err(Impossible::PlanarInertia(value)),
        None => Ok(()),
    }
}

/// Checks a property of a link or a cable, or an inertia with what loads add, given the name of what it
/// belongs to and the word for it: finite and positive, or zero where that is permitted.
///
/// # Errors
/// [`InvalidBody::Property`].
pub fn check_property<T: Scalar>(
    (of, property): (&'static str, &'static str),
    value: T,
    may_vanish: bool,
) -> Result<(), InvalidBody> {
    let is_wrong = |value| !(is_positive(value) || may_vanish && value == 0.0);
    match find(value, is_wrong) {
        Some(value) => Err(InvalidBody::Property {
            of,
            property,
            value,
        }),
        None => Ok(()),
    }
}

/// The entries xx, yy, zz, xy, yz, zx of an inertia tensor \[kg m²\]: that of a possible body, and
/// invertible.
///
/// # Errors
/// [`Impossible::Inertia`] with the violated condition.
pub fn check_inertia<T: Scalar>(entries: [T; 6]) -> Result<(), Impossible> {
    check_all(entries, check_turning)
}

/// The same for a body on a hinge beside its G, which may be a point mass or a rod.
///
/// # Errors
/// [`Impossible::Inertia`].
pub fn check_swinging_inertia<T: Scalar>(entries: [T; 6]) -> Result<(), Impossible> {
    check_all(entries, check_swinging)
}

fn check_all<T: Scalar>(
    entries: [T; 6],
    check: fn(&Matrix3<f64>, f64) -> Result<(), InvalidInertia>,
) -> Result<(), Impossible> {
    for lane in 0..T::LANES {
        let [xx, yy, zz, xy, yz, zx] = entries.map(|entry| entry.lane(lane));
        let matrix = Matrix3::new(xx, xy, zx, xy, yy, yz, zx, yz, zz);
        check(&matrix, T::EPSILON).map_err(Impossible::Inertia)?;
    }
    Ok(())
}

/// Adds the name of a body of a system to the result of its check.
///
/// # Errors
/// [`InvalidBody::Member`].
pub fn member(body: &'static str, found: Result<(), Impossible>) -> Result<(), InvalidBody> {
    found.map_err(|impossible| InvalidBody::Member { body, impossible })
}

/// The first number of a scalar with a property.
fn find<T: Scalar>(scalar: T, is_such: impl Fn(f64) -> bool) -> Option<f64> {
    (0..T::LANES)
        .map(|lane| scalar.lane(lane))
        .find(|value| is_such(*value))
}

fn is_positive(value: f64) -> bool {
    value.is_finite() && value > 0.0
}

/// The first of these loads with an infinite or NaN component.
#[must_use]
pub fn lost_load<T: Scalar>(loads: &[(&'static str, &[T])]) -> Option<&'static str> {
    let is_lost = |part: &T| find(*part, |value| !value.is_finite()).is_some();
    let lost = loads.iter().find(|(_, parts)| parts.iter().any(is_lost));
    lost.map(|(name, _)| *name)
}
