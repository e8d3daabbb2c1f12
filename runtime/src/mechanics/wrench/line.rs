//! A line in space: where a force may act without changing its moment.

use nalgebra::{UnitVector3, Vector3};
#[cfg(feature = "serde")]
use serde::Serialize;

/// A straight line, by its point nearest to the pole and its direction.
///
/// ```
/// use newton_euler::nalgebra::Vector3;
/// use newton_euler::wrench::Line;
///
/// let line = Line { point: Vector3::new(2.0, 0.0, 0.0), direction: Vector3::z_axis() };
/// assert_eq!(line.at(3.0), Vector3::new(2.0, 0.0, 3.0));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(Serialize))]
pub struct Line {
    /// The point nearest to the pole, from the pole \[m\].
    pub point: Vector3<f64>,
    /// Unit vector along the line.
    pub direction: UnitVector3<f64>,
}

impl Line {
    /// The point at this distance along the line from the one nearest to the pole \[m\], from the
    /// pole.
    #[must_use]
    pub fn at(&self, distance: f64) -> Vector3<f64> {
        self.point + self.direction.scale(distance)
    }
}
