//! Free rotation of a body with an axis of symmetry, or about a principal axis: steady precession.
//!
//! With L the angular momentum, A the moment perpendicular to the axis of symmetry n and C the one
//! about it,
//!
//! ```text
//! q(t) = q(0) exp(t L(0)/A) exp(ν t n)      ν = (1 - C/A) n·ω
//! ω(t): ω(0), turned about n by -ν t
//! ```
//!
//! (33.5) in the axes of the body. Rotation about a principal axis is the case ν = 0, L/A = ω.

use nalgebra::{Quaternion, UnitQuaternion, Vector3};

use crate::mechanics::attitude;
use crate::numbers::scale;
use crate::numbers::twofold::Twofold;
use crate::state::Rotation;

/// Two rotations, each at a constant rate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Regular {
    start: UnitQuaternion<f64>,
    /// Unit vector along the angular momentum at time zero, body axes; zero at rest.
    momentum: Vector3<f64>,
    /// |L|/A
    precession: Twofold,
    /// n
    axis: Vector3<f64>,
    /// ν
    spin: Twofold,
    /// Angular velocity at time zero, along n and across it.
    along: Vector3<f64>,
    across: Vector3<f64>,
}

impl Regular {
    /// For a body with the moments A across and C along a unit vector.
    pub fn symmetric([across, along]: [f64; 2], axis: Vector3<f64>, state: &Rotation) -> Self {
        let w = state.angular_velocity;
        let exponent = scale::exponent(w.amax());
        let rate = axis.dot(&scale::scaled(&w, -exponent));
        let ratio = Twofold::from(along) / Twofold::from(across);
        let excess = Twofold::sum(along, -across) / Twofold::from(across);
        // exact along n if n is a body axis: w - n (n.w), not w × (n × w)
        let part = axis * axis.dot(&w);
        let rest = w - part;
        let momentum = rest + part * ratio.value();
        let (length, direction) = scale::direction(&momentum);
        Self {
            start: state.attitude,
            momentum: direction,
            precession: length,
            axis,
            spin: (excess * Twofold::from(-rate)).scaled(exponent),
            along: part,
            across: rest,
        }
    }

    /// About a constant axis.
    pub fn steady(state: &Rotation) -> Self {
        let (rate, direction) = scale::direction(&state.angular_velocity);
        Self {
            start: state.attitude,
            momentum: direction,
            precession: rate,
            axis: Vector3::zeros(),
            spin: Twofold::default(),
            along: state.angular_velocity,
            across: Vector3::zeros(),
        }
    }

    pub fn at(&self, time: f64) -> Rotation {
        let time = Twofold::from(time);
        let precessed = turn(&self.momentum, self.precession * time);
        let spun = self.spin * time;
        let (sine, cosine) = spun.sin_cos();
        let attitude = self.start.quaternion() * precessed * turn(&self.axis, spun);
        Rotation {
            attitude: attitude::normalized(&attitude),
            angular_velocity: self.along
                + (self.across * cosine + self.across.cross(&self.axis) * sine),
        }
    }

    pub fn period(&self) -> Option<f64> {
        let rate = self.spin.value().abs();
        (rate > 0.0 && self.across != Vector3::zeros()).then(|| core::f64::consts::TAU / rate)
    }
}

/// The unit quaternion of a rotation by this angle about a unit vector.
fn turn(axis: &Vector3<f64>, angle: Twofold) -> Quaternion<f64> {
    let (sine, cosine) = angle.scaled(-1).sin_cos();
    Quaternion::from_parts(cosine, axis * sine)
}
