//! Bodies with rotors that are symmetric together.

use nalgebra::{Quaternion, UnitQuaternion, UnitVector3, Vector3};

use super::axial_torque::Spinning;
use crate::bodies::path::Path;
use crate::mechanics::attitude;
use crate::numbers::math;
use crate::numbers::scale;
use crate::numbers::twofold::Twofold;
use crate::state::Rotation;

/// A body that carries rotors about its axis of symmetry e, such as a dual-spin satellite. Drives
/// may turn the rotors, and a moment along e may turn the whole; all of these loads are constant.
///
/// Let A be the moment of inertia of the whole across the axis, r the rate of the body about it,
/// and h the angular momentum along it, including the rotors:
///
/// ```text
/// w' = n w × e + r' e        n = r - h/A; n' and r' constant
/// ```
///
/// Without an external moment, h is constant, and n' is r'. In axes that turn by θ, the vector `w -
/// n e` is then constant too; it is the angular momentum over A:
///
/// ```text
/// q(t) = q(0) exp(t (w(0) - n e)) exp(θ e)      θ = n t + n' t²/2
/// w(t) = w(0) + r' t e, turned about e by -θ
/// ```
///
/// J. Wittenburg, Dynamics of Multibody Systems (2008), 4.6. With a moment, that vector sweeps, as
/// under an [`AxialTorque`](super::AxialTorque). The error is about that of one rounding of the
/// inputs: a few 1e-16 per radian turned.
///
/// ```
/// use newton_euler::exact::{Gyrostat, Path};
/// use newton_euler::prelude::*;
/// use newton_euler::nalgebra::Vector3;
///
/// // A = 12, 9 about the axis without the rotor, which has 4.2 N m s
/// let start = Rotation { angular_velocity: Vector3::new(0.1, -0.06, 0.25), ..Rotation::default() };
/// let rate = 0.25 - (9.0 * 0.25 + 4.2) / 12.0;
/// let satellite = Gyrostat::new(Vector3::z_axis(), [rate, 0.0], 0.0, &start);
/// let end = satellite.at(10.0).angular_velocity;
/// assert!((end.x + 0.080_660_655_030_326_38).abs() < 1e-16);
/// assert_eq!(end.z, 0.25);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gyrostat(Case);

#[derive(Clone, Copy, Debug, PartialEq)]
#[expect(clippy::large_enum_variant, reason = "it is evaluated in place")]
enum Case {
    Precessing(Precessing),
    /// With n and n'.
    Swept(Spinning, [f64; 2]),
}

impl Gyrostat {
    /// About an axis, in the body, with n \[rad/s\] and n' \[rad/s²\] at time zero, r' \[rad/s²\], and
    /// the state at time zero.
    #[must_use]
    pub fn new(
        axis: UnitVector3<f64>,
        [spin, drift]: [f64; 2],
        acceleration: f64,
        state: &Rotation,
    ) -> Self {
        let grows = acceleration - drift;
        let axis = axis.into_inner();
        Self(if grows == 0.0 {
            Case::Precessing(Precessing::new(axis, [spin, drift], state))
        } else {
            let sense = f64::copysign(1.0, grows);
            let spin = [sense * spin, sense * drift];
            let axis = axis * sense;
            let swept = Spinning::swept(axis, spin, sense * acceleration, state);
            Case::Swept(swept, spin)
        })
    }
}

impl Path for Gyrostat {
    type State = Rotation;

    fn at(&self, time: f64) -> Rotation {
        match &self.0 {
            Case::Precessing(precessing) => precessing.at(time),
            Case::Swept(spinning, _) => spinning.at(time),
        }
    }

    fn pace(&self, time: f64) -> f64 {
        match &self.0 {
            Case::Precessing(precessing) => precessing.pace(time),
            Case::Swept(spinning, [spin, drift]) => {
                1.0 / (1.0 / spinning.pace(time) + (spin + drift * time).abs())
            }
        }
    }
}

/// Two rotations, one at a constant rate, the other under a constant acceleration.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Precessing {
    start: UnitQuaternion<f64>,
    /// Unit vector along the angular momentum at time zero, body axes; zero at rest.
    momentum: Vector3<f64>,
    /// Its length over A.
    precession: Twofold,
    /// e
    axis: Vector3<f64>,
    /// n and n'/2
    spin: [Twofold; 2],
    /// n'
    drift: f64,
    /// Angular velocity at time zero, along e and across it.
    along: Vector3<f64>,
    across: Vector3<f64>,
}

impl Precessing {
    fn new(axis: Vector3<f64>, [spin, drift]: [f64; 2], state: &Rotation) -> Self {
        let w = state.angular_velocity;
        let rate = axis.dot(&w);
        let along = axis * rate;
        let across = w - along;
        let (precession, momentum) = scale::direction(&(across + axis * (rate - spin)));
        Self {
            start: state.attitude,
            momentum,
            precession,
            axis,
            spin: [Twofold::from(spin), Twofold::from(0.5 * drift)],
            drift,
            along,
            across,
        }
    }

    fn at(&self, time: f64) -> Rotation {
        let t = Twofold::from(time);
        let [spin, drift] = self.spin;
        let spun = (spin + drift * t) * t;
        let (sine, cosine) = spun.sin_cos();
        let precessed = turn(&self.momentum, self.precession * t);
        let attitude = self.start.quaternion() * precessed * turn(&self.axis, spun);
        let along = self.along + self.axis * (self.drift * time);
        Rotation {
            attitude: attitude::normalized(&attitude),
            angular_velocity: along + (self.across * cosine + self.across.cross(&self.axis) * sine),
        }
    }

    fn pace(&self, time: f64) -> f64 {
        let [spin, drift] = self.spin.map(Twofold::value);
        let spun = (spin + 2.0 * drift * time).abs();
        1.0 / (self.precession.value() + spun + math::sqrt(self.drift.abs()))
    }
}

/// The unit quaternion of a turn by this angle about a unit vector.
fn turn(axis: &Vector3<f64>, angle: Twofold) -> Quaternion<f64> {
    let (sine, cosine) = angle.scaled(-1).sin_cos();
    Quaternion::from_parts(cosine, axis * sine)
}
