//! Random states for every kind of motion, from one set of coordinates.
#![allow(dead_code, reason = "each test uses its part")]

use nalgebra::{UnitQuaternion, Vector3};
use newton_euler::prelude::*;

/// Numbers that look random and are the same in every run: Vigna's splitmix64.
pub struct Random(pub u64);

impl Random {
    /// Between -1 and 1.
    pub fn number(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut bits = self.0;
        bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        bits ^= bits >> 31;
        // 53 bits: exact
        #[allow(clippy::cast_precision_loss)]
        let fraction = (bits >> 11) as f64 / (1_u64 << 53) as f64;
        2.0 * fraction - 1.0
    }

    pub fn vector(&mut self, size: f64) -> Vector3<f64> {
        Vector3::from_fn(|_, _| size * self.number())
    }

    pub fn coordinates(&mut self) -> Coordinates {
        Coordinates {
            position: self.vector(5.0),
            velocity: self.vector(4.0),
            attitude: UnitQuaternion::from_scaled_axis(self.vector(3.0)),
            angle: 3.0 * self.number(),
            angular_velocity: self.vector(3.0),
        }
    }
}

/// All that a state may be made of.
#[derive(Clone, Copy, Debug)]
pub struct Coordinates {
    pub position: Vector3<f64>,
    pub velocity: Vector3<f64>,
    /// Where a body turns in space.
    pub attitude: UnitQuaternion<f64>,
    /// Where it turns in the plane or about an axis.
    pub angle: f64,
    pub angular_velocity: Vector3<f64>,
}

/// What turns, and in how many directions.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Kind {
    Space,
    Plane,
    Hinge,
    Rod,
}

/// A state that is made of coordinates.
pub trait Moving: State {
    const KIND: Kind;
    fn at(coordinates: &Coordinates) -> Self;
    /// Linear, and angular as far as the motion has it; planar ones in space.
    fn accelerations(acceleration: &Self::Acceleration) -> [Vector3<f64>; 2];
}

impl Moving for Spatial {
    const KIND: Kind = Kind::Space;

    fn at(c: &Coordinates) -> Self {
        Self {
            position: c.position,
            attitude: c.attitude,
            velocity: c.velocity,
            angular_velocity: c.angular_velocity,
        }
    }

    fn accelerations(acceleration: &SpatialAcceleration) -> [Vector3<f64>; 2] {
        [acceleration.linear, acceleration.angular]
    }
}

impl Moving for Rotation {
    const KIND: Kind = Kind::Space;

    fn at(c: &Coordinates) -> Self {
        Self {
            attitude: c.attitude,
            angular_velocity: c.angular_velocity,
        }
    }

    fn accelerations(acceleration: &Vector3<f64>) -> [Vector3<f64>; 2] {
        [Vector3::zeros(), *acceleration]
    }
}

impl Moving for Translation {
    const KIND: Kind = Kind::Space;

    fn at(c: &Coordinates) -> Self {
        Self {
            position: c.position,
            velocity: c.velocity,
        }
    }

    fn accelerations(acceleration: &Vector3<f64>) -> [Vector3<f64>; 2] {
        [*acceleration, Vector3::zeros()]
    }
}

impl Moving for Planar {
    const KIND: Kind = Kind::Plane;

    fn at(c: &Coordinates) -> Self {
        Self {
            position: c.position.xy(),
            angle: c.angle,
            velocity: c.velocity.xy(),
            angular_velocity: c.angular_velocity.z,
        }
    }

    fn accelerations(acceleration: &PlanarAcceleration) -> [Vector3<f64>; 2] {
        let PlanarAcceleration { linear, angular } = *acceleration;
        [linear.push(0.0), Vector3::z() * angular]
    }
}

impl Moving for Hinge {
    const KIND: Kind = Kind::Hinge;

    fn at(c: &Coordinates) -> Self {
        Self {
            angle: c.angle,
            angular_velocity: c.angular_velocity.z,
        }
    }

    fn accelerations(acceleration: &f64) -> [Vector3<f64>; 2] {
        [Vector3::zeros(), Vector3::z() * *acceleration]
    }
}

/// The axis is x of the attitude.
impl Moving for Rod {
    const KIND: Kind = Kind::Rod;

    fn at(c: &Coordinates) -> Self {
        Self {
            position: c.position,
            velocity: c.velocity,
            axis: c.attitude * Vector3::x_axis(),
            axis_rate: c.attitude * c.angular_velocity.cross(&Vector3::x()),
        }
    }

    fn accelerations(acceleration: &RodAcceleration) -> [Vector3<f64>; 2] {
        [acceleration.linear, acceleration.axis]
    }
}
