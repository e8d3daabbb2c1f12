//! The heavy symmetric top (Lagrange's): fixed at a point of its axis, with its center of mass at
//! the distance l along the axis.
//!
//! It precesses steadily at the angle θ from the vertical and with the component Ω₃ of its angular
//! velocity along its axis (a constant of every motion) if the rate Ω about the vertical is a root
//! of
//!
//! ```text
//! I₁ cos θ Ω² - I₃ Ω₃ Ω + m g l = 0
//! ```
//!
//! the moment balance about the horizontal axis perpendicular to the top's, divided by sin
//! θ.

use nalgebra::Vector3;

use super::SymmetricTop;
use crate::mechanics::attitude;
use crate::numbers::math;
use crate::numbers::twofold::Twofold;
use crate::tops::precession::Precession;

/// A symmetric top under gravity with one point of its axis fixed.
///
/// ```
/// use newton_euler::top::{HeavyTop, SymmetricTop};
///
/// let top = HeavyTop::new(SymmetricTop::new(0.0021, 0.0009)?, 0.4 * 9.80665 * 0.06);
/// let steady = top.steady_rates(0.6, 180.0).unwrap();
/// assert!((steady.slow - 1.4761499098915609).abs() < 1e-14);
/// assert!((steady.fast.unwrap() - 91.992320066772870).abs() < 1e-13);
/// assert!(top.steady_rates(0.6, 44.0).is_none()); // too slow: it falls
/// # Ok::<(), newton_euler::inertia::InvalidInertia>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HeavyTop {
    about_pivot: SymmetricTop,
    torque: f64,
}

/// The two rates of steady precession of a heavy top for one angle and one Ω₃ \[rad/s\].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SteadyRates {
    /// The smaller in magnitude, for a fast top nearly `m g l/(I₃ Ω₃)`.
    pub slow: f64,
    /// The larger in magnitude, for a fast top nearly that of the free top, `I₃ Ω₃/(I₁ cos θ)`.
    /// It goes to infinity where the axis is level. None for |cos θ| ≤ 2.2e-16, which cannot be
    /// distinguished from level.
    pub fast: Option<f64>,
}

impl HeavyTop {
    /// The permitted negative value of the discriminant, relative to (I₃ Ω₃)²: Ω₃ =
    /// [`Self::least_axial_rate`] contributes four roundings of half a unit in the last place,
    /// twice each in the square, the terms of the equation four more. Such a top has a double root,
    /// accurate to the square root of this, 4e-8.
    pub const SLACK: f64 = 8.0 * f64::EPSILON;

    /// From the moments of inertia about the fixed point and m g l \[N m\], with l from there to
    /// the center of mass along the third axis: negative for a center below, zero for a
    /// free top.
    ///
    /// ```
    /// use newton_euler::top::{HeavyTop, SymmetricTop};
    ///
    /// let gyroscope = HeavyTop::new(SymmetricTop::new(0.0021, 0.0009)?, 0.0);
    /// assert_eq!(gyroscope.steady_rates(0.3, 50.0).unwrap().slow, 0.0);
    /// # Ok::<(), newton_euler::inertia::InvalidInertia>(())
    /// ```
    #[must_use]
    pub const fn new(about_pivot: SymmetricTop, torque: f64) -> Self {
        Self {
            about_pivot,
            torque,
        }
    }

