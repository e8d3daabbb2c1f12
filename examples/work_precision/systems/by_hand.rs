//! The pendulum and the satellite, their accelerations written by hand.

use nalgebra::{Matrix3, Vector2, Vector3};
use newton_euler::prelude::*;

use super::described::*;

/// `A θ₁'' + B cos(θ₁-θ₂) θ₂'' = ..` in the angles of both links against the ground.
pub struct Links;

impl RigidBody for Links {
    type Scalar = f64;
    type State = DoublePendulumState;
    type Input = ();

    #[inline(always)]
    fn acceleration(
        &self,
        _: f64,
        state: &DoublePendulumState,
        (): &(),
    ) -> DoublePendulumAcceleration {
        const G: f64 = 9.80665;
        // masses, moments of inertia, from hinge to center, from hinge to hinge
        const M: [f64; 2] = [1.2, 0.8];
        const J: [f64; 2] = [0.04, 0.015];
        const L: [f64; 2] = [0.28, 0.22];
        const LONG: f64 = 0.6;
        const A: f64 = J[0] + M[0] * L[0] * L[0] + M[1] * LONG * LONG;
        const B: f64 = M[1] * LONG * L[1];
        const C: f64 = J[1] + M[1] * L[1] * L[1];

        let first = state.shoulder.angle;
        let second = first + state.elbow.angle;
        let rate = state.shoulder.angular_velocity;
        let rates = Vector2::new(rate, rate + state.elbow.angular_velocity);
        // of the second link against the first
        let (sine, cosine) = state.elbow.angle.sin_cos();
        let loads = Vector2::new(
            B * sine * rates.y * rates.y - G * (M[0] * L[0] + M[1] * LONG) * first.cos(),
            -B * sine * rates.x * rates.x - G * M[1] * L[1] * second.cos(),
        );
        let across = B * cosine;
        let determinant = A * C - across * across;
        let a = (C * loads.x - across * loads.y) / determinant;
        let b = (A * loads.y - across * loads.x) / determinant;
        DoublePendulumAcceleration {
            shoulder: a,
            elbow: b - a,
        }
    }
}

/// A body with wheels: `(J - A) ω' = -τ - ω x h`, and its center about that of all.
pub struct Wheels {
    /// Of all about the center of all, wheels locked \[kg m²\].
    whole: Matrix3<f64>,
    /// The inverse of the same, wheels free about their axes.
    inverse: Matrix3<f64>,
    /// The center of all, from that of the hub \[m\].
    center: Vector3<f64>,
}

/// Of a wheel about its axis, and what drives them.
const AXIAL: f64 = 0.035;
const TORQUES: [f64; 3] = [0.05, -0.02, 0.03];

impl Wheels {
    pub fn new() -> Self {
        let (hub, wheel, arm) = (120.0, 4.0, 0.3);
        let center = Vector3::repeat(wheel * arm / (hub + 3.0 * wheel));
        let at = |place: Vector3<f64>| {
            Matrix3::from_diagonal_element(place.norm_squared()) - place * place.transpose()
        };
        let mut whole = Matrix3::from_diagonal(&Vector3::new(12.0, 14.0, 9.0)) + at(-center) * hub;
        for axis in [Vector3::x(), Vector3::y(), Vector3::z()] {
            let tensor = Vector3::repeat(0.02) + axis * (AXIAL - 0.02);
            whole += Matrix3::from_diagonal(&tensor) + at(axis * arm - center) * wheel;
        }
        let free = whole - Matrix3::from_diagonal_element(AXIAL);
        Self {
            whole,
            inverse: free.try_inverse().expect("a body with mass"),
            center,
        }
    }
}

impl RigidBody for Wheels {
    type Scalar = f64;
    type State = GyrostatState;
    type Input = ();

    #[inline(always)]
    fn acceleration(&self, _: f64, state: &GyrostatState, (): &()) -> GyrostatAcceleration {
        let w = state.orbit.angular_velocity;
        let spins = Vector3::new(
            state.spin_x.angular_velocity,
            state.spin_y.angular_velocity,
            state.spin_z.angular_velocity,
        );
        let torques = Vector3::from(TORQUES);
        let momentum = self.whole * w + spins * AXIAL;
        let angular = self.inverse * (-torques - w.cross(&momentum));
        let spun = torques / AXIAL - angular;
        let about = angular.cross(&self.center) + w.cross(&w.cross(&self.center));
        GyrostatAcceleration {
            orbit: SpatialAcceleration {
                linear: state.orbit.attitude * -about,
                angular,
            },
            spin_x: spun.x,
            spin_y: spun.y,
            spin_z: spun.z,
        }
    }
}
