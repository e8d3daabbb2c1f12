//! What was meant: names resolved, frames and dimensions checked, loads and inertia in the graph.
//!
//! The [`Outline`] of a body always exists; its [`Model`] exists if nothing was wrong.

mod arithmetic;
mod built_in;
mod composition;
mod constraint;
mod definitions;
mod dimension;
mod domains;
mod draft;
mod entries;
mod frame;
mod functions;
mod inertia;
mod load;
mod lower;
mod motion;
mod names;
mod order;
mod outline;
mod parallel_axis;
mod parameters;
mod points;
mod possible;
mod potential;
mod reaction;
mod rod;
mod scope;
mod solid;
mod support;
mod turned_inertia;
mod turned_vector;
mod turning;
mod uniform_field;
mod unit;
mod value;
mod vectors;

use proc_macro2::Ident;

use crate::errors::{Errors, Extent};
use crate::symbolic::{Components, Graph, Id, Number, Stage};
use crate::syntax::{self, Description};

pub use constraint::{Constraint, Level};
pub use frame::{Attitude, Frame, Vector, Workspace};
pub use inertia::Inertia;
pub use motion::{Axis, Meanings, Motion, State};
pub use names::{AXES, Labels, Meaning};
pub use outline::{Declared, INVERSE, Obstacle, Offer, Outline, outline, written_motion};
pub use possible::is_flat;
pub use potential::{Form, Potential, Potentials};
pub use reaction::{Reaction, is_drive, is_unknown};
pub use syntax::{Family, LoadKind};
pub use turned_vector::Turn;
pub use value::{Point, shown};

use entries::entries;
use lower::Lowering;
use parameters::Defaults;
use possible::is_possible;
use scope::{Scope, check_names};

/// A description, understood.
pub struct Model {
    pub motion: Motion,
    /// How many derivatives of each input are given: the inputs behind it.
    derivatives: Vec<usize>,
    pub state: State,
    pub mass: Option<Id>,
    pub inertia: Inertia,
    /// An inertia was written for a body that does not turn.
    pub has_idle_inertia: bool,
    pub loads: Vec<Load>,
    /// What becomes a load by differentiation.
    pub potentials: Potentials,
    /// Loads with unknown components.
    pub reactions: Vec<Reaction>,
    /// Drives with unknown components, at rest in the accelerations.
    pub drives: Vec<Reaction>,
    /// What the motion keeps at zero, by scalars.
    pub constraints: Vec<Constraint>,
    pub pole: Point,
    /// The values of the parameters that have a default.
    defaults: Defaults,
}

/// A given load: a force at a point, a moment, or both.
pub struct Load {
    pub name: Ident,
    pub family: Family,
    pub force: Vector,
    /// Where the force acts.
    pub point: Point,
    /// Without that of the force.
    pub moment: Vector,
    /// Of a potential of a rod: what draws at its axis u, `-dU/du` in world axes; the moment is `u x`
    /// this.
    pub pull: Option<Components>,
    /// The potential that it follows from, if it does: it acts all over the body, and `point` was
    /// chosen.
    pub potential: Option<Id>,
    /// What to underline if the load is at fault.
    pub extent: Extent,
    /// Where it mentions an unknown reaction.
    pub mention: Option<Extent>,
}

impl Model {
    /// Whether an input changes while it is held.
    pub fn moves(&self, input: usize) -> bool {
        self.derivatives.get(input).is_some_and(|count| *count > 0)
    }

    /// The rate of a part of an input, if it moves.
    pub fn input_rate(
        &self,
        work: &Workspace,
        input: usize,
        component: Option<usize>,
    ) -> Option<Id> {
        let rate = Meaning::Input(input + 1, component);
        let known = work.meanings.symbol_of(rate);
        let symbol = known.filter(|_| self.moves(input))?;
        Some(work.graph.symbol_id(symbol))
    }

    /// The direction of the axis of a hinge, body axes; in the plane, z.
    pub fn hinge(&self, graph: &mut Graph) -> Option<Components> {
        let support = self.state.support.filter(|_| self.motion.is_hinged())?;
        let z = [0, 0, 1].map(|component| graph.integer(component));
        Some(support.direction.unwrap_or(z))
    }

