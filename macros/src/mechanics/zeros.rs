//! What is proved to be zero in all states, by the values of expressions at one random state.

use crate::model::{Meaning, Workspace};
use crate::symbolic::{Id, Residue, Sample, free};

/// Whether all of `roots` are proved to be zero in all states, on all branches.
pub fn all_vanish(work: &Workspace, roots: &[Id]) -> bool {
    samples(work, roots).iter().all(Sample::is_zero)
}

/// The values of `roots` at one random state, on each branch.
pub fn samples(work: &Workspace, roots: &[Id]) -> Vec<Sample> {
    let state = RandomState::draw(0);
    work.graph.samples(roots, |id| state.of(work, id))
}

/// Whether the sums of `roots` over an attitude and its half turns about the axes of the body are proved
/// to be zero: those of the entries of its matrix are, and of what is linear in them.
pub fn cancels_in_half_turns(work: &Workspace, roots: &[Id]) -> bool {
    let states = [None, Some(0), Some(1), Some(2)].map(|axis| RandomState::draw(0).turned(axis));
    let places = states.each_ref().map(|state| |id| state.of(work, id));
    let sums = work.graph.sums(roots, &places);
    sums.iter().all(Sample::is_zero)
}

/// A random state. What is not free of it is rational in what is: a unit quaternion and a unit vector by
/// stereographic projection, the rate of the unit vector as a product with it.
pub struct RandomState {
    number: u64,
    quaternion: [Residue; 4],
    axis: [Residue; 3],
    axis_rate: [Residue; 3],
}

impl RandomState {
    pub fn draw(number: u64) -> Self {
        let free = |index: u8| Residue::stand_in(&("state", index, number));
        let [scalar, x, y, z] = unit_vector([0, 1, 2].map(free));
        let axis = unit_vector([3, 4].map(free));
        Self {
            number,
            quaternion: [scalar, x, y, z],
            axis,
            axis_rate: cross(axis, [5, 6, 7].map(free)),
        }
    }

    /// With the attitude half a turn about an axis of the body further: its quaternion times i, j or k.
    fn turned(self, about: Option<usize>) -> Self {
        let [s, x, y, z] = self.quaternion;
        let quaternion = match about {
            None => [s, x, y, z],
            Some(0) => [-x, s, z, -y],
            Some(1) => [-y, -z, s, x],
            Some(_) => [-z, y, -x, s],
        };
        Self { quaternion, ..self }
    }

    /// The value of a symbol.
    pub fn of(&self, work: &Workspace, id: Id) -> Residue {
        match work.meaning(id) {
            Some(Meaning::Quaternion(part)) => self.quaternion[part],
            Some(Meaning::Axis(part)) => self.axis[part],
            Some(Meaning::AxisRate(part)) => self.axis_rate[part],
            _ => free(id, self.number),
        }
    }
}

/// `(1 - s^2, 2 s) / (1 + s^2)` of a vector s: a unit vector of one more dimension.
fn unit_vector<const N: usize, const M: usize>(s: [Residue; N]) -> [Residue; M] {
    let square = s
        .iter()
        .fold(Residue::ZERO, |sum, part| sum + *part * *part);
    let below = Residue::ONE + square;
    // -1 is no square of a real residue, but a sum of squares may be -1
    let scale = below.reciprocal().unwrap_or(Residue::ONE);
    core::array::from_fn(|part| match part.checked_sub(1) {
        None => (Residue::ONE + -square) * scale,
        Some(part) => (s[part] + s[part]) * scale,
    })
}

fn cross(a: [Residue; 3], b: [Residue; 3]) -> [Residue; 3] {
    [(1, 2), (2, 0), (0, 1)].map(|(i, j)| a[i] * b[j] + -(a[j] * b[i]))
}
