//! A symmetric body under a constant couple along its axis.

use nalgebra::{Quaternion, UnitVector3, Vector3};

use super::FreeRotation;
use crate::bodies::path::Path;
use crate::mechanics::attitude;
use crate::numbers::math;
use crate::numbers::scale;
use crate::numbers::twofold::Twofold;
use crate::state::Rotation;

mod passage;
mod reversal;
mod sweep;
mod wobble;

use passage::Passage;
use sweep::Sweep;

/// A body that is symmetric about an axis e, under a constant couple N e that rotates with it: for
/// example a stage that spins up, or one that spins down and then reverses.
///
/// With the moments A across the axis and C about it, the rate of spin is linear in time,
/// `r = r₀ + N t/C`. The angular velocity across the axis keeps its length w, and turns in the body
/// by an angle that is quadratic in time. With θ the angle of spin, `∫ r dt`, and a the direction
/// of that angular velocity at time zero,
///
/// ```text
/// q(t) = q(0) P(t) exp(κ θ e/2)      P' = P (w a + u e)/2      κ = 1 - C/A
/// u = r C/A = u₀ + b t               b = N/A
/// ```
///
/// where `w a + u e` is L/A, seen from axes that follow e and the angular velocity across it. The
/// parameters of Cayley and Klein of P are functions of the parabolic cylinder,
/// `α'' + (λ² - 2 i b) α/4 = 0` with `λ² = w² + u²`: M. Romano, Celestial Mechanics and Dynamical
/// Astronomy 101 (2008) 375; for a spherical body 100 (2008) 181. If λ² is above `81 b`, they are
/// computed by an expansion in `b/λ²`, whose first term is precession about L. Below that, while
/// the spin reverses, Taylor series are used, from points that are set up with the path. A torque
/// that tends to zero therefore leaves steady precession, and the cost of an evaluation is bounded
/// at all times: about that of a [`LagrangeTop`](super::LagrangeTop). The setup costs a dozen
/// evaluations, or two or three if w² is above `81 b`.
///
/// The error of the attitude is within 4e-15 plus one rounding per radian turned; the sign of
/// the quaternion is continuous in time.
///
/// ```
/// use newton_euler::exact::{AxialTorque, Path};
/// use newton_euler::prelude::*;
/// use newton_euler::nalgebra::Vector3;
///
/// // a stage that is spun up: its wobble decreases relative to its spin
/// let start = Rotation { angular_velocity: Vector3::new(0.3, 0.0, 0.5), ..Rotation::default() };
/// let stage = AxialTorque::new([2.0, 1.0], Vector3::z_axis(), 0.1, &start);
/// let end = stage.at(100.0);
/// assert_eq!(end.angular_velocity.z, 10.5);
/// assert!((end.angular_velocity.xy().norm() - 0.3).abs() < 1e-15);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AxialTorque(Case);

#[derive(Clone, Copy, Debug, PartialEq)]
#[expect(clippy::large_enum_variant, reason = "it is evaluated in place")]
enum Case {
    Free(FreeRotation),
    Spinning(Spinning),
}

impl AxialTorque {
    /// From the moments perpendicular to the axis and about it \[kg m²\], about G or the held
    /// point; the axis, in the body; the moment N about it \[N m\], and the state at time zero.
    #[must_use]
    pub fn new(moments: [f64; 2], axis: UnitVector3<f64>, torque: f64, state: &Rotation) -> Self {
        Self(if torque == 0.0 {
            Case::Free(FreeRotation::symmetric(moments, axis, state))
        } else {
            // towards the torque
            let axis = axis.into_inner() * f64::copysign(1.0, torque);
            Case::Spinning(Spinning::new(moments, axis, torque.abs(), state))
        })
    }
}

impl Path for AxialTorque {
    type State = Rotation;

    fn at(&self, time: f64) -> Rotation {
        match &self.0 {
            Case::Free(free) => free.at(time),
            Case::Spinning(spinning) => spinning.at(time),
        }
    }

    fn pace(&self, time: f64) -> f64 {
        match &self.0 {
            Case::Free(free) => free.pace(time),
            Case::Spinning(spinning) => spinning.pace(time),
        }
    }
}

/// The motion under a nonzero torque.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Spinning {
    start: Quaternion<f64>,
    /// a, e × a and e, body axes.
    axes: [Vector3<f64>; 3],
    /// Angular velocity at time zero, along e and across it.
    along: Vector3<f64>,
    across: Vector3<f64>,
    /// N/C
    acceleration: f64,
    /// The power of two by which time is scaled below.
    exponent: i32,
    /// κ θ is the first times t, plus the second times t².
    spin: [Twofold; 2],
    /// P; `None` if there is no angular velocity across e.
    passage: Option<Passage>,
}