    /// Both rates of steady precession at the angle θ from the vertical \[rad\], with Ω₃ \[rad/s\];
    /// for θ = 0 and θ = π, those of small cones about the vertical. The larger root is computed
    /// first and the smaller from their product, so that neither cancels.
    ///
    /// None if the top is too slow (|Ω₃| below [`Self::least_axial_rate`], to [`Self::SLACK`]), and
    /// for a top without spin and with its axis level.
    #[must_use]
    pub fn steady_rates(&self, tilt: f64, axial_rate: f64) -> Option<SteadyRates> {
        let cosine = math::sin_cos(tilt).1;
        let level = cosine.abs() <= f64::EPSILON;
        let a = Twofold::product(
            self.about_pivot.transverse(),
            if level { 0.0 } else { cosine },
        );
        let b = Twofold::product(self.about_pivot.axial(), axial_rate);
        let torque = Twofold::from(self.torque);

        let discriminant = b * b - (a * torque).scaled(2);
        if discriminant.value() < -Self::SLACK * (b * b).value() {
            return None;
        }
        let root = if discriminant.value() > 0.0 {
            discriminant.sqrt()
        } else {
            Twofold::default()
        };
        // half of b ± √.. of the same sign
        let larger = (b + if b.value() < 0.0 { -root } else { root }).scaled(-1);
        if larger.value() == 0.0 {
            // Ω₃ = 0 and no moment: rest at any angle
            let rest = SteadyRates {
                slow: 0.0,
                fast: (!level).then_some(0.0),
            };
            return (self.torque == 0.0).then_some(rest);
        }
        Some(SteadyRates {
            slow: (torque / larger).value(),
            fast: (!level).then(|| (larger / a).value()),
        })
    }

    /// The motion of a top that precesses at this rate, with θ and Ω₃ as in [`Self::steady_rates`],
    /// about a vertical along world z, against gravity. At time zero it is rotated from the world's
    /// axes by θ about x.
    ///
    /// Only rates from [`Self::steady_rates`] give the motion of a top left alone.
    ///
    /// ```
    /// use newton_euler::top::{HeavyTop, SymmetricTop};
    ///
    /// let top = HeavyTop::new(SymmetricTop::new(0.0021, 0.0009)?, 0.4 * 9.80665 * 0.06);
    /// let slow = top.steady_rates(0.6, 180.0).unwrap().slow;
    /// let motion = top.steady(0.6, 180.0, slow);
    /// assert!((motion.at(7.0).angular_velocity.z - 180.0).abs() < 1e-13);
    /// # Ok::<(), newton_euler::inertia::InvalidInertia>(())
    /// ```
    #[must_use]
    pub fn steady(&self, tilt: f64, axial_rate: f64, rate: f64) -> Precession {
        let tilted = attitude::exp(&(Vector3::x() * tilt));
        let along = Twofold::product(rate, math::sin_cos(tilt).1);
        let spin = Twofold::from(axial_rate) - along;
        Precession::of(tilted, Vector3::z(), rate.into(), spin)
    }

    /// The least |Ω₃| of steady precession at the angle θ from the vertical \[rad\]:
    /// `2 √(I₁ cos θ m g l)/I₃` \[rad/s\]; zero if the center of mass is not above the fixed point,
    /// where there is precession at every Ω₃.
    ///
    /// ```
    /// use newton_euler::top::{HeavyTop, SymmetricTop};
    ///
    /// let top = HeavyTop::new(SymmetricTop::new(0.0021, 0.0009)?, 0.4 * 9.80665 * 0.06);
    /// assert!((top.least_axial_rate(0.6) - 44.882639080924712).abs() < 1e-13);
    /// # Ok::<(), newton_euler::inertia::InvalidInertia>(())
    /// ```
    #[must_use]
    pub fn least_axial_rate(&self, tilt: f64) -> f64 {
        self.threshold(math::sin_cos(tilt).1)
    }

    /// The |Ω₃| above which the upright top sleeps: its axis stays vertical, and returns if
    /// disturbed: `2 √(I₁ m g l)/I₃` \[rad/s\]. Zero for a center of mass below the fixed point (l
    /// < 0), which needs no spin.
    /// ```
    /// use newton_euler::top::{HeavyTop, SymmetricTop};
    ///
    /// let top = HeavyTop::new(SymmetricTop::new(0.0021, 0.0009)?, 0.4 * 9.80665 * 0.06);
    /// assert!((top.sleeping_axial_rate() - 49.404111389865340).abs() < 1e-13);
    /// # Ok::<(), newton_euler::inertia::InvalidInertia>(())
    /// ```
    #[must_use]
    pub fn sleeping_axial_rate(&self) -> f64 {
        self.threshold(1.0)
    }

    /// The |Ω₃| at which the discriminant vanishes.
    fn threshold(&self, cosine: f64) -> f64 {
        let product = self.about_pivot.transverse() * cosine * self.torque;
        2.0 * math::sqrt(product.max(0.0)) / self.about_pivot.axial()
    }
}
