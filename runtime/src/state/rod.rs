//! The state of a slender rod: five degrees of freedom.
//!
//! A rod has no moment of inertia about its axis, and turning about it is no motion. What is left of the attitude is the
//! axis u, a point of the unit sphere, and its rate u̇, tangent there.

use nalgebra::{SVector, Unit, UnitVector3, Vector3};
#[cfg(feature = "serde")]
use serde::{Deserialize, Serialize};

use super::State;
use crate::attitude;
use crate::private::math;

/// State of `motion: rod(axis)`, five degrees of freedom: |u| = 1 and u·u̇ = 0.
///
/// By default the axis is along world x, that of a rod with J = (0, J, J) and body axes along world axes.
///
/// The five-dimensional sphere bundle is not a group, but rigid motions act on it: with w = u × u̇, the angular velocity
/// without spin, (u, w) is a line in space with a moment about the origin, and a displacement turns and shifts it,
///
/// ```text
/// u₁ = R u        u̇₁ = R u̇ + P V ü        R = exp ξ,  P = 1 - u₁ u₁ᵀ
/// V = ∫₀¹ exp(sξ) ds = 1 + (1 - cos ξ)/ξ² [ξ]× + (ξ - sin ξ)/ξ³ [ξ]×²
/// ```
///
/// This is the flow of a constant element (ξ, η) of the Lie algebra of rigid motions, η = -ü; the rate of a state has
/// ξ = w. So methods on Lie groups keep their order, both conditions hold exactly but for rounding (which is removed at
/// each displacement), and a free rod moves along its great circle without error.
///
/// ```
/// use newton_euler::prelude::*;
/// use nalgebra::Vector3;
///
/// let thrown = Rod { axis_rate: Vector3::new(0.0, 0.2, 0.0), ..Rod::default() };
/// let later = thrown.moved(&(thrown.rate(&RodAcceleration::default()) * 10.0));
/// assert!((later.axis.into_inner() - Vector3::new(2.0_f64.cos(), 2.0_f64.sin(), 0.0)).norm() < 1e-15);
/// assert!((later.axis_rate - Vector3::new(-2.0_f64.sin(), 2.0_f64.cos(), 0.0) * 0.2).norm() < 1e-15);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(Serialize, Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(try_from = "written::Rod", into = "written::Rod")
)]
pub struct Rod {
    /// Position of G, world axes \[m\].
    pub position: Vector3<f64>,
    /// Velocity of G, world axes \[m/s\].
    pub velocity: Vector3<f64>,
    /// Unit vector u along the rod, world axes.
    pub axis: UnitVector3<f64>,
    /// u̇, perpendicular to the axis, world axes \[1/s\]; a component along it has no meaning and is dropped when the
    /// state is moved.
    pub axis_rate: Vector3<f64>,
}

/// Acceleration of a [`Rod`].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(Serialize, Deserialize))]
pub struct RodAcceleration {
    /// Acceleration of G, world axes \[m/s²\].
    pub linear: Vector3<f64>,
    /// ü, world axes \[1/s²\]: `(K × u)/J - |u̇|² u`, with K the moment about G and J the moment of inertia about every
    /// axis through G perpendicular to the rod. Its component along u follows from |u| = 1 and is not read.
    pub axis: Vector3<f64>,
}

impl Default for Rod {
    fn default() -> Self {
        Self {
            position: Vector3::zeros(),
            velocity: Vector3::zeros(),
            axis: Vector3::x_axis(),
            axis_rate: Vector3::zeros(),
        }
    }
}

impl Rod {
    /// w = u × u̇, the angular velocity in world axes, of a rod that does not spin \[rad/s\].
    ///
    /// ```
    /// use newton_euler::prelude::*;
    /// use nalgebra::Vector3;
    ///
    /// let rod = Rod { axis_rate: Vector3::new(0.0, 2.0, 0.0), ..Rod::default() };
    /// assert_eq!(rod.angular_velocity(), Vector3::new(0.0, 0.0, 2.0));
    /// ```
    #[inline]
    #[must_use]
    pub fn angular_velocity(&self) -> Vector3<f64> {
        self.axis.cross(&self.axis_rate)
    }
}

impl State for Rod {
    type Scalar = f64;
    type Acceleration = RodAcceleration;
    /// Velocity, angular velocity u × u̇, acceleration of G, ü without its component along u: three components each.
    type Rate = SVector<f64, 12>;

    #[inline]
    fn rate(&self, acceleration: &RodAcceleration) -> Self::Rate {
        let [v, w] = [self.velocity, self.angular_velocity()];
        let [a, b] = [
            acceleration.linear,
            perpendicular(&acceleration.axis, &self.axis),
        ];
        SVector::from([v.x, v.y, v.z, w.x, w.y, w.z, a.x, a.y, a.z, b.x, b.y, b.z])
    }