    /// The entries xx, yy, zz, xy, yz, zx of the inertia, or the one of a planar body.
    pub fn inertia_entries(&self) -> Vec<Id> {
        match self.inertia {
            Inertia::Absent => Vec::new(),
            Inertia::Scalar(moment) => vec![moment],
            Inertia::Spatial(rows) => entries(&rows).to_vec(),
        }
    }
}

/// Gives a description its meaning. `None` if anything was wrong with it.
pub fn lower_description(
    description: &Description,
    outline: &mut Outline,
    errors: &mut Errors,
) -> Option<(Model, Workspace)> {
    let repeated = check_names(description, errors);
    let mut graph = Graph::default();
    let mut meanings = Meanings::default();
    let (mut state, attitude) = motion::state_symbols(outline.motion, &mut graph, &mut meanings);
    let mut work = Workspace {
        graph,
        labels: Labels::default(),
        meanings,
        attitude,
        turns: None,
        turned: Vec::new(),
        swept: Vec::new(),
        doubtful: Vec::new(),
    };
    let mut scope = Scope::new(description, repeated);
    let mut lowering = Lowering {
        work: &mut work,
        scope: &mut scope,
        errors,
        motion: outline.motion,
        state: &mut state,
        composed: None,
        has_parts: description.composition.is_some(),
        reactions: if outline.is_constrained {
            let names = outline.reactions.iter().map(|(name, _)| name.to_string());
            names.collect()
        } else {
            Vec::new()
        },
    };

    let defaults = lowering.declarations(description, outline);
    let mass = lowering.definitions(description, &defaults);
    let inertia = lowering.inertia(description, mass, &defaults);
    let potentials = lowering.potentials(description);
    let plain = description
        .loads
        .iter()
        .filter(|load| load.charges.is_none());
    let (unknown, given): (Vec<_>, Vec<_>) = plain.partition(|load| is_unknown(load));
    let (driving, given): (Vec<_>, Vec<_>) = given.into_iter().partition(|load| is_drive(load));
    let is_asked_for = outline.rank(INVERSE).is_some();
    let drives: Vec<Option<Reaction>> = driving
        .into_iter()
        .map(|load| lowering.drive(load, is_asked_for))
        .collect();
    let constraints = lowering.constraints(description, &outline.inputs);
    let reactions: Vec<Option<Reaction>> = unknown
        .into_iter()
        .enumerate()
        .map(|(index, load)| lowering.reaction(index, load))
        .collect();
    lowering.name_reactions(description, &reactions);
    let loads: Vec<Option<Load>> = given.into_iter().map(|load| lowering.load(load)).collect();
    let pole = lowering.pole(description.pole.as_ref());

    outline.unused = unused(description, &scope);
    let loads = loads.into_iter().collect::<Option<Vec<_>>>();
    let reactions = reactions.into_iter().collect::<Option<Vec<_>>>();
    let (inertia, loads, reactions, pole) = (inertia?, loads?, reactions?, pole?);
    let (potentials, constraints) = (potentials?, constraints?);
    let motion = outline.motion;
    let model = Model {
        motion,
        derivatives: outline.inputs.iter().map(Declared::derivatives).collect(),
        state,
        mass: mass.known(),
        inertia,
        has_idle_inertia: description.inertia.is_some() && !motion.has_attitude(),
        loads,
        potentials,
        reactions,
        drives: drives.into_iter().collect::<Option<Vec<_>>>()?,
        constraints,
        pole,
        defaults,
    };
    name_properties(&model, &mut work.labels);
    Some((model, work))
}

/// Mass and inertia are called what they are, where they are computed.
fn name_properties(model: &Model, labels: &mut Labels) {
    let names = [
        "inertia_xx",
        "inertia_yy",
        "inertia_zz",
        "inertia_xy",
        "inertia_yz",
        "inertia_zx",
    ];
    let entries = model.inertia_entries();
    let names = if entries.len() == 1 {
        &["inertia"][..]
    } else {
        &names[..]
    };
    for (id, name) in entries.into_iter().zip(names) {
        labels.name(id, *name);
    }
    if let Some(mass) = model.mass {
        labels.name(mass, "mass");
    }
}

