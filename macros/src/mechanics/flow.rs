//! Motions in closed form: which one a body has, or what is in the way of it.
//!
//! G moves on a parabola if nothing but constant forces, in world axes, act on the body. Apart from that
//! it turns
//!
//! ```text
//! in space        freely: no moment about G, or about the point that is held
//! about an axis   with constant acceleration, or as a pendulum: w' = a sin theta + b cos theta
//! as a rod        freely, along a great circle
//! ```

use crate::errors::{Errors, Extent};
use crate::model::{Frame, Inertia, Meaning, Model, Motion, Vector};
use crate::symbolic::{Components, Function, Id, Node, Spectrum, Symmetry};

use super::dyadic::constant;
use super::newton_euler::{inertia_about_center, moments_about};
use super::reactions::given_parts;
use super::samples::vanish;

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
    /// As a rod, without a moment.
    GreatCircle,
    /// About an axis, with a constant acceleration.
    Uniform(Id),
    /// About an axis: `theta'' = -rate^2 sin(theta - hanging)`
    Pendulum { rate: Id, hanging: Id },
}

/// What the free rotation of a body depends on.
pub enum Free {
    /// All moments of inertia are equal.
    Steady,
    /// The moments across an axis and along it, and its unit vector, body axes.
    Symmetric([Id; 2], Components),
    /// Three principal moments, and unit vectors of their axes, body axes.
    Principal([Id; 3], [Components; 3]),
    /// The entries xx, yy, zz, xy, yz, zx of a tensor that is known when the body is built.
    Tensor([Id; 6]),
}

impl Flow {
    pub fn roots(&self) -> Vec<Id> {
        let mut roots = self.linear.to_vec();
        roots.extend(self.turning.roots());
        roots
    }

    /// Which motion it is, line by line.
    pub fn describe(&self, motion: Motion) -> Vec<String> {
        let center = motion.translates().then_some("G moves on a parabola");
        let turning = match &self.turning {
            Turning::None => None,
            Turning::Free(Free::Steady) => Some("the body turns at a constant rate"),
            Turning::Free(Free::Symmetric(..)) => Some("the body precesses steadily"),
            Turning::Free(Free::Principal(..)) => Some("the body turns by elliptic functions"),
            Turning::Free(Free::Tensor(_)) => {
                Some("the body turns freely, in a way that its moments of inertia decide")
            }
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
            Self::None | Self::GreatCircle | Self::Free(Free::Steady) => Vec::new(),
            Self::Free(Free::Symmetric(moments, axis)) => [&moments[..], &axis[..]].concat(),
            Self::Free(Free::Principal(moments, axes)) => {
                [&moments[..], &axes.concat()[..]].concat()
            }
            Self::Free(Free::Tensor(entries)) => entries.to_vec(),
            Self::Uniform(acceleration) => vec![*acceleration],
            Self::Pendulum { rate, hanging } => vec![*rate, *hanging],
        }
    }
}

/// The closed form. All that is in its way is reported at the place where it is asked for.
pub fn derive_flow(
    model: &mut Model,
    place: Extent,
    linear: &Components,
    angular: &Components,
    errors: &mut Errors,
) -> Option<Flow> {
    if !model.constraints.is_empty() {
        errors.push(
            place,
            "under constraints there is no closed form in this version: use a motion with a support",
        );
        return None;
    }
    let contributions = contributions(model);
    let mut obstacles = Vec::new();
    if !model.frames.graph.are_early(linear) {
        obstacles.extend(unsteady_forces(model, &contributions));
    }
    let turning = turning(model, angular, &contributions, &mut obstacles);
    obstacles.dedup();
    for obstacle in &obstacles {
        errors.push(place, format!("no closed form: {obstacle}"));
    }
    let turning = turning.filter(|_| obstacles.is_empty())?;
    Some(Flow {
        linear: *linear,
        turning,
    })
}

/// What a load does, without unknown components.
struct Contribution {
    name: String,
    /// World axes.
    force: Components,
    /// About G, or the point that is held; body axes, of a rod world axes.
    moment: Components,
}

fn contributions(model: &mut Model) -> Vec<Contribution> {
    let center = model.state.center(&mut model.frames);
    let moments = moments_about(model, center);
    let loads = model.loads.iter().zip(moments);
    let loads: Vec<(String, Vector, Vector)> = loads
        .map(|(load, moment)| (load.name.to_string(), load.force, moment))
        .collect();
    let given = if model.motion.has_attitude() {
        given_parts(model, center)
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
        force: model.frames.components(force, Frame::World),
        moment: model.frames.components(moment, frame),
    })
    .collect()
}

/// The forces that are not constant in world axes.
fn unsteady_forces(model: &Model, contributions: &[Contribution]) -> Vec<String> {
    let unsteady = contributions
        .iter()
        .filter(|load| !model.frames.graph.are_early(&load.force));
    unsteady
        .map(|load| {
            let reason = dependence(model, &load.force);
            format!(
                "the force `{}` depends on {reason}, and only forces that are constant in world axes \
                 make a parabola of the path of G",
                load.name
            )
        })
        .collect()
}

