//! The balances of each body, written as laws: its mass or inertia, and the names of the loads.

use crate::families::LoadKind;
use crate::mechanics::balances::inertia_about_center;
use crate::model::{Inertia, Load, Model, Point, State, System, TreeJoint, Workspace};
use crate::symbolic::{Components, Graph, Id, Number};

/// A balance of a body.
pub struct Law {
    /// The name of the body, if it is one of a system.
    pub body: Option<String>,
    pub left: Left,
    pub right: Vec<Term>,
}

/// The left side of a balance. Entries that are not constant are `None`.
pub enum Left {
    /// `m a`
    Force(Option<Number>),
    /// `J φ″`, about the normal of a plane
    Plane(Option<Number>),
    /// `n · J n φ″`, about a held axis
    Axis(Entries),
    /// `J ω′ + ω × J ω`
    Tensor(Entries),
    /// `J u × u″`, of a rod
    Line(Option<Number>),
}

/// A tensor, by rows.
type Entries = [[Option<Number>; 3]; 3];

/// A term of the right side, by the name of its load.
pub struct Term {
    pub name: String,
    pub part: Part,
    /// Whether the load acts on another body, and its opposite on this one.
    pub is_opposite: bool,
}

#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Part {
    Force,
    Moment,
    /// `r × F`
    MomentOfForce,
}

/// The laws of a single body.
pub fn list_laws(model: &Model, work: &mut Workspace) -> Vec<Law> {
    let mut terms = Vec::new();
    let held = model.state.support.map(|support| support.offset);
    for load in &model.loads {
        add_load(&mut terms, load, (&model.state, held), work);
    }
    for reaction in &model.reactions {
        let name = reaction.name.to_string();
        match reaction.kind {
            LoadKind::Force => {
                let has_arm = has_arm(reaction.point, (&model.state, held), work);
                add_force(&mut terms, &name, has_arm, false);
            }
            LoadKind::Moment => terms.push(Term::new(&name, Part::Moment, false)),
        }
    }
    let inertia = inertia_about_center(model, work);
    let graph = &work.graph;
    let mut lefts = Vec::new();
    if model.motion.translates() || !model.reactions.is_empty() {
        lefts.extend(model.mass.map(|mass| Left::Force(number(graph, mass))));
    }
    if model.motion.has_attitude() {
        lefts.extend(match inertia {
            Inertia::Absent => None,
            Inertia::Scalar(moment) if model.motion.is_line() => {
                Some(Left::Line(number(graph, moment)))
            }
            Inertia::Scalar(moment) => Some(Left::Plane(number(graph, moment))),
            Inertia::Spatial(rows) if model.motion.is_hinged() && model.reactions.is_empty() => {
                Some(Left::Axis(entries(graph, &rows)))
            }
            Inertia::Spatial(rows) => Some(Left::Tensor(entries(graph, &rows))),
        });
    }
    laws(None, lefts, terms)
}

/// The laws of each body of a system. A joint acts on both of its bodies.
pub fn list_laws_of_system(system: &System, work: &mut Workspace) -> Vec<Law> {
    let mut all = Vec::new();
    let is_loaded = |joint: &&TreeJoint| !joint.kind.is_free() || !joint.driven_by.is_empty();
    let tree = system.joints.iter().filter(is_loaded);
    let tree = tree.map(|joint| (&joint.name, joint.carrier, joint.carried));
    let closings = system.closings.iter();
    let closings = closings.map(|joint| (&joint.name, joint.carrier, joint.carried));
    let joints: Vec<_> = tree.chain(closings).collect();
    for (number_of_body, body) in system.bodies.iter().enumerate() {
        if work.graph.is_zero(body.mass) {
            continue;
        }
        let mut terms = Vec::new();
        for load in body.weights.iter().chain(&body.loads) {
            add_load(&mut terms, load, (&body.state, None), work);
        }
        for (name, carrier, carried) in &joints {
            let is_opposite = *carrier == Some(number_of_body);
            if is_opposite || *carried == number_of_body {
                let name = name.to_string();
                add_force(&mut terms, &name, true, is_opposite);
                terms.push(Term::new(&name, Part::Moment, is_opposite));
            }
        }
        // any part of the load of a constraint may be zero
        for constraint in &system.constraints.list {
            add_force(&mut terms, &constraint.name, true, false);
            terms.push(Term::new(&constraint.name, Part::Moment, false));
        }
        let graph = &work.graph;
        let rotation = match body.inertia {
            Inertia::Absent => None,
            Inertia::Scalar(moment) => Some(Left::Plane(number(graph, moment))),
            Inertia::Spatial(rows) => Some(Left::Tensor(entries(graph, &rows))),
        };
        let mut lefts = vec![Left::Force(number(graph, body.mass))];
        lefts.extend(rotation);
        all.extend(laws(Some(&body.name.to_string()), lefts, terms));
    }
    all
}

impl Left {
    fn is_of_forces(&self) -> bool {
        matches!(self, Self::Force(_))
    }
}

impl Term {
    fn new(name: &str, part: Part, is_opposite: bool) -> Self {
        Self {
            name: name.to_owned(),
            part,
            is_opposite,
        }
    }
}

fn laws(body: Option<&str>, lefts: Vec<Left>, terms: Vec<Term>) -> Vec<Law> {
    let [forces, moments]: [Vec<Term>; 2] = {
        let parts = terms.into_iter().partition(|term| term.part == Part::Force);
        [parts.0, parts.1]
    };
    let mut sides = [Some(forces), Some(moments)];
    let laws = lefts.into_iter().map(|left| Law {
        body: body.map(str::to_owned),
        right: sides[usize::from(!left.is_of_forces())]
            .take()
            .unwrap_or_default(),
        left,
    });
    laws.collect()
}

fn add_load(
    terms: &mut Vec<Term>,
    load: &Load,
    about: (&State, Option<Components>),
    work: &mut Workspace,
) {
    let name = load.name.to_string();
    if !load.force.is_zero() {
        let has_arm = load.potential.is_none() && has_arm(load.point, about, work);
        add_force(terms, &name, has_arm, false);
    }
    if !load.moment.is_zero() {
        terms.push(Term::new(&name, Part::Moment, false));
    }
}

fn add_force(terms: &mut Vec<Term>, name: &str, has_arm: bool, is_opposite: bool) {
    terms.push(Term::new(name, Part::Force, is_opposite));
    if has_arm {
        terms.push(Term::new(name, Part::MomentOfForce, is_opposite));
    }
}

/// Whether a point differs from G, or from the held point.
fn has_arm(
    point: Point,
    (state, held): (&State, Option<Components>),
    work: &mut Workspace,
) -> bool {
    let graph = &mut work.graph;
    let held = held.unwrap_or_else(|| graph.zeros());
    point.offset(state.body).is_none_or(|offset| {
        let arm = graph.subtract_vectors(offset, held);
        !graph.is_zero_vector(&arm)
    })
}

fn number(graph: &Graph, id: Id) -> Option<Number> {
    graph.as_number(id).cloned()
}

fn entries(graph: &Graph, rows: &[Components; 3]) -> Entries {
    rows.map(|row| row.map(|id| number(graph, id)))
}