/// The names that nothing refers to; the rates of an input come with it.
fn unused(description: &Description, scope: &Scope) -> Vec<Ident> {
    let inputs = description.inputs.iter().filter(|input| input.order == 0);
    let declared = description.params.iter().chain(inputs);
    let defined = description.points.iter().chain(&description.locals);
    declared
        .map(|declaration| &declaration.name)
        .chain(defined.map(|definition| &definition.name))
        .filter(|name| !scope.is_used(name))
        .cloned()
        .collect()
}

/// Reports constants of the equations that no double can hold, with the defaults where parameters
/// have them.
pub fn check_range(
    model: &Model,
    work: &mut Workspace,
    outline: &Outline,
    roots: &[Id],
    errors: &mut Errors,
) {
    let graph = &mut work.graph;
    let early: Vec<Id> = graph
        .reachable(roots, |id| !graph.is_early(id))
        .into_iter()
        .filter(|id| graph.is_early(*id))
        .collect();
    let values = graph.substitute(&early, |id| model.defaults.get(&id).copied());
    let has_no_value = values.iter().any(|id| graph.is_undefined(*id));
    if has_no_value && domains::report_without_value(model, work, errors) {
        return;
    }
    let graph = &work.graph;
    let is_undecided = |id: &Id| graph.as_number(*id).is_some_and(Number::is_undecided);
    if values.iter().any(is_undecided) {
        errors.push(
            outline.name.span(),
            format!(
                "a constant in the equations of `{}` is zero to thousands of bits, and not proved to be \
                 zero: write it as a number, or leave it out",
                outline.name
            ),
        );
        return;
    }
    let out_of_range = |id: &Id| {
        let number = graph.as_number(*id);
        graph.is_undefined(*id) || number.is_some_and(|number| !number.fits_f64())
    };
    if values.iter().any(out_of_range) || outline.has_default() && overflows(model, work, &early) {
        let with = if outline.params.is_empty() {
            ""
        } else {
            " with the defaults of its parameters"
        };
        errors.push(
            outline.name.span(),
            format!(
                "a constant in the equations of `{}` is out of the range of `f64`{with}: choose \
                 units nearer to one",
                outline.name
            ),
        );
        return;
    }
    check_rounded_inertia(model, work, outline, errors);
}

/// Reports an inertia that is possible as it is written, and that the constructor, which computes
/// in doubles, does not find so with the defaults of all parameters.
fn check_rounded_inertia(model: &Model, work: &Workspace, outline: &Outline, errors: &mut Errors) {
    let graph = &work.graph;
    let entries = model.inertia_entries();
    let is_open = entries
        .iter()
        .any(|id| graph.stage(*id) == Stage::Parameter);
    if !is_open || !outline.has_default() {
        return;
    }
    let default = |symbol: Id| graph.as_number(*model.defaults.get(&symbol)?);
    let rounded = graph.evaluate(&entries, |symbol| {
        default(symbol).map_or(f64::NAN, Number::to_f64)
    });
    if !is_possible(&rounded) {
        errors.push(
            outline.name.span(),
            format!(
                "with the defaults of its parameters the inertia of `{}` about G is lost in \
                 rounding: write it about a point nearer to G",
                outline.name
            ),
        );
    }
}

/// Whether the constructor, which computes in doubles step by step, leaves their range with the
/// defaults of all parameters, on its way to one of the `early` values or to mass and inertia.
fn overflows(model: &Model, work: &Workspace, early: &[Id]) -> bool {
    let graph = &work.graph;
    let wanted = early.iter().copied().chain(model.inertia_entries());
    let wanted: Vec<Id> = wanted.chain(model.mass).collect();
    let default = |symbol: Id| graph.as_number(*model.defaults.get(&symbol)?);
    let values = graph.evaluate(&wanted, |symbol| {
        default(symbol).map_or(f64::NAN, Number::to_f64)
    });
    values.iter().any(|value| !value.is_finite())
}
