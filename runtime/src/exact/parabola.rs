//! Constant acceleration.

use nalgebra::SVector;

use crate::bodies::path::Path;
use crate::state::{Hinge, PlanarTranslation, Translation};

/// A point under constant acceleration, in D coordinates: `x₀ + v₀ t + a t²/2`. One coordinate may
/// be an angle.
///
/// ```
/// use newton_euler::exact::Parabola;
/// use newton_euler::nalgebra::Vector2;
///
/// let thrown = Parabola {
///     position: Vector2::zeros(),
///     velocity: [3.0, 4.0].into(),
///     acceleration: [0.0, -10.0].into(),
/// };
/// assert_eq!(thrown.position_at(0.5), Vector2::new(1.5, 0.75));
/// assert_eq!(thrown.velocity_at(0.5), Vector2::new(3.0, -1.0));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parabola<const D: usize> {
    /// Position at time zero \[m\].
    pub position: SVector<f64, D>,
    /// Velocity at time zero \[m/s\].
    pub velocity: SVector<f64, D>,
    /// Acceleration \[m/s²\].
    pub acceleration: SVector<f64, D>,
}

impl<const D: usize> Parabola<D> {
    /// Position at a time.
    #[must_use]
    pub fn position_at(&self, time: f64) -> SVector<f64, D> {
        self.position + (self.velocity + self.acceleration * (0.5 * time)) * time
    }

    /// Velocity at a time.
    #[must_use]
    pub fn velocity_at(&self, time: f64) -> SVector<f64, D> {
        self.velocity + self.acceleration * time
    }
}

impl Path for Parabola<3> {
    type State = Translation;

    fn at(&self, time: f64) -> Translation {
        Translation {
            position: self.position_at(time),
            velocity: self.velocity_at(time),
        }
    }

    fn pace(&self, _time: f64) -> f64 {
        f64::INFINITY
    }
}

impl Path for Parabola<2> {
    type State = PlanarTranslation;

    fn at(&self, time: f64) -> PlanarTranslation {
        PlanarTranslation {
            position: self.position_at(time),
            velocity: self.velocity_at(time),
        }
    }

    fn pace(&self, _time: f64) -> f64 {
        f64::INFINITY
    }
}

impl Path for Parabola<1> {
    type State = Hinge;

    fn at(&self, time: f64) -> Hinge {
        Hinge {
            angle: self.position_at(time).x,
            angular_velocity: self.velocity_at(time).x,
        }
    }

    fn pace(&self, _time: f64) -> f64 {
        f64::INFINITY
    }
}