    #[inline]
    fn moved(&self, displacement: &Self::Rate) -> Self {
        let turn: Vector3<f64> = displacement.fixed_rows::<3>(3).into();
        let change: Vector3<f64> = displacement.fixed_rows::<3>(9).into();
        let rotation = attitude::exp(&turn);
        let axis = rotation * self.axis.into_inner();
        let axis = axis * (0.5 * (3.0 - axis.norm_squared()));
        let rate = rotation * self.axis_rate + averaged(&change, &turn);
        Self {
            position: self.position + displacement.fixed_rows::<3>(0),
            velocity: self.velocity + displacement.fixed_rows::<3>(6),
            axis: Unit::new_unchecked(axis),
            axis_rate: perpendicular(&rate, &axis),
        }
    }
}

/// What of a vector is perpendicular to a unit vector.
#[inline]
fn perpendicular(vector: &Vector3<f64>, unit: &Vector3<f64>) -> Vector3<f64> {
    vector - unit * unit.dot(vector)
}

/// V of [`Rod`]: the mean of a vector over a turn, begun at the vector.
#[inline]
fn averaged(vector: &Vector3<f64>, turn: &Vector3<f64>) -> Vector3<f64> {
    let square = turn.norm_squared();
    // (1 - cos ξ)/ξ² and (ξ - sin ξ)/ξ³; of each series, the first term left out is below 2⁻⁵³ of the sum
    let (first, second) = if square < 1e-2 {
        let x = square;
        (
            1.0 / 2.0
                - x * (1.0 / 24.0 - x * (1.0 / 720.0 - x * (1.0 / 40320.0 - x / 3_628_800.0))),
            1.0 / 6.0
                - x * (1.0 / 120.0 - x * (1.0 / 5040.0 - x * (1.0 / 362_880.0 - x / 39_916_800.0))),
        )
    } else {
        let angle = math::sqrt(square);
        let half = math::sin(0.5 * angle) / angle;
        (
            2.0 * half * half,
            (angle - math::sin(angle)) / (square * angle),
        )
    };
    let turned = turn.cross(vector);
    vector + turned * first + turn.cross(&turned) * second
}

/// A rod as it is serialised, with the axis as a plain vector, checked on reading.
#[cfg(feature = "serde")]
mod written {
    use nalgebra::{Unit, Vector3};
    use serde::{Deserialize, Serialize};

    /// How far |u|² may be from 1, and u·u̇ from 0 relative to |u̇|: as for attitudes, nine printed digits pass, single
    /// precision does not, and what passes is right to rounding after the first step. It is kept as it was read.
    const TOLERANCE: f64 = 1e-9;

    #[derive(Serialize, Deserialize)]
    pub(super) struct Rod {
        position: Vector3<f64>,
        velocity: Vector3<f64>,
        axis: Vector3<f64>,
        axis_rate: Vector3<f64>,
    }

    impl From<super::Rod> for Rod {
        fn from(rod: super::Rod) -> Self {
            Self {
                position: rod.position,
                velocity: rod.velocity,
                axis: rod.axis.into_inner(),
                axis_rate: rod.axis_rate,
            }
        }
    }

    /// Why it is refused.
    #[derive(Clone, Copy)]
    pub(super) enum Invalid {
        Axis { square: f64 },
        Rate { cosine: f64 },
    }

    impl core::fmt::Display for Invalid {
        fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
            match self {
                Self::Axis { square } => write!(
                    f,
                    "axis must be a unit vector: |u|² is {square}, further than {TOLERANCE:e} from 1"
                ),
                Self::Rate { cosine } => write!(
                    f,
                    "axis_rate must be perpendicular to axis: the cosine between them is {cosine}, further than {TOLERANCE:e} from 0"
                ),
            }
        }
    }

    impl TryFrom<Rod> for super::Rod {
        type Error = Invalid;

        fn try_from(rod: Rod) -> Result<Self, Invalid> {
            let Rod {
                position,
                velocity,
                axis,
                axis_rate,
            } = rod;
            let square = axis.norm_squared();
            if (square - 1.0).abs() > TOLERANCE || !square.is_finite() {
                return Err(Invalid::Axis { square });
            }
            let largest = axis_rate.amax();
            if largest > 0.0 {
                let cosine = axis.dot(&(axis_rate / largest).normalize());
                if cosine.abs() > TOLERANCE || !cosine.is_finite() {
                    return Err(Invalid::Rate { cosine });
                }
            }
            Ok(Self {
                position,
                velocity,
                axis: Unit::new_unchecked(axis),
                axis_rate,
            })
        }
    }
}
