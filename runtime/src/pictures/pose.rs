//! Where a body is.

use nalgebra::{UnitQuaternion, Vector3};

use crate::state::{Planar, PlanarTranslation, Rod, Rotation, Spatial, Translation};

/// The place of a body and its attitude.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose {
    /// World axes \[m\].
    pub position: Vector3<f64>,
    /// From body axes to world axes.
    pub attitude: UnitQuaternion<f64>,
}

impl Pose {
    /// In the plane: a position \[m\], and an angle \[rad\].
    #[must_use]
    pub fn planar([x, y]: [f64; 2], angle: f64) -> Self {
        Self {
            position: Vector3::new(x, y, 0.0),
            attitude: UnitQuaternion::from_axis_angle(&Vector3::z_axis(), angle),
        }
    }

    /// Whether all numbers are finite.
    pub(super) fn is_finite(&self) -> bool {
        let coords = self.attitude.coords.iter();
        let mut numbers = self.position.iter().chain(coords);
        numbers.all(|number| number.is_finite())
    }
}

/// A state that contains the place of the body. The state of a hinge does not: its axis and its
/// place are in the description.
pub trait Posed {
    /// Whether the body stays in the x-y plane.
    const IS_PLANAR: bool;

    /// The pose of the body. G is at the origin if the state has no position.
    fn pose(&self) -> Pose;
}

impl Posed for Spatial {
    const IS_PLANAR: bool = false;

    fn pose(&self) -> Pose {
        Pose {
            position: self.position,
            attitude: self.attitude,
        }
    }
}

impl Posed for Rotation {
    const IS_PLANAR: bool = false;

    fn pose(&self) -> Pose {
        Pose {
            position: Vector3::zeros(),
            attitude: self.attitude,
        }
    }
}

impl Posed for Translation {
    const IS_PLANAR: bool = false;

    fn pose(&self) -> Pose {
        Pose {
            position: self.position,
            attitude: UnitQuaternion::identity(),
        }
    }
}

impl Posed for Planar {
    const IS_PLANAR: bool = true;

    fn pose(&self) -> Pose {
        Pose::planar(self.position.into(), self.angle)
    }
}

impl Posed for PlanarTranslation {
    const IS_PLANAR: bool = true;

    fn pose(&self) -> Pose {
        Pose::planar(self.position.into(), 0.0)
    }
}

/// The rod lies along z.
impl Posed for Rod {
    const IS_PLANAR: bool = false;

    fn pose(&self) -> Pose {
        let turn = UnitQuaternion::rotation_between(&Vector3::z(), &self.axis);
        let upside_down =
            UnitQuaternion::from_axis_angle(&Vector3::x_axis(), core::f64::consts::PI);
        Pose {
            position: self.position,
            attitude: turn.unwrap_or(upside_down),
        }
    }
}
