//! States of a rigid body and how they move.
//!
//! One struct for each kind of `motion`. In all of them `position` and `velocity` are those of the center of mass G in
//! world axes \[m, m/s\], `attitude` takes body components to world components, and `angular_velocity` is in body axes
//! \[rad/s\]; planar angles are anticlockwise from world x to body x \[rad\], not wrapped. The default state is at
//! rest at the origin, body axes along world axes.

use core::ops::{Add, Mul, Sub};

use nalgebra::{SVector, UnitQuaternion, Vector2, Vector3, Vector4, Vector6};
#[cfg(feature = "serde")]
use serde::{Deserialize, Serialize};

use crate::attitude;

mod hinge;
mod rod;

pub use hinge::Hinge;
pub use rod::{Rod, RodAcceleration};

/// A point of the space of states: what an integrator needs to know of it.
///
/// That space is a product of straight lines and rotations, so states are not added: a state is moved by a
/// displacement, an element of the tangent space at that state. Angular displacements are rotation vectors in body
/// axes, as angular velocities are.
///
/// ```
/// use newton_euler::prelude::*;
///
/// let turning = Rotation { angular_velocity: [0.0, 0.0, 2.0].into(), ..Rotation::default() };
/// let later = turning.moved(&(turning.rate(&[0.0, 0.0, 0.5].into()) * 0.1));
/// assert!((later.attitude.angle() - 0.2).abs() < 1e-15);
/// assert!((later.angular_velocity.z - 2.05).abs() < 1e-15);
/// ```
pub trait State: Clone {
    /// The number type.
    type Scalar;
    /// The second derivatives of the coordinates, which with the state fix its rate.
    type Acceleration;
    /// An element of the tangent space.
    type Rate: Copy
        + Add<Output = Self::Rate>
        + Sub<Output = Self::Rate>
        + Mul<Self::Scalar, Output = Self::Rate>;

    /// The derivative of this state with respect to time, given the acceleration in it.
    fn rate(&self, acceleration: &Self::Acceleration) -> Self::Rate;

    /// The state at the end of a displacement: coordinates are added, attitudes become `attitude * exp(rotation)`
    /// and stay unit (see [`attitude::normalized`]).
    #[must_use]
    fn moved(&self, displacement: &Self::Rate) -> Self;
}

/// State of `motion: spatial`, six degrees of freedom.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(Serialize, Deserialize))]
pub struct Spatial {
    /// Position of G, world axes \[m\].
    pub position: Vector3<f64>,
    /// Takes body components to world components.
    #[cfg_attr(feature = "serde", serde(with = "attitude::checked"))]
    pub attitude: UnitQuaternion<f64>,
    /// Velocity of G, world axes \[m/s\].
    pub velocity: Vector3<f64>,
    /// Angular velocity, body axes \[rad/s\].
    pub angular_velocity: Vector3<f64>,
}

/// State of `motion: rotation`, three degrees of freedom.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(Serialize, Deserialize))]
pub struct Rotation {
    /// Takes body components to world components.
    #[cfg_attr(feature = "serde", serde(with = "attitude::checked"))]
    pub attitude: UnitQuaternion<f64>,
    /// Angular velocity, body axes \[rad/s\].
    pub angular_velocity: Vector3<f64>,
}

/// State of `motion: translation`, three degrees of freedom; body axes stay along world axes.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(Serialize, Deserialize))]
pub struct Translation {
    /// Position of G, world axes \[m\].
    pub position: Vector3<f64>,
    /// Velocity of G, world axes \[m/s\].
    pub velocity: Vector3<f64>,
}

/// State of `motion: planar`, three degrees of freedom.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(Serialize, Deserialize))]
pub struct Planar {
    /// Position of G, world axes \[m\].
    pub position: Vector2<f64>,
    /// From world x to body x, anticlockwise, not wrapped \[rad\].
    pub angle: f64,
    /// Velocity of G, world axes \[m/s\].
    pub velocity: Vector2<f64>,
    /// Rate of the angle \[rad/s\].
    pub angular_velocity: f64,
}

/// State of `motion: planar_translation`, two degrees of freedom; body axes stay along world axes.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(Serialize, Deserialize))]
pub struct PlanarTranslation {
    /// Position of G, world axes \[m\].
    pub position: Vector2<f64>,
    /// Velocity of G, world axes \[m/s\].
    pub velocity: Vector2<f64>,
}

/// Acceleration of a [`Spatial`] state.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(Serialize, Deserialize))]
pub struct SpatialAcceleration {
    /// Acceleration of G, world axes \[m/s²\].
    pub linear: Vector3<f64>,
    /// Angular acceleration, body axes \[rad/s²\]: the derivatives of the components of the angular velocity, which
    /// are the components of its derivative (1.7).
    pub angular: Vector3<f64>,
}

