//! What the accelerations of a body depend on, and their symmetries. Generic integrators use these
//! properties to choose how they integrate.

use std::collections::HashMap;

use crate::mechanics::balances::{inertia_about_center, known_parts, moments_about};
use crate::mechanics::proofs::all_vanish;
use crate::model::{Inertia, Meaning, Model, Pair, Variable, Workspace};
use crate::symbolic::{Components, Id, Number};

use super::symmetry::{Space, Symmetry, symmetries};

/// The properties of a body that integrators can use.
#[derive(Clone)]
pub struct Structure {
    pub linear: Dependence,
    pub angular: Dependence,
    /// Whether G does not accelerate.
    pub is_force_free: bool,
    /// Whether no moment acts about G, or about the held point.
    pub is_torque_free: bool,
    /// Whether there is no angular acceleration about the axes of symmetry.
    pub keeps_spin: bool,
    /// The axis of symmetry, as a unit vector in body axes, if the body axes may be rotated about
    /// it and the body keeps its spin.
    pub spin_axis: Option<[Number; 3]>,
    /// For each axis, whether a motion in the plane perpendicular to it stays in that plane.
    pub planes: [bool; 3],
}

/// What one of the accelerations depends on.
#[derive(Clone)]
pub struct Dependence {
    /// Whether it depends on each quantity, in the order of [`QUANTITIES`].
    pub reads: [bool; 7],
    /// The directions about which the world may be rotated.
    pub world: Symmetry,
    /// The directions about which the axes of the body may be rotated.
    pub body: Symmetry,
}

/// The names of the quantities.
pub const QUANTITIES: [&str; 7] = [
    "time",
    "position",
    "velocity",
    "attitude",
    "angular_velocity",
    "input",
    "states",
];

pub fn derive_structure(model: &Model, work: &mut Workspace, accelerations: Pair) -> Structure {
    let (linear, angular) = (&accelerations.linear, &accelerations.angular);
    let [linear_spaces, angular_spaces] = symmetries(model, work, linear, angular);
    let keeps_spin = keeps_spin(work, angular, &angular_spaces[1]);
    let dependence = |roots: &Components, spaces: &[Space; 2]| Dependence {
        reads: reads(work, roots),
        world: spaces[0].symmetry(),
        body: spaces[1].symmetry(),
    };
    let (linear_dependence, angular_dependence) = (
        dependence(linear, &linear_spaces),
        dependence(angular, &angular_spaces),
    );
    let both = [Symmetry::Every, angular_dependence.body];
    let spins = keeps_spin && both.contains(&linear_dependence.body);
    Structure {
        linear: linear_dependence,
        angular: angular_dependence,
        is_force_free: all_vanish(work, linear),
        is_torque_free: is_torque_free(model, work, angular),
        keeps_spin,
        spin_axis: angular_spaces[1].axis().filter(|_| spins),
        planes: [0, 1, 2].map(|axis| stays_in_plane(model, work, accelerations, axis)),
    }
}

/// The index in [`QUANTITIES`] of the quantity that a symbol belongs to.
fn quantity(meaning: Meaning) -> Option<usize> {
    match meaning {
        Meaning::Time => Some(0),
        Meaning::Of(_, Variable::Position, _) => Some(1),
        Meaning::Of(_, Variable::Velocity, _) => Some(2),
        Meaning::Of(_, Variable::Angle | Variable::Quaternion | Variable::Axis, _) => Some(3),
        Meaning::Of(_, Variable::AngularVelocity | Variable::AxisRate, _) => Some(4),
        Meaning::Input(..) => Some(5),
        Meaning::Own(_) => Some(6),
        _ => None,
    }
}

fn reads(work: &Workspace, roots: &[Id]) -> [bool; 7] {
    let mut reads = [false; 7];
    for id in work.graph.nodes_of(roots) {
        if let Some(meaning) = work.meaning(id)
            && let Some(index) = quantity(meaning)
        {
            reads[index] = true;
        }
    }
    reads
}

/// Whether the total moment is zero.
fn is_torque_free(model: &Model, work: &mut Workspace, angular: &Components) -> bool {
    let w = model.state.angular_velocity;
    let moment = match (inertia_about_center(model, work), model.state.axis) {
        // u'' + u'^2 u
        (_, Some(axis)) => {
            let graph = &mut work.graph;
            let square = graph.norm_squared(axis.rate);
            let held = graph.scale_vector(square, axis.unit);
            graph.add_vectors(*angular, held)
        }
        // J w' + w x J w
        (Inertia::Spatial(rows), None) if !model.motion.is_hinged() => {
            let graph = &mut work.graph;
            let momentum = graph.transform(&rows, w);
            let (driven, gyroscopic) = (graph.transform(&rows, *angular), graph.cross(w, momentum));
            graph.add_vectors(driven, gyroscopic)
        }
        _ => *angular,
    };
    all_vanish(work, &moment) || model.constraints.is_empty() && has_no_moment(model, work)
}

/// Whether the moments of all loads vanish, in body axes and in world axes separately. For a tensor
/// in principal axes, `J w' + w x J w` may not show this.
fn has_no_moment(model: &Model, work: &mut Workspace) -> bool {
    if model.motion.is_hinged() || model.state.axis.is_some() {
        return false;
    }
    let center = model.state.center(work);
    let mut moments = moments_about(&model.state, work, &model.loads, center);
    let known = known_parts(model, work, center).into_iter();
    moments.extend(known.map(|(_, moment)| moment));
    let total = work.sum(moments);
    let entries = work.entries(&[total]);
    all_vanish(work, &entries)
}

/// Whether the angular acceleration has no component along the axes of symmetry.
fn keeps_spin(work: &mut Workspace, angular: &Components, axes: &Space) -> bool {
    let along: Vec<Id> = axes
        .basis
        .iter()
        .map(|axis| {
            let graph = &mut work.graph;
            let axis = axis.clone().map(|part| graph.number(part));
            graph.dot(axis, *angular)
        })
        .collect();
    !along.is_empty() && all_vanish(work, &along)
}

/// Whether a motion has no acceleration out of the plane through the world's origin perpendicular
/// to this axis, if it lies in that plane and the same body axis is along this axis.
fn stays_in_plane(
    model: &Model,
    work: &mut Workspace,
    Pair { linear, angular }: Pair,
    axis: usize,
) -> bool {
    if model.motion.is_planar || model.motion.is_hinged() {
        return false;
    }
    let is_out_of_plane = |meaning: Meaning| {
        use Variable::{AngularVelocity, Axis, AxisRate, Position, Quaternion, Velocity};
        match meaning {
            Meaning::Of(_, Position | Velocity | Axis | AxisRate, i) => i == axis,
            Meaning::Of(_, Quaternion, i) => i != 0 && i != axis + 1,
            Meaning::Of(_, AngularVelocity, i) => i != axis,
            _ => false,
        }
    };
    let is_rod = model.motion.is_line();
    let out_of_plane = (0..3).filter(|i| (*i == axis) == is_rod);
    let roots: Vec<Id> = out_of_plane
        .map(|i| angular[i])
        .chain([linear[axis]])
        .collect();
    let zero = work.graph.zero();
    let mut flat = HashMap::new();
    for id in work.graph.nodes_of(&roots) {
        if work.meaning(id).is_some_and(is_out_of_plane) {
            flat.insert(id, zero);
        }
    }
    let graph = &mut work.graph;
    let roots = graph.substitute(&roots, |id| flat.get(&id).copied());
    all_vanish(work, &roots)
}
