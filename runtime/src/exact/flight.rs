//! Bodies whose translation and rotation are independent.

use super::{GreatCircle, Parabola};
use crate::bodies::path::Path;
use crate::state::{Hinge, Planar, Rod, Rotation, Spatial};

/// A parabola of G and a rotation.
///
/// ```
/// use newton_euler::exact::{Flight, FreeRotation, Parabola, Path};
/// use newton_euler::prelude::*;
/// use newton_euler::nalgebra::Vector3;
///
/// let thrown = Rotation { angular_velocity: Vector3::new(0.0, 0.0, 2.0), ..Rotation::default() };
/// let ball = Flight {
///     center: Parabola {
///         position: Vector3::zeros(),
///         velocity: Vector3::x(),
///         acceleration: Vector3::z() * -9.80665,
///     },
///     rotation: FreeRotation::steady(&thrown),
/// };
/// let later: Spatial = ball.at(0.5);
/// assert_eq!(later.position.x, 0.5);
/// assert!((later.attitude.angle() - 1.0).abs() < 1e-15);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Flight<R, const D: usize> {
    /// The motion of G, world axes.
    pub center: Parabola<D>,
    /// A [`FreeRotation`](super::FreeRotation), a [`LagrangeTop`](super::LagrangeTop) or an
    /// [`AxialTorque`](super::AxialTorque), for a rod a [`GreatCircle`], in the plane a path of the
    /// angle: a [`Parabola`] or a [`Pendulum`](super::Pendulum).
    pub rotation: R,
}

impl<R: Path<State = Rotation>> Path for Flight<R, 3> {
    type State = Spatial;

    fn at(&self, time: f64) -> Spatial {
        let Rotation {
            attitude,
            angular_velocity,
        } = self.rotation.at(time);
        Spatial {
            position: self.center.position_at(time),
            attitude,
            velocity: self.center.velocity_at(time),
            angular_velocity,
        }
    }

    fn pace(&self, time: f64) -> f64 {
        self.rotation.pace(time)
    }
}

impl<R: Path<State = Hinge>> Path for Flight<R, 2> {
    type State = Planar;

    fn at(&self, time: f64) -> Planar {
        let Hinge {
            angle,
            angular_velocity,
        } = self.rotation.at(time);
        Planar {
            position: self.center.position_at(time),
            angle,
            velocity: self.center.velocity_at(time),
            angular_velocity,
        }
    }

    fn pace(&self, time: f64) -> f64 {
        self.rotation.pace(time)
    }
}

impl Path for Flight<GreatCircle, 3> {
    type State = Rod;

    fn at(&self, time: f64) -> Rod {
        let (axis, axis_rate) = self.rotation.at(time);
        Rod {
            position: self.center.position_at(time),
            velocity: self.center.velocity_at(time),
            axis,
            axis_rate,
        }
    }

    fn pace(&self, _time: f64) -> f64 {
        self.rotation.pace()
    }
}
