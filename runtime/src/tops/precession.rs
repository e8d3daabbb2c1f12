//! Steady precession: a body spins about its own axis while that axis rotates about one
//! fixed in space.
//!
//! Both rates are constant, and attitude and angular velocity are functions of time in closed form,
//!
//! ```text
//! q(t) = exp(n Ω t) q(0) exp(e₃ ψ̇ t)        ω(t) = Ω R(q(t))ᵀ n + ψ̇ e₃
//! ```
//!
//! with n the axis of precession in the world, Ω its rate, e₃ the body's third axis and ψ̇ the spin
//! relative to the precessing frame. For n = z and q(0) = `q_x(θ)` this is
//! `q_z(Ω t) q_x(θ) q_z(ψ̇ t)`. No angles are used, so coinciding axes are no special case.
//! Examples: [`top`](crate::top).

use nalgebra::{Quaternion, UnitQuaternion, UnitVector3, Vector3};

use crate::mechanics::attitude;
use crate::numbers::math;
use crate::numbers::twofold::Twofold;
use crate::state::Rotation;

/// A steady precession, as a function of time.
///
/// Phases are formed in twice the precision and reduced exactly. Their error stays near 1e-16 rad
/// however long the motion lasts, if the rates are exact.
///
/// ```
/// use core::f64::consts::TAU;
/// use newton_euler::nalgebra::{UnitQuaternion, Vector3};
/// use newton_euler::precession::Precession;
///
/// // The earth: precession (westward) in 25,772 years of 366.24 turns each.
/// let tilted = UnitQuaternion::from_axis_angle(&Vector3::x_axis(), 23.44_f64.to_radians());
/// let earth = Precession::new(tilted, Vector3::z_axis(), -TAU / 25_772.0, TAU * 366.24);
/// let half = earth.at(12_886.0).attitude * Vector3::z();
/// assert!(
///     (half - Vector3::new(0.0, 23.44_f64.to_radians().sin(), 23.44_f64.to_radians().cos()))
///         .norm()
///         < 1e-15
/// );
/// assert!((earth.tilt() - 23.44_f64.to_radians()).abs() < 1e-15);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Precession {
    start: UnitQuaternion<f64>,
    axis: Vector3<f64>,
    rate: Twofold,
    spin: Twofold,
}

impl Precession {
    /// From the attitude at time zero, the axis of precession in world axes, the rate about it and
    /// the spin about the body's third axis relative to the precessing frame \[rad/s\].
    ///
    /// ```
    /// use newton_euler::nalgebra::{UnitQuaternion, Vector3};
    /// use newton_euler::precession::Precession;
    ///
    /// let rolling = Precession::new(UnitQuaternion::identity(), Vector3::x_axis(), 2.0, 0.0);
    /// assert!((rolling.at(0.1).attitude.angle() - 0.2).abs() < 1e-15);
    /// ```
    #[must_use]
    pub fn new(start: UnitQuaternion<f64>, axis: UnitVector3<f64>, rate: f64, spin: f64) -> Self {
        Self::of(start, axis.into_inner(), rate.into(), spin.into())
    }

    /// The axis is a unit vector, or zero if the rate is zero.
    pub(crate) fn of(
        start: UnitQuaternion<f64>,
        axis: Vector3<f64>,
        rate: Twofold,
        spin: Twofold,
    ) -> Self {
        Self {
            start,
            axis,
            rate,
            spin,
        }
    }

    /// Attitude and angular velocity at a time \[s\].
    #[must_use]
    pub fn at(&self, time: f64) -> Rotation {
        let time = Twofold::from(time);
        let precessed = turn(&self.axis, self.rate * time);
        let spun = turn(&Vector3::z(), self.spin * time);
        let attitude = attitude::normalized(&(precessed * self.start.quaternion() * spun));
        let in_body = attitude.inverse_transform_vector(&self.axis);
        Rotation {
            attitude,
            angular_velocity: in_body * self.rate() + Vector3::z() * self.spin(),
        }
    }

    /// Ω, the rate of precession about [`Self::axis`] \[rad/s\].
    #[must_use]
    pub fn rate(&self) -> f64 {
        self.rate.value()
    }

    /// ψ̇, the spin about the body's third axis relative to the precessing frame \[rad/s\].
    ///
    /// Not the component of ω along that axis, which is [`Self::axial_rate`].
    #[must_use]
    pub fn spin(&self) -> f64 {
        self.spin.value()
    }

    /// `Ω₃ = ψ̇ + Ω cos θ`, the component of the angular velocity along the body's third axis
    /// \[rad/s\].
    #[must_use]
    pub fn axial_rate(&self) -> f64 {
        self.spin() + self.rate() * self.axis.dot(&self.third_axis())
    }

    /// The axis of precession, a unit vector in world axes; zero for a body without angular
    /// momentum.
    #[must_use]
    pub const fn axis(&self) -> Vector3<f64> {
        self.axis
    }

    /// θ, the angle between the axis of precession and the body's third axis, in \[0, π\] \[rad\].
    #[must_use]
    pub fn tilt(&self) -> f64 {
        let third = self.third_axis();
        math::atan2(self.axis.cross(&third).norm(), self.axis.dot(&third))
    }

    /// The body's third axis at time zero, in the world.
    fn third_axis(&self) -> Vector3<f64> {
        self.start * Vector3::z()
    }
}

/// The unit quaternion of a rotation by this angle about a unit vector.
fn turn(axis: &Vector3<f64>, angle: Twofold) -> Quaternion<f64> {
    let (sine, cosine) = angle.scaled(-1).sin_cos();
    Quaternion::from_parts(cosine, axis * sine)
}
