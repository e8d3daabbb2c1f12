//! States of bodies that move in a plane.

use nalgebra::{Vector2, Vector4, Vector6};
#[cfg(feature = "serde")]
use serde::{Deserialize, Serialize};

#[cfg(feature = "serde")]
use super::finite;
use super::space::State;
use crate::numbers::scalar::Scalar;

/// State of `motion: planar`, three degrees of freedom.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(Serialize, Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(deserialize = "T: Scalar + Deserialize<'de>"))
)]
pub struct Planar<T: Scalar> {
    /// Position of G, world axes \[m\].
    #[cfg_attr(feature = "serde", serde(deserialize_with = "finite::vector"))]
    pub position: Vector2<T>,
    /// From world x to body x, counterclockwise, not wrapped \[rad\].
    #[cfg_attr(feature = "serde", serde(deserialize_with = "finite::scalar"))]
    pub angle: T,
    /// Velocity of G, world axes \[m/s\].
    #[cfg_attr(feature = "serde", serde(deserialize_with = "finite::vector"))]
    pub velocity: Vector2<T>,
    /// Rate of the angle \[rad/s\].
    #[cfg_attr(feature = "serde", serde(deserialize_with = "finite::scalar"))]
    pub angular_velocity: T,
}

/// Acceleration of a [`Planar`] state.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(Serialize, Deserialize))]
pub struct PlanarAcceleration<T: Scalar> {
    /// Acceleration of G, world axes \[m/s²\].
    pub linear: Vector2<T>,
    /// Angular acceleration, counterclockwise \[rad/s²\].
    pub angular: T,
}

/// State of `motion: planar_translation`, two degrees of freedom; body axes stay along world axes.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(Serialize, Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(deserialize = "T: Scalar + Deserialize<'de>"))
)]
pub struct PlanarTranslation<T: Scalar> {
    /// Position of G, world axes \[m\].
    #[cfg_attr(feature = "serde", serde(deserialize_with = "finite::vector"))]
    pub position: Vector2<T>,
    /// Velocity of G, world axes \[m/s\].
    #[cfg_attr(feature = "serde", serde(deserialize_with = "finite::vector"))]
    pub velocity: Vector2<T>,
}

impl<T: Scalar> State for Planar<T> {
    type Scalar = T;
    type Acceleration = PlanarAcceleration<T>;
    /// Velocity (two components), angular velocity, acceleration of G (two), angular acceleration.
    type Rate = Vector6<T>;

    #[cfg_attr(not(unoptimized), inline(always))]
    fn rate(&self, acceleration: &PlanarAcceleration<T>) -> Self::Rate {
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

    #[cfg_attr(not(unoptimized), inline(always))]
    fn moved(&self, displacement: &Self::Rate) -> Self {
        Self {
            position: self.position + displacement.fixed_rows::<2>(0),
            angle: self.angle + displacement[2],
            velocity: self.velocity + displacement.fixed_rows::<2>(3),
            angular_velocity: self.angular_velocity + displacement[5],
        }
    }
}

impl<T: Scalar> State for PlanarTranslation<T> {
    type Scalar = T;
    type Acceleration = Vector2<T>;
    /// Velocity, acceleration of G: two components each.
    type Rate = Vector4<T>;

    #[cfg_attr(not(unoptimized), inline(always))]
    fn rate(&self, acceleration: &Vector2<T>) -> Self::Rate {
        let [v, a] = [self.velocity, *acceleration];
        Vector4::new(v.x, v.y, a.x, a.y)
    }

    #[cfg_attr(not(unoptimized), inline(always))]
    fn moved(&self, displacement: &Self::Rate) -> Self {
        Self {
            position: self.position + displacement.fixed_rows::<2>(0),
            velocity: self.velocity + displacement.fixed_rows::<2>(2),
        }
    }
}
