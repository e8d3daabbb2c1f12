//! Linear and angular momentum, in world axes.

use crate::mechanics::balances::transform;
use crate::model::{Frame, Inertia, Model, Vector, Workspace};
use crate::symbolic::Components;

use super::balance::from_pole;

/// The expressions of `outputs: [momentum]`, from absolute velocities, in world axes.
pub struct Momentum {
    /// `P = m v`
    pub linear: Components,
    /// About G: `R J w`.
    pub angular: Components,
    /// About the pole O: `R J w + (G - O) x m v`; `dL_O/dt = M_O - v_O x P`.
    pub about_pole: Components,
}

pub fn derive_momentum(model: &Model, work: &mut Workspace) -> Momentum {
    let w = model.state.angular_velocity;
    let moving = match model.mass {
        Some(mass) => work.scale(mass, model.state.velocity),
        None => Vector::ZERO,
    };
    let linear = work.components(moving, Frame::WORLD);
    let graph = &mut work.graph;
    let spin = match model.inertia {
        Inertia::Absent => graph.zeros(),
        Inertia::Scalar(inertia) => graph.scale_vector(inertia, w),
        Inertia::Spatial(rows) => transform(graph, &rows, w),
    };
    let spin = work.vector(model.state.axes, spin);
    let angular = work.components(spin, Frame::WORLD);
    let arm = from_pole(model, work);
    let orbital = work.cross(arm, moving);
    let orbital = work.components(orbital, Frame::WORLD);
    let about_pole = work.graph.add_vectors(angular, orbital);
    Momentum {
        linear,
        angular,
        about_pole,
    }
}
