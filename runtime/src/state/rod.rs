//! The state of a slender rod: five degrees of freedom.
//!
//! A rod has no moment of inertia about its axis, and rotation about it is not modeled. What
//! remains of the attitude is the axis u, a point of the unit sphere, and its rate u̇, tangent
//! there.

use nalgebra::{SVector, Unit, UnitQuaternion, UnitVector3, Vector3};
#[cfg(feature = "serde")]
use serde::{Deserialize, Serialize};

use super::space::State;
use crate::mechanics::attitude;
use crate::numbers::scalar::{Scalar, either};

/// State of `motion: rod(axis)`, five degrees of freedom: |u| = 1 and u·u̇ = 0.
///
/// By default the axis is along world x, as for a rod with J = (0, J, J) and body axes along world
/// axes.
///
/// The five-dimensional sphere bundle is not a group, but rigid motions act on it: with w = u × u̇,
/// the angular velocity without spin, (u, w) is a line in space with a moment about the origin, and
/// a displacement rotates and shifts it,
///
/// ```text
/// u₁ = R u        u̇₁ = R u̇ + P V ü        R = exp ξ,  P = 1 - u₁ u₁ᵀ
/// V = ∫₀¹ exp(sξ) ds = 1 + (1 - cos ξ)/ξ² [ξ]× + (ξ - sin ξ)/ξ³ [ξ]×²
/// ```
///
/// This is the flow of a constant element (ξ, η) of the Lie algebra of rigid motions, η = -ü; the
/// rate of a state has ξ = w. So methods on Lie groups keep their order, both conditions hold
/// exactly except for rounding (which is removed at each displacement), and a free rod moves along
/// its great circle without error.
///
/// ```
/// use newton_euler::prelude::*;
/// use newton_euler::nalgebra::Vector3;
///
/// let thrown = Rod { axis_rate: Vector3::new(0.0, 0.2, 0.0), ..Rod::default() };
/// let later = thrown.moved(&(thrown.rate(&RodAcceleration::default()) * 10.0));
/// assert!(
///     (later.axis.into_inner() - Vector3::new(2.0_f64.cos(), 2.0_f64.sin(), 0.0)).norm() < 1e-15
/// );
/// assert!(
///     (later.axis_rate - Vector3::new(-2.0_f64.sin(), 2.0_f64.cos(), 0.0) * 0.2).norm() < 1e-15
/// );
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(Serialize, Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(try_from = "written::Rod<T>", into = "written::Rod<T>")
)]
pub struct Rod<T: Scalar> {
    /// Position of G, world axes \[m\].
    pub position: Vector3<T>,
    /// Velocity of G, world axes \[m/s\].
    pub velocity: Vector3<T>,
    /// Unit vector u along the rod, world axes.
    pub axis: UnitVector3<T>,
    /// u̇, perpendicular to the axis, world axes \[1/s\]; a component along it has no meaning and
    /// is dropped when the state is moved.
    pub axis_rate: Vector3<T>,
}

/// Acceleration of a [`Rod`].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(Serialize, Deserialize))]
pub struct RodAcceleration<T: Scalar> {
    /// Acceleration of G, world axes \[m/s²\].
    pub linear: Vector3<T>,
    /// ü, world axes \[1/s²\]: `(K × u)/J - |u̇|² u`, with K the moment about G and J the moment of
    /// inertia about every axis through G perpendicular to the rod. Its component along u follows
    /// from |u| = 1 and is not read.
    pub axis: Vector3<T>,
}

impl<T: Scalar> Default for Rod<T> {
    fn default() -> Self {
        let [zero, one] = [T::default(), T::default().constant(1.0, 1.0)];
        Self {
            position: Vector3::default(),
            velocity: Vector3::default(),
            axis: Unit::new_unchecked(Vector3::new(one, zero, zero)),
            axis_rate: Vector3::default(),
        }
    }
}

impl<T: Scalar> Rod<T> {
    /// w = u × u̇, the angular velocity of a rod without spin, in world axes \[rad/s\].
    ///
    /// ```
    /// use newton_euler::prelude::*;
    /// use newton_euler::nalgebra::Vector3;
    ///
    /// let rod = Rod { axis_rate: Vector3::new(0.0, 2.0, 0.0), ..Rod::default() };
    /// assert_eq!(rod.angular_velocity(), Vector3::new(0.0, 0.0, 2.0));
    /// ```
    #[cfg_attr(not(unoptimized), inline(always))]
    #[must_use]
    pub fn angular_velocity(&self) -> Vector3<T> {
        cross(self.axis.as_ref(), &self.axis_rate)
    }
}

