//! Axes that do not spin with a symmetric body, for its series (EQUATIONS 5(e)).
//!
//! Suppose that the axes of a body may be rotated about e, and that its spin `s = e . w` is
//! constant. In axes that rotate relative to the body at `-sigma` about e, with the components of
//! the whole angular velocity in these axes, the motion is
//!
//! ```text
//! q' = q (0, w - sigma e) / 2      w' = alpha(q, w) + sigma e x w
//! ```
//!
//! Any sigma is correct. In axes without spin, `sigma = s`, the angular velocity of a free body
//! rotates at `beta = s J_e / J_t`, where `J_e` and `J_t` are the moments along e and across it. In
//! axes with `sigma = s - beta`, it is constant, but the attitude rotates faster. Halfway between
//! the two, steps are longest, or nearly so, for tops that are flat or slender, fast or slow:
//!
//! ```text
//! sigma = s - beta / 2 = s (1 - J_e / (tr J - J_e))
//! ```

use crate::mechanics::balances::inertia_about_center;
use crate::mechanics::structure::Structure;
use crate::model::{Attitude, Inertia, Model, Workspace};
use crate::symbolic::{Components, Id, Number};

/// Axes in which a motion is slower than in body axes.
#[derive(Debug)]
pub struct Axes {
    /// The unit vector e.
    pub direction: [Number; 3],
    /// sigma: the rate at which the body rotates about e relative to these axes.
    pub spin: Id,
    /// Their angular velocity: `w - sigma e`.
    pub rate: Components,
    e: Components,
}

pub fn derive_axes(model: &Model, work: &mut Workspace, structure: &Structure) -> Option<Axes> {
    let direction = structure.spin_axis.clone()?;
    let Attitude::Quaternion { .. } = work.attitude(model.state.body) else {
        return None;
    };
    let Inertia::Spatial(rows) = inertia_about_center(model, work) else {
        return None;
    };
    let graph = &mut work.graph;
    // the spin of these axes is constant only if the moments of inertia are
    if !graph.are_early(rows.as_flattened()) {
        return None;
    }
    let e = direction.clone().map(|part| graph.number(part));
    let of_e = graph.transform(&rows, e);
    let along = graph.dot(e, of_e);
    let trace = graph.add(rows[0][0], rows[1][1]);
    let trace = graph.add(trace, rows[2][2]);
    let twice_across = graph.subtract(trace, along);
    let part = graph.divide(along, twice_across);
    let one = graph.one();
    let rest = graph.subtract(one, part);
    let whole = graph.dot(e, model.state.angular_velocity);
    let [axes_spin, spin] = [part, rest].map(|part| graph.multiply(part, whole));
    let labels = &mut work.labels;
    labels.name(axes_spin, "axes_spin");
    labels.name(spin, "spin");
    let whole = graph.scale_vector(whole, e);
    let across = graph.subtract_vectors(model.state.angular_velocity, whole);
    let along = graph.scale_vector(axes_spin, e);
    let rate = graph.add_vectors(across, along);
    Some(Axes {
        direction,
        spin,
        rate,
        e,
    })
}

impl Axes {
    /// The rate of w in these axes: `alpha + sigma e x w`, without the part along e, which
    /// vanishes.
    pub fn acceleration(
        &self,
        model: &Model,
        work: &mut Workspace,
        angular: Components,
    ) -> Components {
        let graph = &mut work.graph;
        let swept = graph.cross(self.e, model.state.angular_velocity);
        let swept = graph.scale_vector(self.spin, swept);
        let along = graph.dot(self.e, angular);
        let along = graph.scale_vector(along, self.e);
        let across = graph.subtract_vectors(angular, along);
        graph.add_vectors(across, swept)
    }
}
