//! Coordinates of a joint under constant acceleration.

use crate::bodies::path::Path;
use crate::state::Coordinates;

/// A joint whose coordinates are lengths and angles, each under a constant acceleration:
/// `x₀ + v₀ t + a t²/2`.
///
/// ```
/// use newton_euler::exact::{Accelerated, Path};
/// use newton_euler::prelude::*;
///
/// let piston = Cylinder { position: 0.5, angular_velocity: 2.0, ..Cylinder::default() };
/// let path = Accelerated {
///     start: piston,
///     acceleration: CylinderAcceleration { linear: -1.0, angular: 0.0 },
/// };
/// let later = path.at(0.5);
/// assert_eq!((later.position, later.velocity), (0.375, -0.5));
/// assert_eq!((later.angle, later.angular_velocity), (1.0, 2.0));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Accelerated<S: Coordinates<Scalar = f64>> {
    /// The state at time zero, which has no attitude and no axis.
    pub start: S,
    /// Its acceleration.
    pub acceleration: S::Acceleration,
}

impl<S: Coordinates<Scalar = f64>> Path for Accelerated<S> {
    type State = S;

    fn at(&self, time: f64) -> S {
        let mut list = self.start.coordinates();
        let rates = self.start.rates(&self.acceleration);
        let half = rates.as_ref().len() / 2;
        let (velocities, accelerations) = rates.as_ref().split_at_checked(half).unwrap_or_default();
        let halves = list.as_mut().split_at_mut_checked(half);
        let (positions, speeds) = halves.unwrap_or_default();
        for (((x, speed), v), a) in positions
            .iter_mut()
            .zip(speeds)
            .zip(velocities)
            .zip(accelerations)
        {
            *x += (v + a * (0.5 * time)) * time;
            *speed += a * time;
        }
        S::from_coordinates(&list)
    }

    fn pace(&self, _time: f64) -> f64 {
        f64::INFINITY
    }
}