impl Spinning {
    fn new([across, along]: [f64; 2], axis: Vector3<f64>, torque: f64, state: &Rotation) -> Self {
        let w = state.angular_velocity;
        let acceleration = torque / along;
        let quickest = [acceleration, torque / across]
            .map(math::sqrt)
            .into_iter()
            .fold(w.amax(), f64::max);
        let exponent = scale::exponent(quickest);

        let (part, rest) = parts(&axis, &w);
        let (length, direction) = scale::direction(&rest);

        let torque = Twofold::from(torque).scaled(-2 * exponent);
        let rate = Twofold::from(axis.dot(&scale::scaled(&w, -exponent)));
        let [across, along] = [across, along].map(Twofold::from);
        let passage = (length.value() > 0.0).then(|| {
            Passage::new(Sweep::new(
                length.scaled(-exponent),
                along / across * rate,
                torque / across,
            ))
        });
        let share = if passage.is_some() {
            (across - along) / across
        } else {
            Twofold::from(1.0)
        };
        Self {
            start: *state.attitude.quaternion(),
            axes: [direction, axis.cross(&direction), axis],
            along: part,
            across: rest,
            acceleration,
            exponent,
            spin: [share * rate, share * (torque / along).scaled(-1)],
            passage,
        }
    }

    /// About an axis towards which u grows: from κ θ, which is the first rate times t and half the
    /// second times t², and the acceleration along the axis.
    pub(super) fn swept(
        axis: Vector3<f64>,
        [spin, drift]: [f64; 2],
        acceleration: f64,
        state: &Rotation,
    ) -> Self {
        let w = state.angular_velocity;
        let grows = Twofold::sum(acceleration, -drift);
        let quickest = [acceleration, drift]
            .map(|change| math::sqrt(change.abs()))
            .into_iter()
            .fold(w.amax().max(spin.abs()), f64::max);
        let exponent = scale::exponent(quickest);
        let (part, rest) = parts(&axis, &w);
        let (length, direction) = scale::direction(&rest);
        let rate = Twofold::from(axis.dot(&scale::scaled(&w, -exponent)));
        let spin = Twofold::from(spin).scaled(-exponent);
        let passage = (length.value() > 0.0).then(|| {
            Passage::new(Sweep::new(
                length.scaled(-exponent),
                rate - spin,
                grows.scaled(-2 * exponent),
            ))
        });
        let (first, second) = if passage.is_some() {
            (spin, drift)
        } else {
            (rate, acceleration)
        };
        Self {
            start: *state.attitude.quaternion(),
            axes: [direction, axis.cross(&direction), axis],
            along: part,
            across: rest,
            acceleration,
            exponent,
            spin: [first, Twofold::from(second).scaled(-2 * exponent - 1)],
            passage,
        }
    }

    pub(super) fn at(&self, time: f64) -> Rotation {
        let faster = libm::scalbn(time, self.exponent);
        let t = Twofold::from(faster);
        let [first, second] = self.spin;
        let (sine, cosine) = ((first + second * t) * t).scaled(-1).sin_cos();
        let [a, b, e] = &self.axes;
        let spun = Quaternion::from_parts(cosine, e * sine);
        let attitude = match &self.passage {
            Some(passage) => {
                let p = passage.at(faster);
                self.start * Quaternion::from_parts(p.w, a * p.i + b * p.j + e * p.k) * spun
            }
            None => self.start * spun,
        };
        let turned = [2.0 * sine * cosine, (cosine - sine) * (cosine + sine)];
        Rotation {
            attitude: attitude::normalized(&attitude),
            angular_velocity: self.angular_velocity(time, turned),
        }
    }

    pub(super) fn pace(&self, time: f64) -> f64 {
        let w = self.angular_velocity(time, [0.0, 1.0]);
        // from rest it turns by half a radian in 1/√(N/C)
        1.0 / (w.norm() + math::sqrt(self.acceleration.abs()))
    }

    /// With the sine and the cosine of κ θ.
    fn angular_velocity(&self, time: f64, [sine, cosine]: [f64; 2]) -> Vector3<f64> {
        let e = &self.axes[2];
        self.along
            + e * (self.acceleration * time)
            + (self.across * cosine + self.across.cross(e) * sine)
    }
}

/// The parts of a vector along an axis, and across it.
fn parts(axis: &Vector3<f64>, w: &Vector3<f64>) -> (Vector3<f64>, Vector3<f64>) {
    let off = |vector: Vector3<f64>| vector - axis * axis.dot(&vector);
    // repeated, because the remainder of the first subtraction may not be exactly across the axis
    (axis * axis.dot(w), off(off(*w)))
}