impl<T: Scalar> State for Rod<T> {
    type Scalar = T;
    type Acceleration = RodAcceleration<T>;
    /// Velocity, angular velocity u × u̇, acceleration of G, ü without its component along u: three
    /// components each.
    type Rate = SVector<T, 12>;

    #[cfg_attr(not(unoptimized), inline(always))]
    fn rate(&self, acceleration: &RodAcceleration<T>) -> Self::Rate {
        let [v, w] = [self.velocity, self.angular_velocity()];
        let [a, b] = [
            acceleration.linear,
            perpendicular(&acceleration.axis, self.axis.as_ref()),
        ];
        SVector::from([v.x, v.y, v.z, w.x, w.y, w.z, a.x, a.y, a.z, b.x, b.y, b.z])
    }

    #[cfg_attr(not(unoptimized), inline(always))]
    fn moved(&self, displacement: &Self::Rate) -> Self {
        let turn: Vector3<T> = displacement.fixed_rows::<3>(3).into();
        let change: Vector3<T> = displacement.fixed_rows::<3>(9).into();
        let rotation = attitude::generic::exp(&turn);
        let axis = turned(&rotation, self.axis.as_ref());
        let [half, three] = [axis.x.constant(0.5, 0.5), axis.x.constant(3.0, 3.0)];
        let axis = axis * (half * (three - dot(&axis, &axis)));
        let rate = turned(&rotation, &self.axis_rate) + averaged(&change, &turn);
        Self {
            position: self.position + displacement.fixed_rows::<3>(0),
            velocity: self.velocity + displacement.fixed_rows::<3>(6),
            axis: Unit::new_unchecked(axis),
            axis_rate: perpendicular(&rate, &axis),
        }
    }
}

/// The part of a vector perpendicular to a unit vector.
#[cfg_attr(not(unoptimized), inline(always))]
fn perpendicular<T: Scalar>(vector: &Vector3<T>, unit: &Vector3<T>) -> Vector3<T> {
    vector - unit * dot(unit, vector)
}

#[cfg_attr(not(unoptimized), inline(always))]
fn dot<T: Scalar>(a: &Vector3<T>, b: &Vector3<T>) -> T {
    a.x * b.x + a.y * b.y + a.z * b.z
}

#[cfg_attr(not(unoptimized), inline(always))]
fn cross<T: Scalar>(a: &Vector3<T>, b: &Vector3<T>) -> Vector3<T> {
    Vector3::new(
        a.y * b.z - a.z * b.y,
        a.z * b.x - a.x * b.z,
        a.x * b.y - a.y * b.x,
    )
}

/// `v + (w s + q × s)`, `s = q × 2 v`: for a small rotation, v is rounded once.
#[cfg_attr(not(unoptimized), inline(always))]
fn turned<T: Scalar>(attitude: &UnitQuaternion<T>, vector: &Vector3<T>) -> Vector3<T> {
    let [x, y, z, w]: [T; 4] = attitude.as_ref().coords.into();
    let q = Vector3::new(x, y, z);
    let swing = cross(&q, &(vector + vector));
    vector + (swing * w + cross(&q, &swing))
}

/// V of [`Rod`]: the mean of a vector over a rotation that begins at the vector.
#[cfg_attr(not(unoptimized), inline(always))]
fn averaged<T: Scalar>(vector: &Vector3<T>, turn: &Vector3<T>) -> Vector3<T> {
    let square = dot(turn, turn);
    // (1 - cos ξ)/ξ² and (ξ - sin ξ)/ξ³
    let small = square.less(square.constant(1e-2, 1e-2));
    let [first, second] = either(small, || series(square), || closed(square));
    let turned = cross(turn, vector);
    vector + turned * first + cross(turn, &turned) * second
}

