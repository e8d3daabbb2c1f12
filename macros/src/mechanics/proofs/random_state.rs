//! A random state of a body, modulo the prime of the test for zeros.

use crate::model::{Meaning, Variable, Workspace};
use crate::symbolic::{Id, Residue, free};

/// A random state. Dependent components are rational functions of free ones: a unit quaternion and
/// a unit vector come from a stereographic projection, and the rate of the unit vector is a cross
/// product with it.
pub struct RandomState {
    pub number: u64,
    /// The attitude of the first body; other bodies have other attitudes.
    pub quaternion: [Residue; 4],
    /// The body axis about which each body is rotated further by half a turn, if any.
    half_turn: Option<usize>,
    pub axis: [Residue; 3],
    pub axis_rate: [Residue; 3],
}

impl RandomState {
    pub fn draw(number: u64) -> Self {
        let free = |index: u8| Residue::stand_in(&("state", index, number));
        let [scalar, x, y, z] = unit_vector([0, 1, 2].map(free));
        let axis = unit_vector([3, 4].map(free));
        Self {
            number,
            quaternion: [scalar, x, y, z],
            half_turn: None,
            axis,
            axis_rate: cross(axis, [5, 6, 7].map(free)),
        }
    }

    /// The state with all attitudes rotated further by half a turn about an axis of the body: their
    /// quaternions times i, j or k.
    pub fn turned(self, about: Option<usize>) -> Self {
        Self {
            half_turn: about,
            ..self
        }
    }

    fn half_turned(&self, [s, x, y, z]: [Residue; 4]) -> [Residue; 4] {
        match self.half_turn {
            None => [s, x, y, z],
            Some(0) => [-x, s, z, -y],
            Some(1) => [-y, -z, s, x],
            Some(_) => [-z, y, -x, s],
        }
    }

    /// The value of a symbol.
    pub fn of(&self, work: &Workspace, id: Id) -> Residue {
        match work.meaning(id) {
            Some(Meaning::Of(body, Variable::Quaternion, part)) => match body.index() {
                0 | 1 => self.half_turned(self.quaternion)[part],
                further => {
                    let free =
                        |index: u8| Residue::stand_in(&("attitude", index, further, self.number));
                    let quaternion: [Residue; 4] = unit_vector([0, 1, 2].map(free));
                    self.half_turned(quaternion)[part]
                }
            },
            Some(Meaning::Of(_, Variable::Axis, part)) => self.axis[part],
            Some(Meaning::Of(_, Variable::AxisRate, part)) => self.axis_rate[part],
            _ => free(id, self.number),
        }
    }
}

/// `(1 - s^2, 2 s) / (1 + s^2)` for a vector s: a unit vector with one more dimension.
fn unit_vector<const N: usize, const M: usize>(s: [Residue; N]) -> [Residue; M] {
    let square = s
        .iter()
        .fold(Residue::ZERO, |sum, part| sum + *part * *part);
    let below = Residue::ONE + square;
    // -1 is not the square of a residue, but a sum of squares may be -1
    let scale = below.reciprocal().unwrap_or(Residue::ONE);
    core::array::from_fn(|part| match part.checked_sub(1) {
        None => (Residue::ONE + -square) * scale,
        Some(part) => (s[part] + s[part]) * scale,
    })
}

pub fn cross(a: [Residue; 3], b: [Residue; 3]) -> [Residue; 3] {
    [(1, 2), (2, 0), (0, 1)].map(|(i, j)| a[i] * b[j] + -(a[j] * b[i]))
}
