//! Lagrange's top: a body that is symmetric about an axis e, under a couple `k x e`, where k is
//! constant in the world.
//!
//! The moment of forces that are constant in the world is `sum r_l x W_l`, where `r_l` are the
//! world's axes in body axes and `W_l` are vectors of the body. The twelve rotations of a
//! tetrahedron determine these vectors: over the twelve, the mean of the dyad `r_l r_m` is 1/3 of
//! the unit matrix for l = m, and zero otherwise.
//!
//! ```text
//! W_l = 1/8 sum over rotations of M x r_l        k_l = W_l . e
//! ```
//!
//! Before any number is computed, it is checked that `k x e` can be the moment. Whether it is the
//! moment is then tested at random states.

use crate::mechanics::proofs::{all_vanish, cancels_in_half_turns};
use crate::model::{Attitude, Frame, Workspace};
use crate::symbolic::{Components, Id, Number};

use super::axis_of_symmetry::axes_of_symmetry;
use super::solid::Solid;

/// What determines the motion of a top.
pub struct Top {
    /// The moments of inertia across the axis and about it.
    pub moments: [Id; 2],
    /// The unit vector e, in body axes.
    pub axis: Components,
    /// k, in world axes.
    pub couple: Components,
}

impl Top {
    pub fn roots(&self) -> Vec<Id> {
        [&self.moments[..], &self.axis[..], &self.couple[..]].concat()
    }
}

/// The top that a moment, in body axes, makes of a body; `None` if it makes none.
pub fn lagrange_top(solid: &Solid, work: &mut Workspace, moment: Components) -> Option<Top> {
    let arms = arms(solid, work, moment)?;
    for (moments, axis) in axes_of_symmetry(solid, work, &arms) {
        let couple = work.graph.transform(&arms, axis);
        let expected = couple_on(solid, work, couple, axis);
        let graph = &mut work.graph;
        let rest = [0, 1, 2].map(|i| graph.subtract(moment[i], expected[i]));
        if all_vanish(work, &rest) {
            work.labels.vector("couple", couple);
            return Some(Top {
                moments,
                axis,
                couple,
            });
        }
    }
    None
}

/// `k x e` in body axes.
fn couple_on(
    solid: &Solid,
    work: &mut Workspace,
    couple: Components,
    axis: Components,
) -> Components {
    let seen = seen_from_body(solid, work, couple);
    work.graph.cross(seen, axis)
}

/// The components in body axes of a vector given in world axes.
fn seen_from_body(solid: &Solid, work: &mut Workspace, world: Components) -> Components {
    let vector = work.vector(Frame::WORLD, world);
    work.components(vector, solid.body)
}

/// The vectors `W_l`, if the moment depends only on the attitude.
fn arms(solid: &Solid, work: &mut Workspace, moment: Components) -> Option<[Components; 3]> {
    let Attitude::Quaternion { scalar, vector } = work.attitude(solid.body) else {
        return None;
    };
    let parts = [[scalar].as_slice(), vector.as_slice()].concat();
    let graph = &work.graph;
    if graph.depends_on(&moment, |id| !graph.is_early(id) && !parts.contains(&id)) {
        return None;
    }
    if !cancels_in_half_turns(work, &moment) {
        return None;
    }
    let mut roots = moment.to_vec();
    for axis in work.graph.unit_vectors() {
        roots.extend(seen_from_body(solid, work, axis));
    }
    let graph = &mut work.graph;
    let mut arms = [graph.zeros(); 3];
    for quaternion in tetrahedral() {
        let values = quaternion.map(|part| graph.number(part));
        let value = |id: Id| Some(values[parts.iter().position(|part| *part == id)?]);
        let images = graph.substitute(&roots, value);
        let (there, seen) = images.split_at(3);
        for (arm, axis) in arms.iter_mut().zip(seen.chunks_exact(3)) {
            let swept = graph.cross([there[0], there[1], there[2]], [axis[0], axis[1], axis[2]]);
            *arm = graph.add_vectors(*arm, swept);
        }
    }
    let share = graph.number(Number::ratio(1, 8));
    Some(arms.map(|arm| graph.scale_vector(share, arm)))
}

/// The rotations of a tetrahedron, up to the sign of their quaternions: the unit quaternions whose
/// components are all integers, or all half-integers.
fn tetrahedral() -> impl Iterator<Item = [Number; 4]> {
    let whole =
        (0..4).map(|place| [0, 1, 2, 3].map(|part| Number::integer(i64::from(part == place))));
    let halves = (0..8).map(|signs| {
        [0, 1, 2, 4].map(|bit| Number::ratio(if signs & bit == 0 { 1 } else { -1 }, 2))
    });
    whole.chain(halves)
}