/// Acceleration of a [`Planar`] state.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(Serialize, Deserialize))]
pub struct PlanarAcceleration {
    /// Acceleration of G, world axes \[m/s²\].
    pub linear: Vector2<f64>,
    /// Angular acceleration, anticlockwise \[rad/s²\].
    pub angular: f64,
}

impl State for Spatial {
    type Scalar = f64;
    type Acceleration = SpatialAcceleration;
    /// Velocity, angular velocity, acceleration of G, angular acceleration: three components each.
    type Rate = SVector<f64, 12>;

    #[inline]
    fn rate(&self, acceleration: &SpatialAcceleration) -> Self::Rate {
        let [v, w] = [self.velocity, self.angular_velocity];
        let [a, b] = [acceleration.linear, acceleration.angular];
        SVector::from([v.x, v.y, v.z, w.x, w.y, w.z, a.x, a.y, a.z, b.x, b.y, b.z])
    }

    #[inline]
    fn moved(&self, displacement: &Self::Rate) -> Self {
        Self {
            position: self.position + displacement.fixed_rows::<3>(0),
            attitude: attitude::turned(&self.attitude, &displacement.fixed_rows::<3>(3).into()),
            velocity: self.velocity + displacement.fixed_rows::<3>(6),
            angular_velocity: self.angular_velocity + displacement.fixed_rows::<3>(9),
        }
    }
}

impl State for Rotation {
    type Scalar = f64;
    type Acceleration = Vector3<f64>;
    /// Angular velocity, angular acceleration: three components each.
    type Rate = Vector6<f64>;

    #[inline]
    fn rate(&self, acceleration: &Vector3<f64>) -> Self::Rate {
        let [w, b] = [self.angular_velocity, *acceleration];
        Vector6::new(w.x, w.y, w.z, b.x, b.y, b.z)
    }

    #[inline]
    fn moved(&self, displacement: &Self::Rate) -> Self {
        Self {
            attitude: attitude::turned(&self.attitude, &displacement.fixed_rows::<3>(0).into()),
            angular_velocity: self.angular_velocity + displacement.fixed_rows::<3>(3),
        }
    }
}

impl State for Translation {
    type Scalar = f64;
    type Acceleration = Vector3<f64>;
    /// Velocity, acceleration of G: three components each.
    type Rate = Vector6<f64>;

    #[inline]
    fn rate(&self, acceleration: &Vector3<f64>) -> Self::Rate {
        let [v, a] = [self.velocity, *acceleration];
        Vector6::new(v.x, v.y, v.z, a.x, a.y, a.z)
    }

    #[inline]
    fn moved(&self, displacement: &Self::Rate) -> Self {
        Self {
            position: self.position + displacement.fixed_rows::<3>(0),
            velocity: self.velocity + displacement.fixed_rows::<3>(3),
        }
    }
}

impl State for Planar {
    type Scalar = f64;
    type Acceleration = PlanarAcceleration;
    /// Velocity (two components), angular velocity, acceleration of G (two), angular acceleration.
    type Rate = Vector6<f64>;

    #[inline]
    fn rate(&self, acceleration: &PlanarAcceleration) -> Self::Rate {
        let [v, a] = [self.velocity, acceleration.linear];
        Vector6::new(
            v.x,
            v.y,
            self.angular_velocity,
            a.x,
            a.y,
            acceleration.angular,
        )
    }

    #[inline]
    fn moved(&self, displacement: &Self::Rate) -> Self {
        Self {
            position: self.position + displacement.fixed_rows::<2>(0),
            angle: self.angle + displacement[2],
            velocity: self.velocity + displacement.fixed_rows::<2>(3),
            angular_velocity: self.angular_velocity + displacement[5],
        }
    }
}

impl State for PlanarTranslation {
    type Scalar = f64;
    type Acceleration = Vector2<f64>;
    /// Velocity, acceleration of G: two components each.
    type Rate = Vector4<f64>;

    #[inline]
    fn rate(&self, acceleration: &Vector2<f64>) -> Self::Rate {
        let [v, a] = [self.velocity, *acceleration];
        Vector4::new(v.x, v.y, a.x, a.y)
    }

    #[inline]
    fn moved(&self, displacement: &Self::Rate) -> Self {
        Self {
            position: self.position + displacement.fixed_rows::<2>(0),
            velocity: self.velocity + displacement.fixed_rows::<2>(2),
        }
    }
}
