//! Quaternions in twice the precision: near the vertical, the tilt is the small difference between
//! the attitude and the axes.

use core::ops::Mul;

use nalgebra::{Quaternion, Vector3};

use crate::numbers::scale;
use crate::numbers::twofold::Twofold;

/// A rotation: the scalar, then the vector.
#[derive(Clone, Copy)]
pub(super) struct Turn([Twofold; 4]);

impl Turn {
    /// To the third axis from a vector that is not zero.
    pub fn to_third_axis(vector: &Vector3<f64>) -> Self {
        let scaled = scale::scaled(vector, -scale::exponent(vector.amax()));
        let (length, _) = scale::direction(&scaled);
        let [x, y, z] = [scaled.x, scaled.y, scaled.z].map(|part| Twofold::from(part) / length);
        if z.value() >= 0.0 {
            return Self::shortest([x, y, z]);
        }
        // half a turn about the first axis before
        let half = Self::from(&Quaternion::new(0.0, 1.0, 0.0, 0.0));
        Self::shortest([x, -y, -z]) * half
    }

    /// To the third axis from a unit vector on its side.
    fn shortest([x, y, z]: [Twofold; 3]) -> Self {
        let above = z + Twofold::from(1.0);
        let root = above.scaled(1).sqrt();
        Self([above / root, y / root, -x / root, Twofold::default()])
    }

    pub fn conjugate(self) -> Self {
        let [w, x, y, z] = self.0;
        Self([w, -x, -y, -z])
    }

    /// The nearest doubles.
    pub fn value(self) -> Quaternion<f64> {
        let [w, x, y, z] = self.0.map(Twofold::value);
        Quaternion::new(w, x, y, z)
    }
}

impl From<&Quaternion<f64>> for Turn {
    fn from(turn: &Quaternion<f64>) -> Self {
        Self([turn.w, turn.i, turn.j, turn.k].map(Twofold::from))
    }
}

impl Mul for Turn {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let ([a, b, c, d], [w, x, y, z]) = (self.0, other.0);
        Self([
            a * w - b * x - c * y - d * z,
            a * x + b * w + c * z - d * y,
            a * y - b * z + c * w + d * x,
            a * z + b * y - c * x + d * w,
        ])
    }
}
