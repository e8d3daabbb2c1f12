//! The same bodies, as one would write them without the macro: nalgebra's vectors, a stored inertia
//! and its stored inverse.
//!
//! Everything is `#[inline(always)]`, so that the calls that are inlined on one side are inlined on
//! the other, too.

use nalgebra::{Matrix3, Rotation2, Vector2, Vector3};
use newton_euler::prelude::*;

const MASS: f64 = 3.2;
const GRAVITY: f64 = 9.80665;

pub fn full() -> Matrix3<f64> {
    Matrix3::new(1.3, -0.12, 0.07, -0.12, 1.7, -0.05, 0.07, -0.05, 2.1)
}

pub fn diagonal() -> Matrix3<f64> {
    Matrix3::from_diagonal(&Vector3::new(1.3, 1.7, 2.1))
}

/// A body in space. Its input is the force, in body axes.
pub struct Space {
    inverse_mass: f64,
    nozzle: Vector3<f64>,
    gravity: Vector3<f64>,
    rotation: Turning,
}

impl Space {
    /// The weight acts along -z.
    pub fn new(inertia: Matrix3<f64>) -> Self {
        Self {
            inverse_mass: 1.0 / MASS,
            nozzle: Vector3::new(0.1, -0.2, 0.05),
            gravity: Vector3::z() * -GRAVITY,
            rotation: Turning::new(inertia),
        }
    }

    /// The nozzle is in the x-y plane, and the weight acts along -y.
    pub fn flat() -> Self {
        Self {
            nozzle: Vector3::new(0.1, -0.2, 0.0),
            gravity: Vector3::y() * -GRAVITY,
            ..Self::new(diagonal())
        }
    }
}

impl RigidBody for Space {
    type Scalar = f64;
    type State = Spatial;
    type Input = Vector3<f64>;

    #[inline(always)]
    fn acceleration(&self, _: f64, state: &Spatial, force: &Vector3<f64>) -> SpatialAcceleration {
        SpatialAcceleration {
            linear: state.attitude * (force * self.inverse_mass) + self.gravity,
            angular: self
                .rotation
                .rate(&state.angular_velocity, &self.nozzle.cross(force)),
        }
    }
}

/// The same body under a force at G, in world axes, and a moment, in body axes.
pub struct Unturned(pub Space);

impl RigidBody for Unturned {
    type Scalar = f64;
    type State = Spatial;
    type Input = (Vector3<f64>, Vector3<f64>);

    #[inline(always)]
    fn acceleration(
        &self,
        _: f64,
        state: &Spatial,
        (force, moment): &Self::Input,
    ) -> SpatialAcceleration {
        let Self(space) = self;
        SpatialAcceleration {
            linear: force * space.inverse_mass + space.gravity,
            angular: space.rotation.rate(&state.angular_velocity, moment),
        }
    }
}

/// Only the rotation, without loads.
pub struct Turning {
    inertia: Matrix3<f64>,
    inverse: Matrix3<f64>,
}

impl Turning {
    pub fn new(inertia: Matrix3<f64>) -> Self {
        Self {
            inertia,
            inverse: inertia.try_inverse().expect("an invertible inertia"),
        }
    }

    /// `w' = J^-1 (M - w x J w)`
    #[inline(always)]
    fn rate(&self, w: &Vector3<f64>, moment: &Vector3<f64>) -> Vector3<f64> {
        self.inverse * (moment - w.cross(&(self.inertia * w)))
    }
}

impl RigidBody for Turning {
    type Scalar = f64;
    type State = Rotation;
    type Input = ();

    #[inline(always)]
    fn acceleration(&self, _: f64, state: &Rotation, (): &()) -> Vector3<f64> {
        let w = &state.angular_velocity;
        self.inverse * -w.cross(&(self.inertia * w))
    }
}

/// A body in the plane. Its input is the force, in body axes.
pub struct Flat {
    inverse_mass: f64,
    inverse_inertia: f64,
    nozzle: Vector2<f64>,
    gravity: Vector2<f64>,
}

impl Flat {
    pub fn new() -> Self {
        Self {
            inverse_mass: 1.0 / MASS,
            inverse_inertia: 1.0 / diagonal().m33,
            nozzle: Vector2::new(0.1, -0.2),
            gravity: Vector2::y() * -GRAVITY,
        }
    }
}

impl RigidBody for Flat {
    type Scalar = f64;
    type State = Planar;
    type Input = Vector2<f64>;

    #[inline(always)]
    fn acceleration(&self, _: f64, state: &Planar, force: &Vector2<f64>) -> PlanarAcceleration {
        PlanarAcceleration {
            linear: Rotation2::new(state.angle) * (force * self.inverse_mass) + self.gravity,
            angular: self.nozzle.perp(force) * self.inverse_inertia,
        }
    }
}

/// Only the sine and the cosine that a body in the plane needs, by the library's own functions.
pub struct SineAndCosine;

impl RigidBody for SineAndCosine {
    type Scalar = f64;
    type State = Planar;
    type Input = ();

    #[inline(always)]
    fn acceleration(&self, _: f64, state: &Planar, (): &()) -> PlanarAcceleration {
        let (sine, cosine) = newton_euler::Scalar::sin_cos(state.angle);
        PlanarAcceleration {
            linear: Vector2::new(cosine, sine),
            angular: 0.0,
        }
    }
}
