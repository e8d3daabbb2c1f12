//! Motions in closed form: which one a body has, or what is in the way of it.
//!
//! G moves on a parabola if nothing but constant forces, in world axes, act on the body. Apart from that
//! it turns
//!
//! ```text
//! in space        freely: no moment about G, or about the point that is held
//!                 as Lagrange's top: a couple k x e, of a body that is symmetric about e
//!                 spinning up: a constant moment N e, of such a body
//! about an axis   with constant acceleration, or as a pendulum: w' = a sin theta + b cos theta
//! as a rod        freely, along a great circle
//! ```

use crate::errors::{Errors, Extent};
use crate::model::{Frame, Inertia, Meaning, Model, Motion, Vector, Workspace};
use crate::symbolic::{Components, Id, Node};

use super::about_axis::about_axis;
use super::axial_torque::{AxialTorque, axial_torque};
use super::axis_of_symmetry::axes_of_symmetry;
use super::free_rotation::{Free, free};
use super::lagrange_top::{Top, lagrange_top};
use super::newton_euler::moments_about;
use super::reactions::given_parts;
use super::zeros::all_vanish;

/// The motion of a body in closed form.
pub struct Flow {
    /// Acceleration of G, constant, world axes; zero where G has no coordinates.
    pub linear: Components,
    pub turning: Turning,
}

/// How a body turns.
pub enum Turning {
    /// Not at all.
    None,
    /// In space, without a moment.
    Free(Free),
    /// In space, under a couple.
    Top(Top),
    /// In space, under a constant moment along its axis of symmetry.
    Axial(AxialTorque),
    /// As a rod, without a moment.
    GreatCircle,
    /// About an axis, with a constant acceleration.
    Uniform(Id),
    /// About an axis: `theta'' = -rate^2 sin(theta - hanging)`
    Pendulum { rate: Id, hanging: Id },
}

impl Flow {
    /// What the start of a path reads: all but the entries of a tensor.
    pub fn roots(&self) -> Vec<Id> {
        let mut roots = self.linear.to_vec();
        roots.extend(self.turning.roots());
        roots
    }

    /// The entries of a tensor of which the principal axes are found when the body is built.
    pub fn tensor(&self) -> Option<[Id; 6]> {
        match self.turning {
            Turning::Free(Free::Tensor(entries)) => Some(entries),
            _ => None,
        }
    }

    /// Which motion it is, line by line.
    pub fn describe(&self, motion: Motion) -> Vec<String> {
        let center = motion.translates().then_some("G moves on a parabola");
        let turning = match &self.turning {
            Turning::None => None,
            Turning::Free(Free::Steady) => Some("the body turns at a constant rate"),
            Turning::Free(Free::Symmetric(..)) => Some("the body precesses steadily"),
            Turning::Free(Free::Principal(..)) => Some("the body turns by elliptic functions"),
            Turning::Free(Free::Along(_) | Free::Tensor(_)) => {
                Some("the body turns freely, in a way that its moments of inertia decide")
            }
            Turning::Top(_) => Some("the body turns as Lagrange's top, by elliptic functions"),
            Turning::Axial(_) => Some(
                "the spin about the axis of symmetry is linear in time, the attitude goes by parabolic cylinder functions",
            ),
            Turning::GreatCircle => Some("the axis turns along a great circle"),
            Turning::Uniform(_) => Some("the angle is quadratic in time"),
            Turning::Pendulum { .. } => {
                Some("the angle is that of a pendulum, by elliptic functions")
            }
        };
        let lines = center.into_iter().chain(turning);
        lines.map(str::to_owned).collect()
    }
}

impl Turning {
    pub fn roots(&self) -> Vec<Id> {
        match self {
            Self::None | Self::GreatCircle => Vec::new(),
            Self::Free(free) => free.roots(),
            Self::Top(top) => top.roots(),
            Self::Axial(axial) => axial.roots(),
            Self::Uniform(acceleration) => vec![*acceleration],
            Self::Pendulum { rate, hanging } => vec![*rate, *hanging],
        }
    }
}

/// The closed form. All that is in its way is reported at the place where it is asked for.
pub fn derive_flow(
    model: &Model,
    work: &mut Workspace,
    place: Extent,
    linear: &Components,
    angular: &Components,
    errors: &mut Errors,
) -> Option<Flow> {
    if !model.constraints.is_empty() {
        errors.push(
            place,
            "under constraints there is no closed form in this version: use a motion with a support, or leave out \
             `flow`, and the motion is integrated",
        );
        return None;
    }
    let contributions = contributions(model, work);
    let mut obstacles = Vec::new();
    if !work.graph.are_early(linear) {
        obstacles.extend(unsteady_forces(work, &contributions));
    }
    let turning = turning(model, work, angular, &contributions, &mut obstacles);
    obstacles.dedup();
    for obstacle in &obstacles {
        errors.push(
            place,
            format!("no closed form: {obstacle}; leave out `flow`, and the motion is integrated"),
        );
    }
    let turning = turning.filter(|_| obstacles.is_empty())?;
    Some(Flow {
        linear: *linear,
        turning,
    })
}

/// What a load does, without unknown components.
pub struct Contribution {
    pub name: String,
    /// World axes.
    pub force: Components,
    /// About G, or the point that is held; body axes, of a rod world axes.
    pub moment: Components,
}

