//! A state for each body.

use nalgebra::{UnitQuaternion, Vector2, Vector3};
use newton_euler::prelude::*;

/// A state in which nothing vanishes, and the body is not in a special position.
pub trait Somewhere {
    fn somewhere() -> Self;
}

impl Somewhere for Spatial {
    fn somewhere() -> Self {
        let Rotation {
            attitude,
            angular_velocity,
        } = Rotation::somewhere();
        Self {
            position: Vector3::new(3.0, -2.0, 1.5),
            attitude,
            velocity: Vector3::new(0.7, 1.1, -0.4),
            angular_velocity,
        }
    }
}

impl Somewhere for Rotation {
    fn somewhere() -> Self {
        Self {
            attitude: UnitQuaternion::from_euler_angles(0.3, -0.5, 0.9),
            angular_velocity: Vector3::new(1.5, -0.8, 2.2),
        }
    }
}

impl Somewhere for Planar {
    fn somewhere() -> Self {
        Self {
            position: Vector2::new(3.0, -2.0),
            angle: 0.3,
            velocity: Vector2::new(0.7, 1.1),
            angular_velocity: 1.5,
        }
    }
}

impl Somewhere for Hinge {
    fn somewhere() -> Self {
        Self {
            angle: 0.3,
            angular_velocity: 1.5,
        }
    }
}

impl Somewhere for Slide {
    fn somewhere() -> Self {
        Self {
            position: 0.7,
            velocity: -0.4,
        }
    }
}

impl Somewhere for Universal {
    fn somewhere() -> Self {
        Self {
            angle_1: 0.3,
            angle_2: -0.5,
            angular_velocity_1: 1.5,
            angular_velocity_2: -0.8,
        }
    }
}
