//! The plane pendulum.

use core::f64::consts::{PI, TAU};

use super::Path;
use super::jacobi::{Elliptic, Jacobi};
use super::phase::Phase;
use crate::private::math;
use crate::state::Hinge;
use crate::twofold::Twofold;

/// A body that turns about a fixed axis under its weight: `θ'' = -Ω² sin(θ - θ₀)`, at any amplitude.
///
/// With φ = θ - θ₀, it swings or it goes round, by which of `cos(φ/2)` and `|φ'|/2Ω` is the larger:
///
/// ```text
/// swings        sin(φ/2) = k sn(Ω t + u₀, k)      φ' = 2 k Ω cn        k'² = cos²(φ/2) - φ'²/4Ω²
/// goes round    φ/2 = am(k Ω t + u₀, 1/k)         φ' = 2 k Ω dn        k² = sin²(φ/2) + φ'²/4Ω²
/// ```
///
/// k' is written as a product, and keeps its digits near the separatrix between the two. The angle is not wrapped.
///
/// ```
/// use newton_euler::exact::{Path, Pendulum};
/// use newton_euler::prelude::*;
///
/// // half a period from 90 degrees: K(1/√2) = 1.8540746773013719
/// let swing = Pendulum::new(2.0, 0.0, &Hinge { angle: core::f64::consts::FRAC_PI_2, angular_velocity: 0.0 });
/// assert!((swing.at(1.854_074_677_301_371_9).angle + core::f64::consts::FRAC_PI_2).abs() < 1e-15);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pendulum {
    /// θ₀ and what was wrapped.
    center: Twofold,
    /// `k Ω` \[rad/s\]
    rate: f64,
    course: Course,
    phase: Phase,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Course {
    /// k
    Swings(f64),
    /// 1 or -1
    GoesRound(f64),
}

impl Pendulum {
    /// From the rate Ω of small oscillations \[rad/s\], the angle θ₀ at which it hangs at rest, and the state at time zero.
    #[must_use]
    pub fn new(rate: f64, hanging: f64, state: &Hinge) -> Self {
        let turns = math::floor((state.angle - hanging) / TAU + 0.5);
        let center = Twofold::from(hanging) + Twofold::product(TAU, turns);
        let from_hanging = (Twofold::from(state.angle) - center).value();
        let (sine, cosine) = math::sin_cos(0.5 * from_hanging);
        let [height, speed] = [rate * cosine, 0.5 * state.angular_velocity];
        let total = math::hypot(rate * sine, speed); // k Ω
        let apart = math::sqrt((height - speed.abs()).abs()) * math::sqrt(height + speed.abs());
        let over = |part: f64, whole: f64, rest: f64| if whole > 0.0 { part / whole } else { rest };
        let (course, phase) = if height > speed.abs() {
            let start = Elliptic {
                sn: over(rate * sine, total, 0.0),
                cn: over(speed, total, 1.0),
                dn: cosine,
            };
            let jacobi = Jacobi::new(f64::min(1.0, apart / rate));
            (
                Course::Swings(total / rate),
                Phase::new(jacobi, start, rate),
            )
        } else {
            let direction = f64::copysign(1.0, speed);
            let start = Elliptic {
                sn: direction * sine,
                cn: cosine,
                dn: over(speed.abs(), total, 1.0),
            };
            let jacobi = Jacobi::new(f64::min(1.0, over(apart, total, 1.0)));
            let phase = Phase::new(jacobi, start, total);
            (Course::GoesRound(direction), phase)
        };
        Self {
            center,
            rate: total,
            course,
            phase,
        }
    }

    /// The time of a swing to and fro, or of a turn \[s\]; infinite on the separatrix.
    ///
    /// ```
    /// # use newton_euler::exact::Pendulum;
    /// # use newton_euler::prelude::*;
    /// let small = Pendulum::new(2.0, 0.0, &Hinge { angle: 1e-9, angular_velocity: 0.0 });
    /// assert!((small.period() - core::f64::consts::PI).abs() < 1e-15);
    /// ```
    #[must_use]
    pub fn period(&self) -> f64 {
        let angle = match self.course {
            Course::Swings(_) => TAU,
            Course::GoesRound(_) => PI,
        };
        if self.phase.jacobi.is_hyperbolic() {
            f64::INFINITY
        } else {
            angle / self.phase.rate
        }
    }
}

impl Path for Pendulum {
    type State = Hinge;

    fn at(&self, time: f64) -> Hinge {
        let reading = self.phase.at(time);
        let (turned, speed) = match self.course {
            Course::Swings(modulus) => {
                let Elliptic { sn, cn, dn } = reading.elliptic();
                (Twofold::from(2.0 * math::atan2(modulus * sn, dn)), cn)
            }
            Course::GoesRound(direction) => {
                let turned = Twofold::from(2.0 * direction * reading.amplitude());
                (turned, direction * reading.sum.dn)
            }
        };
        Hinge {
            angle: (self.center + turned).value(),
            angular_velocity: 2.0 * self.rate * speed,
        }
    }

    fn pace(&self, _time: f64) -> f64 {
        1.0 / self.phase.rate.max(2.0 * self.rate)
    }
}