fn contributions(model: &Model, work: &mut Workspace) -> Vec<Contribution> {
    let center = model.state.center(work);
    let moments = moments_about(model, work, &model.loads, center);
    let loads = model.loads.iter().zip(moments);
    let loads: Vec<(String, Vector, Vector)> = loads
        .map(|(load, moment)| (load.name.to_string(), load.force, moment))
        .collect();
    let given = if model.motion.has_attitude() {
        given_parts(model, work, center)
    } else {
        Vec::new()
    };
    let reactions = model.reactions.iter().zip(given);
    let reactions: Vec<(String, Vector, Vector)> = reactions
        .map(|(reaction, (force, moment))| (reaction.name.to_string(), force, moment))
        .collect();
    let frame = if model.motion == Motion::Rod {
        Frame::World
    } else {
        Frame::Body
    };
    let all = loads.into_iter().chain(reactions);
    all.map(|(name, force, moment)| Contribution {
        name,
        force: work.components(force, Frame::World),
        moment: work.components(moment, frame),
    })
    .collect()
}

/// The forces that are not constant in world axes.
fn unsteady_forces(work: &Workspace, contributions: &[Contribution]) -> Vec<String> {
    let unsteady = contributions
        .iter()
        .filter(|load| !work.graph.are_early(&load.force));
    unsteady
        .map(|load| {
            let reason = dependence(work, &load.force);
            format!(
                "the force `{}` depends on {reason}, and is not constant in world axes",
                load.name
            )
        })
        .collect()
}

/// What expressions depend on: of several things, the one that is furthest from a constant.
pub fn dependence(work: &Workspace, roots: &[Id]) -> &'static str {
    let graph = &work.graph;
    let causes = graph
        .reachable(roots, |_| true)
        .into_iter()
        .filter_map(|id| match graph.node(id) {
            Node::Symbol(symbol) => cause(work.meanings.of(*symbol)),
            _ => None,
        });
    causes.min().map_or("the state", |(_, word)| word)
}

/// A rank and a word for what changes in time.
fn cause(meaning: Meaning) -> Option<(u8, &'static str)> {
    Some(match meaning {
        Meaning::Input(..) => (0, "an input (make it a parameter if it is held)"),
        Meaning::Time => (1, "the time"),
        Meaning::Velocity(_) => (2, "the velocity"),
        Meaning::Position(_) => (3, "the position"),
        Meaning::AngularVelocity(_) | Meaning::AxisRate(_) => (4, "the angular velocity"),
        Meaning::Quaternion(_) | Meaning::Axis(_) => (5, "the attitude"),
        Meaning::Angle => (6, "the angle"),
        _ => return None,
    })
}

fn turning(
    model: &Model,
    work: &mut Workspace,
    angular: &Components,
    contributions: &[Contribution],
    obstacles: &mut Vec<String>,
) -> Option<Turning> {
    if !model.motion.has_attitude() {
        return Some(Turning::None);
    }
    if model.motion.is_planar() || model.motion.is_hinged() {
        return about_axis(model, work, angular[2], contributions, obstacles);
    }
    let moments: Vec<Components> = contributions.iter().map(|load| load.moment).collect();
    let zeros = work.graph.zeros();
    let total = moments
        .into_iter()
        .fold(zeros, |sum, moment| work.graph.add_vectors(sum, moment));
    let is_free = all_vanish(work, &total);
    if model.motion == Motion::Rod {
        if is_free {
            return Some(Turning::GreatCircle);
        }
    } else if is_free {
        return free(model, work).map(Turning::Free);
    } else if let Some(turning) = symmetric(model, work, total) {
        return Some(turning);
    }
    report_moments(model, work, contributions, obstacles);
    None
}

/// How a symmetric body turns under a moment.
fn symmetric(model: &Model, work: &mut Workspace, moment: Components) -> Option<Turning> {
    if let Some(top) = lagrange_top(model, work, moment) {
        return Some(Turning::Top(top));
    }
    axial_torque(model, work, moment).map(Turning::Axial)
}

/// What is in the way of free rotation, and does not make a top or a spin that is linear in time either.
fn report_moments(
    model: &Model,
    work: &mut Workspace,
    contributions: &[Contribution],
    obstacles: &mut Vec<String>,
) {
    let center = if model.motion.is_supported() {
        "the point that is held"
    } else {
        "G"
    };
    let is_rod = model.motion == Motion::Rod;
    let is_symmetric = !is_rod && !axes_of_symmetry(model, work, &[]).is_empty();
    let (mut harmless, before) = (Vec::new(), obstacles.len());
    for load in contributions {
        if all_vanish(work, &load.moment) {
            continue;
        }
        if !is_rod && symmetric(model, work, load.moment).is_some() {
            harmless.push(format!("`{}`", load.name));
            continue;
        }
        let is_constant = work.graph.are_early(&load.moment);
        let manner = if is_constant {
            "is constant in the body".to_owned()
        } else {
            format!("depends on {}", dependence(work, &load.moment))
        };
        let reason = match (is_symmetric, is_constant) {
            _ if is_rod => "and a rod has one without moments only",
            (false, _) if is_known(model, work) => {
                "and the body is not symmetric about an axis through it"
            }
            (false, _) => {
                "and the body is not known to be symmetric: equal moments are written alike, `principal(a, a, c)`"
            }
            (true, true) => {
                "but not known to be along an axis of symmetry (of a ball, an axis of the body or a direction in numbers)"
            }
            (true, false) => "and is not that of constant forces on the axis of symmetry",
        };
        let name = &load.name;
        obstacles.push(format!(
            "the moment of `{name}` about {center} {manner}, {reason}"
        ));
    }
    if obstacles.len() == before {
        let names = harmless.join(" and ");
        obstacles.push(format!(
            "of the moments of {names} each has one alone, but not together"
        ));
    }
}

/// Whether all moments of inertia are numbers.
fn is_known(model: &Model, work: &Workspace) -> bool {
    match &model.inertia {
        Inertia::Spatial(rows) => work.graph.constant_matrix(rows).is_some(),
        _ => true,
    }
}
