//! The plane pendulum.

use core::f64::consts::{FRAC_PI_2, PI, TAU};

use crate::bodies::path::Path;
use crate::exact::elliptic::jacobi::{Elliptic, Jacobi};
use crate::exact::elliptic::phase::Phase;
use crate::numbers::math;
use crate::numbers::twofold::Twofold;
use crate::state::Hinge;

/// π/2 minus the nearest double.
const QUARTER_REST: f64 = 6.123_233_995_736_766e-17;

/// A cosine of half the angle. Below it, near upright, tilts are measured from upright, so they
/// keep their digits.
const NEAR: f64 = 1e-5;

/// A cosine of half the angle: squares of larger ones do not underflow.
const LEAST: f64 = 1e-150;

/// A body that rotates about a fixed axis under its weight: `θ'' = -Ω² sin(θ - θ₀)`, at any
/// amplitude.
///
/// With φ = θ - θ₀, it swings or rotates, depending on which of `cos(φ/2)` and `|φ'|/2Ω` is larger:
///
/// ```text
/// swings        sin(φ/2) = k sn(Ω t + u₀, k)      φ' = 2 k Ω cn        k'² = cos²(φ/2) - φ'²/4Ω²
/// goes round    φ/2 = am(k Ω t + u₀, 1/k)         φ' = 2 k Ω dn        k² = sin²(φ/2) + φ'²/4Ω²
/// ```
///
/// k' is written as a product, and keeps its digits near the separatrix between the two. The angle
/// is not wrapped. Near upright it has the digits of the remaining tilt; a pendulum at rest with a
/// tilt below 1e-150 stays upright. If θ₀ is the double nearest to a multiple of a quarter turn, it
/// is taken as that multiple.
///
/// ```
/// use newton_euler::exact::{Path, Pendulum};
/// use newton_euler::prelude::*;
///
/// // half a period from 90 degrees: K(1/√2) = 1.8540746773013719
/// let swing = Pendulum::new(
///     2.0,
///     0.0,
///     &Hinge { angle: core::f64::consts::FRAC_PI_2, angular_velocity: 0.0 },
/// );
/// assert!((swing.at(1.854_074_677_301_371_9).angle + core::f64::consts::FRAC_PI_2).abs() < 1e-15);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pendulum {
    /// θ₀
    hanging: Twofold,
    /// The number of half turns that were removed.
    wrapped: f64,
    /// θ₀ and these.
    center: Twofold,
    /// `k Ω` \[rad/s\]
    rate: f64,
    course: Case,
    phase: Phase,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Case {
    /// k
    Swings(f64),
    /// 1 or -1
    GoesRound(f64),
}

impl Pendulum {
    /// From the rate Ω of small oscillations \[rad/s\], the equilibrium angle θ₀, and
    /// the state at time zero.
    #[must_use]
    pub fn new(rate: f64, hanging: f64, state: &Hinge) -> Self {
        let mut wrapped = 2.0 * math::floor((state.angle - hanging) / TAU + 0.5);
        let hanging = exact(hanging);
        let half_from = |wrapped: f64| {
            let angle = Twofold::from(state.angle) - (hanging + half_turns(wrapped));
            angle.scaled(-1).sin_cos()
        };
        let (mut sine, mut cosine) = half_from(wrapped);
        if cosine < NEAR {
            // measured from upright; rounding may have moved whole turns to the other side
            let side = f64::copysign(1.0, sine);
            let (tilt, upright) = half_from(wrapped + side);
            (sine, cosine) = (side * upright, -side * tilt);
            if cosine < 0.0 {
                wrapped += 2.0 * side;
                (sine, cosine) = (-sine, -cosine);
            }
        }
        let [mut height, mut speed] = [rate * cosine, 0.5 * state.angular_velocity];
        if f64::max(height, speed.abs()) < rate * LEAST {
            [cosine, height, speed] = [0.0; 3];
        }
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
            (Case::Swings(total / rate), Phase::new(jacobi, start, rate))
        } else {
            let direction = f64::copysign(1.0, speed);
            let start = Elliptic {
                sn: direction * sine,
                cn: cosine,
                dn: over(speed.abs(), total, 1.0),
            };
            let jacobi = Jacobi::new(f64::min(1.0, over(apart, total, 1.0)));
            let phase = Phase::new(jacobi, start, total);
            (Case::GoesRound(direction), phase)
        };
        Self {
            hanging,
            wrapped,
            center: hanging + half_turns(wrapped),
            rate: total,
            course,
            phase,
        }
    }

    /// The period of a full swing or of a rotation \[s\]; infinite on the separatrix.
    ///
    /// ```
    /// use newton_euler::exact::Pendulum;
    /// use newton_euler::prelude::*;
    ///
    /// let small = Pendulum::new(2.0, 0.0, &Hinge { angle: 1e-9, angular_velocity: 0.0 });
    /// assert!((small.period() - core::f64::consts::PI).abs() < 1e-15);
    /// ```
    #[must_use]
    pub fn period(&self) -> f64 {
        let angle = match self.course {
            Case::Swings(_) => TAU,
            Case::GoesRound(_) => PI,
        };
        if self.phase.jacobi.is_hyperbolic() {
            f64::INFINITY
        } else {
            angle / self.phase.rate
        }
    }
}

/// A number of half turns \[rad\].
fn half_turns(number: f64) -> Twofold {
    Twofold::product(PI, number) + Twofold::from(2.0 * QUARTER_REST * number)
}

/// An angle; the doubles nearest to quarter turns count as quarter turns.
#[expect(clippy::float_cmp, reason = "one double stands for a quarter turn")]
fn exact(angle: f64) -> Twofold {
    let quarters = math::floor(angle / FRAC_PI_2 + 0.5);
    if angle == quarters * FRAC_PI_2 {
        Twofold::product(FRAC_PI_2, quarters) + Twofold::from(QUARTER_REST * quarters)
    } else {
        Twofold::from(angle)
    }
}

impl Path for Pendulum {
    type State = Hinge;

    fn at(&self, time: f64) -> Hinge {
        let reading = self.phase.at(time);
        // φ as it comes, the sine and cosine of half of it, up to a common sign
        let (turned, [sine, cosine], speed) = match self.course {
            Case::Swings(modulus) => {
                let Elliptic { sn, cn, dn } = reading.elliptic();
                let sine = modulus * sn;
                (2.0 * math::atan2(sine, dn), [sine, dn], cn)
            }
            Case::GoesRound(direction) => {
                let Elliptic { sn, cn, dn } = reading.sum;
                let turned = 2.0 * direction * reading.amplitude();
                (turned, [direction * sn, cn], direction * dn)
            }
        };
        let (center, turned) = if cosine.abs() < NEAR {
            let upright = math::floor(turned / PI + 0.5);
            let from_upright = -2.0 * math::atan(cosine / sine);
            (
                self.hanging + half_turns(self.wrapped + upright),
                from_upright,
            )
        } else {
            (self.center, turned)
        };
        Hinge {
            angle: (center + Twofold::from(turned)).value(),
            angular_velocity: 2.0 * self.rate * speed,
        }
    }

    fn pace(&self, _time: f64) -> f64 {
        1.0 / self.phase.rate.max(2.0 * self.rate)
    }
}