/// What expressions depend on: of several things, the one that is furthest from a constant.
fn dependence(model: &Model, roots: &[Id]) -> &'static str {
    let graph = &model.frames.graph;
    let causes = graph
        .reachable(roots, |_| true)
        .into_iter()
        .filter_map(|id| match graph.node(id) {
            Node::Symbol(symbol) => cause(model.meanings.of(*symbol)),
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
    model: &mut Model,
    angular: &Components,
    contributions: &[Contribution],
    obstacles: &mut Vec<String>,
) -> Option<Turning> {
    if !model.motion.has_attitude() {
        return Some(Turning::None);
    }
    if model.motion.is_planar() || model.motion.is_hinged() {
        return about_axis(model, angular[2], contributions, obstacles);
    }
    let moments: Vec<Components> = contributions.iter().map(|load| load.moment).collect();
    let zeros = model.frames.graph.zeros();
    let total = moments.into_iter().fold(zeros, |sum, moment| {
        model.frames.graph.add_vectors(sum, moment)
    });
    if !vanish(model, &total).into_iter().all(|zero| zero) {
        let center = if model.motion.is_supported() {
            "the point that is held"
        } else {
            "G"
        };
        for load in contributions {
            if !vanish(model, &load.moment).into_iter().all(|zero| zero) {
                obstacles.push(format!(
                    "`{}` has a moment about {center}, and only rotation without a moment has one",
                    load.name
                ));
            }
        }
        return None;
    }
    if model.motion == Motion::Rod {
        return Some(Turning::GreatCircle);
    }
    free(model).map(Turning::Free)
}

/// The principal axes of a tensor of numbers are found here, at any precision.
fn free(model: &mut Model) -> Option<Free> {
    let Inertia::Spatial(rows) = inertia_about_center(model) else {
        return None;
    };
    let graph = &mut model.frames.graph;
    let Some(tensor) = constant(graph, &rows) else {
        let [xx, yy, zz] = [0, 1, 2].map(|i| rows[i][i]);
        return Some(Free::Tensor([
            xx, yy, zz, rows[0][1], rows[1][2], rows[2][0],
        ]));
    };
    Some(match Spectrum::of(&tensor) {
        Spectrum::Spherical(_) => Free::Steady,
        Spectrum::Symmetric(symmetry) => {
            let Symmetry {
                across,
                along,
                axis,
            } = *symmetry;
            let axis = axis.map(|component| graph.number(component));
            let (norm, one) = (graph.norm(axis), graph.one());
            let inverse = graph.divide(one, norm);
            let unit = graph.scale_vector(inverse, axis);
            Free::Symmetric([across, along].map(|moment| graph.number(moment)), unit)
        }
        Spectrum::General(principal) => Free::Principal(
            principal.moments.map(|moment| graph.number(moment)),
            principal
                .axes
                .map(|axis| axis.map(|component| graph.number(component))),
        ),
    })
}

/// What a load makes of the motion about an axis.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Kind {
    Constant,
    /// `a sin theta + b cos theta`
    Swinging,
    Other,
}

fn about_axis(
    model: &mut Model,
    acceleration: Id,
    contributions: &[Contribution],
    obstacles: &mut Vec<String>,
) -> Option<Turning> {
    if model.frames.graph.is_early(acceleration) {
        return Some(Turning::Uniform(acceleration));
    }
    if let Some((sine, cosine)) = swinging(model, acceleration) {
        let graph = &mut model.frames.graph;
        let square = graph.apply(Function::Hypot, &[sine, cosine]);
        let rate = graph.apply(Function::Sqrt, &[square]);
        let opposite = graph.negate(sine);
        let hanging = graph.apply(Function::Atan2, &[cosine, opposite]);
        let labels = &mut model.frames.labels;
        labels.name(rate, "swing_rate");
        labels.name(hanging, "hanging");
        return Some(Turning::Pendulum { rate, hanging });
    }
    let axis = match model.hinge() {
        Some(axis) => axis,
        None => [0, 0, 1].map(|component| model.frames.graph.integer(component)),
    };
    let kinds: Vec<(&Contribution, Id, Kind)> = contributions
        .iter()
        .filter_map(|load| {
            let moment = model.frames.graph.dot(axis, load.moment);
            if model.frames.graph.is_zero(moment) {
                return None;
            }
            let kind = if model.frames.graph.is_early(moment) {
                Kind::Constant
            } else if swinging(model, moment).is_some() {
                Kind::Swinging
            } else {
                Kind::Other
            };
            Some((load, moment, kind))
        })
        .collect();
    let of = |wanted: Kind| kinds.iter().filter(move |(_, _, kind)| *kind == wanted);
    let others = of(Kind::Other).map(|(load, moment, _)| {
        format!(
            "the moment of `{}` depends on {}, and only constant moments, or those of constant forces \
             in world axes, which make a pendulum, have one",
            load.name,
            dependence(model, &[*moment])
        )
    });
    let before = obstacles.len();
    obstacles.extend(others);
    if let (true, Some((steady, ..)), Some((weight, ..))) = (
        obstacles.len() == before,
        of(Kind::Constant).next(),
        of(Kind::Swinging).next(),
    ) {
        obstacles.push(format!(
            "the moment of `{}` is constant and that of `{}` makes a pendulum: either has one, both \
             together have not",
            steady.name, weight.name
        ));
    }
    None
}

/// `(a, b)` of `a sin theta + b cos theta`.
fn swinging(model: &mut Model, expression: Id) -> Option<(Id, Id)> {
    let angle = model.angle()?;
    let graph = &mut model.frames.graph;
    let of_late = |id: Id| !graph.is_early(id) && id != angle;
    if graph.depends_on(&[expression], of_late) {
        return None;
    }
    let slope = graph.derivative(&[expression], angle)[0];
    let zero = graph.zero();
    let at_zero = graph.substitute(&[slope, expression], |id| (id == angle).then_some(zero));
    let (a, b) = (at_zero[0], at_zero[1]);
    let sine = graph.apply(Function::Sin, &[angle]);
    let cosine = graph.apply(Function::Cos, &[angle]);
    let (first, second) = (graph.multiply(a, sine), graph.multiply(b, cosine));
    let harmonic = graph.add(first, second);
    let rest = graph.subtract(expression, harmonic);
    vanish(model, &[rest])[0].then_some((a, b))
}