/// The first omitted term of each sum is below 2⁻⁵³ of it.
#[cfg_attr(not(unoptimized), inline(always))]
fn series<T: Scalar>(x: T) -> [T; 2] {
    let over = |divisor: u32| {
        #[expect(clippy::cast_precision_loss, reason = "to be rounded once")]
        x.constant(1.0 / f64::from(divisor), 1.0 / divisor as f32)
    };
    [
        over(2) - x * (over(24) - x * (over(720) - x * (over(40320) - x * over(3_628_800)))),
        over(6) - x * (over(120) - x * (over(5040) - x * (over(362_880) - x * over(39_916_800)))),
    ]
}

#[cfg_attr(not(unoptimized), inline(always))]
fn closed<T: Scalar>(square: T) -> [T; 2] {
    let [half, two] = [square.constant(0.5, 0.5), square.constant(2.0, 2.0)];
    let angle = square.sqrt();
    let ratio = (half * angle).sin() / angle;
    [
        two * ratio * ratio,
        (angle - angle.sin()) / (square * angle),
    ]
}

/// A rod in serialized form, with the axis as a plain vector, checked on reading.
#[cfg(feature = "serde")]
mod written {
    use nalgebra::{Unit, Vector3};
    use serde::{Deserialize, Serialize};

    use super::super::finite;
    use crate::numbers::messages::Number;
    use crate::numbers::scalar::Scalar;

    /// The permitted deviation of |u|² from 1, and of u·u̇ from 0 relative to |u̇|. As for
    /// attitudes, nine printed digits pass and single precision does not; accepted values are right
    /// to rounding after the first step. They are kept as read.
    fn tolerance<T: Scalar>() -> f64 {
        f64::max(1e-9, 8.0 * T::EPSILON)
    }

    #[derive(Serialize, Deserialize)]
    #[serde(bound(deserialize = "T: Scalar + Deserialize<'de>"))]
    pub(super) struct Rod<T: Scalar> {
        #[serde(deserialize_with = "finite::vector")]
        position: Vector3<T>,
        #[serde(deserialize_with = "finite::vector")]
        velocity: Vector3<T>,
        #[serde(deserialize_with = "finite::vector")]
        axis: Vector3<T>,
        #[serde(deserialize_with = "finite::vector")]
        axis_rate: Vector3<T>,
    }

    impl<T: Scalar> From<super::Rod<T>> for Rod<T> {
        fn from(rod: super::Rod<T>) -> Self {
            Self {
                position: rod.position,
                velocity: rod.velocity,
                axis: rod.axis.into_inner(),
                axis_rate: rod.axis_rate,
            }
        }
    }

    /// The reason for the refusal.
    #[derive(Clone, Copy)]
    pub(super) enum Invalid {
        Axis { square: f64, tolerance: f64 },
        Rate { cosine: f64, tolerance: f64 },
    }

    impl core::fmt::Display for Invalid {
        fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
            match *self {
                Self::Axis { square, tolerance } => write!(
                    f,
                    "axis must be a unit vector: |u|² is {}, further than {} from 1",
                    Number(square),
                    Number(tolerance)
                ),
                Self::Rate { cosine, tolerance } => write!(
                    f,
                    "axis_rate must be perpendicular to axis: the cosine between them is {}, further than {} from 0",
                    Number(cosine),
                    Number(tolerance)
                ),
            }
        }
    }

    impl<T: Scalar> TryFrom<Rod<T>> for super::Rod<T> {
        type Error = Invalid;

        fn try_from(rod: Rod<T>) -> Result<Self, Invalid> {
            let tolerance = tolerance::<T>();
            for lane in 0..T::LANES {
                let [axis, rate] = [rod.axis, rod.axis_rate]
                    .map(|vector| vector.map(|component| component.lane(lane)));
                check(&axis, &rate, tolerance)?;
            }
            Ok(Self {
                position: rod.position,
                velocity: rod.velocity,
                axis: Unit::new_unchecked(rod.axis),
                axis_rate: rod.axis_rate,
            })
        }
    }

    fn check(axis: &Vector3<f64>, rate: &Vector3<f64>, tolerance: f64) -> Result<(), Invalid> {
        let square = axis.norm_squared();
        if (square - 1.0).abs() > tolerance || !square.is_finite() {
            return Err(Invalid::Axis { square, tolerance });
        }
        let largest = rate.amax();
        if largest > 0.0 {
            let cosine = axis.dot(&(rate / largest).normalize());
            if cosine.abs() > tolerance || !cosine.is_finite() {
                return Err(Invalid::Rate { cosine, tolerance });
            }
        }
        Ok(())
    }
}
