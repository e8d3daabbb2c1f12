//! A wheel on a body that swings.

use crate::bodies::path::Path;
use crate::exact::{Accelerated, Pendulum};
use crate::state::Hinge;

/// A hinge on a pendulum, with a constant moment on the pendulum. Their combined angle has a
/// constant acceleration, as for a wheel that keeps its attitude.
///
/// ```
/// use newton_euler::exact::{Accelerated, CounterSwing, Path, Pendulum};
/// use newton_euler::prelude::*;
///
/// let bob = Hinge { angle: 0.5, ..Hinge::default() };
/// let swing = Pendulum::new(2.0, 0.0, &bob);
/// let wheel = CounterSwing {
///     total: Accelerated { start: bob, acceleration: 0.0 },
///     swing,
///     sign: 1.0,
/// };
/// assert_eq!(wheel.at(0.7).angle + swing.at(0.7).angle, 0.5);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CounterSwing {
    /// The angle of the hinge, plus `sign` times that of the pendulum.
    pub total: Accelerated<Hinge>,
    /// The pendulum.
    pub swing: Pendulum,
    /// 1 if both rotate about the same direction, -1 if about opposite ones.
    pub sign: f64,
}

impl CounterSwing {
    /// From the states of the hinge and of the pendulum at time zero, and the constant acceleration
    /// of both angles together.
    #[must_use]
    pub fn new(hinge: &Hinge, (swing, start): (Pendulum, &Hinge), sign: f64, total: f64) -> Self {
        let start = Hinge {
            angle: hinge.angle + sign * start.angle,
            angular_velocity: hinge.angular_velocity + sign * start.angular_velocity,
        };
        Self {
            total: Accelerated {
                start,
                acceleration: total,
            },
            swing,
            sign,
        }
    }
}

impl Path for CounterSwing {
    type State = Hinge;

    fn at(&self, time: f64) -> Hinge {
        let (total, swing) = (self.total.at(time), self.swing.at(time));
        Hinge {
            angle: total.angle - self.sign * swing.angle,
            angular_velocity: total.angular_velocity - self.sign * swing.angular_velocity,
        }
    }

    fn pace(&self, time: f64) -> f64 {
        self.swing.pace(time)
    }
}
