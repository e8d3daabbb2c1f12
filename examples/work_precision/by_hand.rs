//! The same bodies, their accelerations written by hand: what the peers integrate.

use nalgebra::{UnitQuaternion, Vector3};
use newton_euler::prelude::*;

/// A body of principal axes that turns under a load.
#[derive(Clone, Copy)]
pub struct Turning<L> {
    /// Principal moments of inertia \[kg m²\].
    pub moments: Vector3<f64>,
    pub load: L,
}

/// What turns a body: a moment that its attitude determines.
pub trait Load {
    /// \[N m\], body axes.
    fn moment(&self, attitude: &UnitQuaternion<f64>) -> Vector3<f64>;
}

/// No load.
#[derive(Clone, Copy)]
pub struct Free;

impl Load for Free {
    #[inline(always)]
    fn moment(&self, _: &UnitQuaternion<f64>) -> Vector3<f64> {
        Vector3::zeros()
    }
}

/// Weight, times where it acts: from the support, body axes \[N m\].
#[derive(Clone, Copy)]
pub struct Weight(pub Vector3<f64>);

impl Load for Weight {
    #[inline(always)]
    fn moment(&self, attitude: &UnitQuaternion<f64>) -> Vector3<f64> {
        let [x, y, z, w] = attitude.coords.into();
        // the vertical in body axes: the last row of the rotation
        let up = Vector3::new(
            2.0 * (x * z - w * y),
            2.0 * (y * z + w * x),
            1.0 - 2.0 * (x * x + y * y),
        );
        up.cross(&self.0)
    }
}

/// `ω' = J⁻¹ (M - ω x J ω)`
#[inline(always)]
fn euler(moments: &Vector3<f64>, moment: &Vector3<f64>, w: &Vector3<f64>) -> Vector3<f64> {
    (moment - w.cross(&moments.component_mul(w))).component_div(moments)
}

impl<L: Load> RigidBody for Turning<L> {
    type Scalar = f64;
    type State = Rotation;
    type Input = ();

    #[inline(always)]
    fn acceleration(&self, _: f64, state: &Rotation, (): &()) -> Vector3<f64> {
        let moment = self.load.moment(&state.attitude);
        euler(&self.moments, &moment, &state.angular_velocity)
    }
}

/// The pendulum: `θ'' = -40/3 sin θ`.
pub struct Pendulum;

impl RigidBody for Pendulum {
    type Scalar = f64;
    type State = Hinge;
    type Input = ();

    #[inline(always)]
    fn acceleration(&self, _: f64, state: &Hinge, (): &()) -> f64 {
        -(40.0 / 3.0) * state.angle.sin()
    }
}

/// The quadrotor.
pub struct Quadrotor;

impl RigidBody for Quadrotor {
    type Scalar = f64;
    type State = Spatial;
    type Input = ();

    #[inline(always)]
    fn acceleration(&self, _: f64, state: &Spatial, (): &()) -> SpatialAcceleration {
        const MASS: f64 = 1.2;
        const ARM: f64 = 0.17;
        let [front, left, back, right] = [3.1, 2.9, 3.0, 3.2];
        let lift = Vector3::z() * (front + left + back + right);
        let drag = state.velocity * (-0.08 * state.velocity.norm());
        let rotors = Vector3::new(
            ARM * (left - right),
            ARM * (back - front),
            0.016 * (front - left + back - right),
        );
        let moment = rotors - state.angular_velocity * 0.01;
        SpatialAcceleration {
            linear: (state.attitude * lift + drag) / MASS - Vector3::z() * 9.80665,
            angular: euler(
                &Vector3::new(0.0123, 0.0117, 0.0224),
                &moment,
                &state.angular_velocity,
            ),
        }
    }
}

/// The satellite.
pub struct Satellite;

impl RigidBody for Satellite {
    type Scalar = f64;
    type State = Spatial;
    type Input = ();

    #[inline(always)]
    fn acceleration(&self, _: f64, state: &Spatial, (): &()) -> SpatialAcceleration {
        const MU: f64 = 3.986_004_418e14;
        const MASS: f64 = 500.0;
        let moments = Vector3::new(120.0, 150.0, 90.0);
        let position = &state.position;
        let square = position.norm_squared();
        let cube = square * square.sqrt();
        let (gravity, fifth) = (MU / cube, MU / (cube * square));
        // along the position in body axes, and the moments of inertia on it
        let n = state.attitude.inverse_transform_vector(position);
        let turned = moments.component_mul(&n);
        let radial = fifth * (7.5 * n.dot(&turned) / square - 1.5 * moments.sum());
        let uneven = state.attitude * turned * (3.0 * fifth);
        SpatialAcceleration {
            linear: position * (radial / MASS - gravity) - uneven / MASS,
            angular: euler(
                &moments,
                &(n.cross(&turned) * (3.0 * fifth)),
                &state.angular_velocity,
            ),
        }
    }
}
