//! The free rotation of a rod.

use nalgebra::{Unit, UnitVector3, Vector3};

use crate::numbers::scale;
use crate::numbers::twofold::Twofold;

/// The axis of a rod without a moment: it rotates along a great circle at the constant
/// rate |u̇|.
///
/// ```text
/// u(t) = u cos |u̇| t + u̇/|u̇| sin |u̇| t
/// ```
///
/// ```
/// use newton_euler::exact::GreatCircle;
/// use newton_euler::nalgebra::Vector3;
///
/// let circle = GreatCircle::new(Vector3::x_axis(), Vector3::new(0.0, 2.0, 0.0));
/// let (axis, rate) = circle.at(core::f64::consts::FRAC_PI_4);
/// assert!((axis.into_inner() - Vector3::y()).norm() < 1e-15);
/// assert!((rate + Vector3::x() * 2.0).norm() < 1e-15);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GreatCircle {
    axis: Vector3<f64>,
    /// Unit vector of u̇; zero at rest.
    across: Vector3<f64>,
    /// |u̇|
    rate: Twofold,
}

impl GreatCircle {
    /// From the axis at time zero and its rate \[1/s\]; only the part perpendicular to the axis
    /// counts.
    #[must_use]
    pub fn new(axis: UnitVector3<f64>, axis_rate: Vector3<f64>) -> Self {
        let axis = axis.into_inner();
        let exponent = scale::exponent(axis_rate.amax());
        let rate = scale::scaled(&axis_rate, -exponent);
        let across = rate - axis * axis.dot(&rate);
        let square = |part: f64| Twofold::product(part, part);
        let length = (square(across.x) + square(across.y) + square(across.z)).sqrt();
        let is_moving = length.value() > 0.0;
        Self {
            axis,
            across: if is_moving {
                across / length.value()
            } else {
                across
            },
            rate: length.scaled(exponent),
        }
    }

    /// The axis and its rate at a time.
    #[must_use]
    pub fn at(&self, time: f64) -> (UnitVector3<f64>, Vector3<f64>) {
        let (sine, cosine) = (self.rate * Twofold::from(time)).sin_cos();
        let axis = self.axis * cosine + self.across * sine;
        let axis = axis * (0.5 * (3.0 - axis.norm_squared()));
        let direction = self.across * cosine - self.axis * sine;
        (Unit::new_unchecked(axis), direction * self.rate.value())
    }

    /// The same as [`Path::pace`](super::Path::pace).
    #[must_use]
    pub fn pace(&self) -> f64 {
        1.0 / self.rate.value()
    }
}
