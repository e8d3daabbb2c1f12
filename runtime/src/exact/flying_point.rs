//! Points of flying bodies other than the center of mass.

use nalgebra::{SVector, Vector2, Vector3};

use super::Parabola;
use crate::bodies::path::Path;
use crate::numbers::math;
use crate::state::{Hinge, Planar, Rotation, Spatial};

/// A flying body, described by the motion of one of its points. The center of mass, at a fixed
/// offset c from the point, moves on a parabola.
///
/// ```
/// use newton_euler::exact::{FlyingPoint, FreeRotation, Path};
/// use newton_euler::prelude::*;
/// use newton_euler::nalgebra::Vector3;
///
/// // the grip of a hammer that turns about its center of mass, a meter away
/// let grip = Spatial {
///     velocity: -Vector3::y() * 2.0,
///     angular_velocity: Vector3::z() * 2.0,
///     ..Spatial::default()
/// };
/// let spun = Rotation { attitude: grip.attitude, angular_velocity: grip.angular_velocity };
/// let rotation = FreeRotation::steady(&spun);
/// let hammer = FlyingPoint::<_, 3>::new(Vector3::x(), Vector3::zeros(), rotation, &grip);
/// let half_a_turn = hammer.at(core::f64::consts::FRAC_PI_2);
/// assert!((half_a_turn.position - Vector3::x() * 2.0).norm() < 1e-15);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FlyingPoint<R, const D: usize> {
    /// The path of the center of mass, world axes.
    center: Parabola<D>,
    /// c, body axes.
    offset: SVector<f64, D>,
    rotation: R,
}

impl<R> FlyingPoint<R, 3> {
    /// From the offset of the center of mass, in body axes \[m\], its acceleration, in world axes
    /// \[m/s²\], the rotation of the body, and the state of the point at time zero.
    #[must_use]
    pub fn new(
        offset: Vector3<f64>,
        acceleration: Vector3<f64>,
        rotation: R,
        state: &Spatial,
    ) -> Self {
        let arm = state.attitude * offset;
        let swept = state.attitude * state.angular_velocity.cross(&offset);
        Self {
            center: Parabola {
                position: state.position + arm,
                velocity: state.velocity + swept,
                acceleration,
            },
            offset,
            rotation,
        }
    }
}

impl<R> FlyingPoint<R, 2> {
    /// The same in the plane.
    #[must_use]
    pub fn new(
        offset: Vector2<f64>,
        acceleration: Vector2<f64>,
        rotation: R,
        state: &Planar,
    ) -> Self {
        let arm = turned(state.angle, &offset);
        Self {
            center: Parabola {
                position: state.position + arm,
                velocity: state.velocity + across(&arm) * state.angular_velocity,
                acceleration,
            },
            offset,
            rotation,
        }
    }
}

impl<R: Path<State = Rotation>> Path for FlyingPoint<R, 3> {
    type State = Spatial;

    fn at(&self, time: f64) -> Spatial {
        let Rotation {
            attitude,
            angular_velocity,
        } = self.rotation.at(time);
        let swept = angular_velocity.cross(&self.offset);
        Spatial {
            position: self.center.position_at(time) - attitude * self.offset,
            attitude,
            velocity: self.center.velocity_at(time) - attitude * swept,
            angular_velocity,
        }
    }

    fn pace(&self, time: f64) -> f64 {
        self.rotation.pace(time)
    }
}

impl<R: Path<State = Hinge>> Path for FlyingPoint<R, 2> {
    type State = Planar;

    fn at(&self, time: f64) -> Planar {
        let Hinge {
            angle,
            angular_velocity,
        } = self.rotation.at(time);
        let arm = turned(angle, &self.offset);
        Planar {
            position: self.center.position_at(time) - arm,
            angle,
            velocity: self.center.velocity_at(time) - across(&arm) * angular_velocity,
            angular_velocity,
        }
    }

    fn pace(&self, time: f64) -> f64 {
        let rate = self.rotation.at(time).angular_velocity.abs();
        self.rotation.pace(time).min(1.0 / rate)
    }
}

fn turned(angle: f64, vector: &Vector2<f64>) -> Vector2<f64> {
    let (sine, cosine) = math::sin_cos(angle);
    Vector2::new(
        cosine * vector.x - sine * vector.y,
        sine * vector.x + cosine * vector.y,
    )
}

/// A quarter of a turn further.
fn across(vector: &Vector2<f64>) -> Vector2<f64> {
    Vector2::new(-vector.y, vector.x)
}
