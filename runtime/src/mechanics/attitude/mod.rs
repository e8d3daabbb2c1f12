//! Attitudes as unit quaternions: exponential, logarithm, kinematics, normalization.
//!
//! A unit quaternion takes body components to world components. Rotation vectors are in body axes,
//! so a further rotation multiplies from the right. Every map keeps its accuracy (a few units
//! in the last place) from angle zero, through angles whose square underflows, to π.

use nalgebra::{Quaternion, UnitQuaternion, Vector3};

use crate::numbers::math;

pub mod generic;

/// The rotation by the angle `|v|` about the axis v \[rad\].
///
/// ```
/// use core::f64::consts::PI;
/// use newton_euler::nalgebra::Vector3;
/// use newton_euler::attitude;
///
/// let half_turn = attitude::exp(&Vector3::new(0.0, 0.0, PI));
/// assert!((half_turn * Vector3::x() + Vector3::x()).norm() < 1e-15);
/// assert_eq!(attitude::exp(&Vector3::zeros()).w, 1.0);
/// ```
#[inline]
#[must_use]
pub fn exp(rotation: &Vector3<f64>) -> UnitQuaternion<f64> {
    generic::exp(rotation)
}

/// The rotation vector of an attitude, with an angle of at most π \[rad\]; q and -q give the same.
///
/// ```
/// use newton_euler::nalgebra::Vector3;
/// use newton_euler::attitude::{exp, log};
///
/// let rotation = Vector3::new(0.3e-9, -1.2e-9, 0.4e-9);
/// assert!((log(&exp(&rotation)) - rotation).norm() < 1e-24);
/// ```
#[must_use]
pub fn log(attitude: &UnitQuaternion<f64>) -> Vector3<f64> {
    let vector = attitude.imag();
    let square = vector.norm_squared();
    // Of q and -q, the one whose first nonzero component is positive: the angle is then at most π.
    let components = [attitude.w, attitude.i, attitude.j, attitude.k];
    let sign = components
        .into_iter()
        .find(|component| *component != 0.0)
        .map_or(1.0, f64::signum);
    let ratio = if square < 1e-17 {
        2.0 / attitude.w.abs() // atan(x)/x, of which x²/3 < 2⁻⁵⁷ is left out
    } else {
        let sine = math::sqrt(square);
        2.0 * math::atan2(sine, attitude.w.abs()) / sine
    };
    vector * (sign * ratio)
}

/// The derivative of the attitude, `q̇ = ½ q ⊗ (0, ω)`, with ω in body axes \[1/s\].
///
/// ```
/// use newton_euler::nalgebra::{UnitQuaternion, Vector3};
/// use newton_euler::attitude;
///
/// let rate = attitude::kinematics(&UnitQuaternion::identity(), &Vector3::new(0.0, 0.0, 3.0));
/// assert_eq!((rate.w, rate.k), (0.0, 1.5));
/// ```
#[inline]
#[must_use]
pub fn kinematics(
    attitude: &UnitQuaternion<f64>,
    angular_velocity: &Vector3<f64>,
) -> Quaternion<f64> {
    generic::kinematics(attitude, angular_velocity)
}

/// The shortest rotation of a unit vector, not opposite to it, to the third axis.
pub(crate) fn to_third_axis(unit: &Vector3<f64>) -> Quaternion<f64> {
    let above = 1.0 + unit.z;
    let norm = 1.0 / math::sqrt(2.0 * above);
    Quaternion::new(above * norm, unit.y * norm, -unit.x * norm, 0.0)
}

/// The unit quaternion nearest to one that is nearly unit, by one Newton step: `q (3 - |q|²)/2`.
///
/// It needs no root and no division. A deviation d of |q| from 1 becomes `3d²/2`, so deviations
/// below 1e-8 vanish. For quaternions far from unit use nalgebra's `UnitQuaternion::new_normalize`.
///
/// ```
/// use newton_euler::nalgebra::Quaternion;
/// use newton_euler::attitude;
///
/// let drifted = Quaternion::new(0.6, 0.0, 0.8, 0.0) * (1.0 + 1e-9);
/// assert!((attitude::normalized(&drifted).quaternion().norm() - 1.0).abs() < 4e-16);
/// ```
#[inline]
#[must_use]
pub fn normalized(quaternion: &Quaternion<f64>) -> UnitQuaternion<f64> {
    generic::normalized(quaternion)
}

/// An attitude rotated further by a rotation vector in body axes: normalized `q exp(v)`.
///
/// ```
/// use newton_euler::nalgebra::{UnitQuaternion, Vector3};
/// use newton_euler::attitude;
///
/// let yawed = attitude::turned(&UnitQuaternion::identity(), &Vector3::new(0.0, 0.0, 0.1));
/// assert!((yawed.angle() - 0.1).abs() < 1e-15);
/// ```
#[inline]
#[must_use]
pub fn turned(attitude: &UnitQuaternion<f64>, rotation: &Vector3<f64>) -> UnitQuaternion<f64> {
    generic::turned(attitude, rotation)
}

/// An attitude in serialized form: a map of its components by name, `{ w, x, y, z }`, so that no
/// reader has to guess which one is the scalar.
#[cfg(feature = "serde")]
pub(crate) mod checked {
    use nalgebra::{Quaternion, UnitQuaternion, Vector4};
    use serde::{Deserialize, Deserializer, Serialize, Serializer, de::Error};

    use crate::numbers::messages::Number;
    use crate::numbers::scalar::Scalar;

    /// The permitted deviation of |q|² from 1 on reading. An attitude printed with nine digits
    /// passes, one in single precision does not. An accepted attitude is kept as read; it is unit
    /// to rounding after the first step of a motion (see [`super::normalized`]).
    fn tolerance<T: Scalar>() -> f64 {
        f64::max(1e-9, 8.0 * T::EPSILON)
    }

    #[derive(Serialize, Deserialize)]
    #[serde(rename = "Attitude", expecting = "an attitude of `w`, `x`, `y`, `z`")]
    struct Components<T> {
        w: T,
        x: T,
        y: T,
        z: T,
    }

    pub(crate) fn serialize<T: Scalar + Serialize, S: Serializer>(
        attitude: &UnitQuaternion<T>,
        serializer: S,
    ) -> Result<S::Ok, S::Error> {
        let [x, y, z, w] = attitude.as_ref().coords.into();
        Components { w, x, y, z }.serialize(serializer)
    }

    pub(crate) fn deserialize<'de, T: Scalar + Deserialize<'de>, D: Deserializer<'de>>(
        deserializer: D,
    ) -> Result<UnitQuaternion<T>, D::Error> {
        let Components { w, x, y, z } = Components::<T>::deserialize(deserializer)?;
        let square = w * w + x * x + y * y + z * z;
        for lane in 0..T::LANES {
            let square = square.lane(lane);
            let is_unit = (square - 1.0).abs() <= tolerance::<T>();
            if !is_unit {
                return Err(D::Error::custom(format_args!(
                    "attitude must be a unit quaternion: |q|² is {}, further than {} from 1",
                    Number(square),
                    Number(tolerance::<T>())
                )));
            }
        }
        Ok(UnitQuaternion::new_unchecked(Quaternion {
            coords: Vector4::new(x, y, z, w),
        }))
    }
}
