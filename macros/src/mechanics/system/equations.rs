//! The equations of motion of a system, and its report.

use crate::errors::Errors;
use crate::mechanics::Report;
use crate::mechanics::answers::{Partial, Switch, derive_switches, list_partial, parts};
use crate::mechanics::following::{Added, takes_inertia, unknowns_in};
use crate::mechanics::report::list_laws_of_system;
use crate::mechanics::tree::link::{Link, Tree};
use crate::mechanics::tree::{self, Built, SolvedTree};
use crate::model::{Own, Property, System, Tie, TreeJoint, Workspace};
use crate::symbolic::Id;

use super::closed::{Closed, Coordinates, check_closed, check_kept, check_lost, close};
use super::constraints::replace;
use super::independence::check_independence;
use super::motion::{motion, positions};
use super::rates::{order, rates};

/// The equations of motion of a system.
pub struct SystemEquations {
    /// The accelerations of the freedoms of each joint.
    pub accelerations: Vec<Vec<Id>>,
    pub switches: Vec<Switch>,
    pub partial: Vec<Partial>,
    left_out: Vec<String>,
    /// For each joint, whether it moves by the balances of a single body.
    pub(super) alone: Vec<bool>,
    /// The tree after the reductions, with the chosen origins and axes.
    pub(super) reduced: Tree,
    pub(super) built: Built,
    /// The inertia that loads add, if this is all that they do with accelerations.
    added: Option<Added>,
    /// The symbols that loads may depend on, with their solutions: first those of the loads of
    /// written constraints, then those of accelerations.
    settled: Vec<(Id, Id)>,
    /// The tree with all loads on its links, also those of constraints.
    loaded: Tree,
    /// What is solved for under constraints, or if loads depend on accelerations in any other way.
    pub(super) closed: Option<Closed>,
}

/// Derives the equations of motion of a system.
pub fn derive_system(system: &System, work: &mut Workspace) -> SystemEquations {
    let built = tree::build(system, work);
    let added = Added::of(system, work, &built);
    let given = match &added {
        Some(added) => added.by_symbols(work, &built.tree),
        None => built.tree.clone(),
    };
    let (mut loaded, mut closed) = (given.clone(), None);
    let mut found = match &added {
        Some(added) if system.is_tree() => {
            let tree = added.put_into(work, &built.tree);
            tree::derive_tree(&mut work.graph, &mut work.labels, &tree)
        }
        _ => {
            let motion = motion(system, work);
            let coordinates = coordinates(system, work, &built);
            let sides = (&motion, &coordinates);
            let (accelerations, constraints) =
                close(system, work, (&built, added.as_ref()), sides, &mut loaded);
            closed = Some(constraints);
            SolvedTree {
                accelerations,
                left_out: Vec::new(),
                reduced: given.clone(),
            }
        }
    };
    let mut settled = Vec::new();
    let follow = added.as_ref().is_none_or(|added| !added.is_nothing());
    if follow || closed.is_some() {
        // outputs use the loads as functions of the accelerations
        found.reduced = given;
        let loads = closed.as_ref().map_or(&[][..], |closed| &closed.loads);
        settled = solved(system, loads, &found.accelerations);
        loaded.replace(&mut work.graph, &settled);
    }
    let joints = built.links.iter().enumerate().map(|(joint, links)| {
        let of_tree = found.accelerations[links.clone()].concat();
        let alone = closed.is_none().then(|| tree::alone(system, work, joint));
        shorter(work, of_tree, alone.flatten())
    });
    let (accelerations, alone): (Vec<Vec<Id>>, Vec<bool>) = joints.unzip();
    label(system, work, &accelerations);
    let switches = switches(system, work, &accelerations, closed.as_ref());
    let mut loads = loads(system, work);
    for (_, parts) in &mut loads {
        *parts = replace(&mut work.graph, parts, &settled);
    }
    SystemEquations {
        switches,
        partial: list_partial(loads, work),
        accelerations,
        left_out: found.left_out,
        alone,
        reduced: found.reduced,
        built,
        added,
        settled,
        loaded,
        closed,
    }
}

/// The accelerations of a joint, by the balances of its body alone where these take no more
/// operations, and whether they do.
fn shorter(work: &mut Workspace, of_tree: Vec<Id>, alone: Option<Vec<Id>>) -> (Vec<Id>, bool) {
    let cost = |all: &[Id]| work.graph.late_cost(all).total();
    let alone = alone.filter(|alone| cost(alone) <= cost(&of_tree));
    let is_alone = alone.is_some();
    let shorter = alone.unwrap_or(of_tree).into_iter();
    let results = shorter.map(|one| work.graph.result(one));
    (results.collect(), is_alone)
}

fn label(system: &System, work: &mut Workspace, accelerations: &[Vec<Id>]) {
    for (joint, found) in system.joints.iter().zip(accelerations) {
        let names = joint.kind.shape.into_iter().flat_map(|shape| shape.second);
        let names = names.flat_map(|field| field.names);
        for (id, name) in found.iter().zip(names) {
            work.labels.name(*id, format!("{}_{name}", joint.name));
        }
    }
}

/// The times at which the accelerations, the rates of user-defined states or the constraints change.
fn switches(
    system: &System,
    work: &mut Workspace,
    accelerations: &[Vec<Id>],
    closed: Option<&Closed>,
) -> Vec<Switch> {
    let Some(body) = system.bodies.first() else {
        return Vec::new();
    };
    let mut roots = accelerations.concat();
    roots.extend(system.states.iter().map(|state| state.rate));
    let rows = closed.into_iter().flat_map(Closed::rows);
    roots.extend(rows.flat_map(|row| row.value.into_iter().chain([row.rate])));
    derive_switches(body.state.time, &system.derivatives, work, &roots)
}

impl SystemEquations {
    /// The tree with all loads on its links, also those of constraints.
    pub(super) fn loaded(&self) -> &Tree {
        &self.loaded
    }

    /// What `new` checks so that loads add inertia.
    pub fn conditions(&self) -> Vec<Property> {
        let added = self.added.as_ref();
        added.map_or(Vec::new(), |added| added.conditions.clone())
    }

    /// A form of the tree with the inertia that loads add, if this is all that they do with
    /// accelerations.
    pub(super) fn resisting(&self, work: &mut Workspace, tree: &Tree) -> Tree {
        match &self.added {
            Some(added) => added.put_into(work, tree),
            None => tree.clone(),
        }
    }

    /// The symbols of accelerations and of the loads of constraints, each with its solution.
    pub fn solved(&self, system: &System) -> Vec<(Id, Id)> {
        solved(system, self.kept_loads(), &self.accelerations)
    }

    /// The solutions for the symbols that loads depend on.
    pub fn values(&self) -> &[(Id, Id)] {
        &self.settled
    }

    /// The load of each written constraint.
    pub fn kept_loads(&self) -> &[Id] {
        let closed = self.closed.as_ref();
        closed.map_or(&[], |closed| &closed.loads)
    }

    /// Reports joints that depend on each other, written constraints that are trivial or redundant,
    /// and loads that cancel all inertia.
    pub fn check(&self, system: &System, work: &mut Workspace, errors: &mut Errors) -> Option<()> {
        let Some(closed) = &self.closed else {
            let tree = self.resisting(work, &self.built.tree);
            return check_independence(system, work, (&self.built, &tree), errors);
        };
        let given = loads(system, work).into_iter().flat_map(|(_, parts)| parts);
        let followed = unknowns_in(work, &given.collect::<Vec<Id>>());
        check_closed(system, work, &closed.kept, errors)?;
        check_lost(system, &closed.kept, errors)?;
        check_kept(system, work, (&closed.undetermined, &followed), errors)?;
        if closed.undetermined.light.is_empty() {
            return Some(());
        }
        check_independence(system, work, (&self.built, &self.built.tree), errors)?;
        let loads = system.bodies.iter().flat_map(|body| &body.loads);
        let loads = loads.map(|load| (&load.name, parts(load, work).1));
        let drives = system.joints.iter().flat_map(|joint| &joint.driven_by);
        let drives = drives.map(|(name, parts)| (name, parts.clone()));
        let mut all = loads.chain(drives);
        let (name, _) = all.find(|(_, parts)| !work.accelerations_in(parts).is_empty())?;
        errors.report(name.span(), takes_inertia(&name.to_string()))
    }
}

/// How the state changes with the rates of the open coordinates.
fn coordinates(system: &System, work: &mut Workspace, built: &Built) -> Coordinates {
    let freedoms = built.tree.links.iter().flat_map(Link::open);
    let mut by_freedom = vec![work.graph.zero(); freedoms.count()];
    for (freedom, rate) in order(system, built).into_iter().zip(rates(system)) {
        by_freedom[freedom] = rate;
    }
    let open = system.joints.iter().filter(|joint| !joint.is_driven());
    Coordinates {
        rates: by_freedom,
        places: open.flat_map(|joint| positions(work, joint)).collect(),
    }
}

/// The symbols of the loads of written constraints and of accelerations, each with its solution.
fn solved(system: &System, loads: &[Id], accelerations: &[Vec<Id>]) -> Vec<(Id, Id)> {
    let loads = system.constraints.loads.iter().zip(loads);
    let open = system.joints.iter().filter(|joint| !joint.is_driven());
    let symbols: Vec<Id> = open.flat_map(TreeJoint::accelerations).collect();
    let moved = symbols.iter().zip(accelerations.iter().flatten());
    let all = loads.chain(moved);
    all.map(|(symbol, value)| (*symbol, *value)).collect()
}

/// The names of all loads and drives, and of the rates of user-defined states, with their
/// components.
pub fn loads(system: &System, work: &Workspace) -> Vec<(String, Vec<Id>)> {
    let loads = system.bodies.iter().flat_map(|body| &body.loads);
    let loads = loads.map(|load| parts(load, work));
    let drives = system.joints.iter().flat_map(|joint| &joint.driven_by);
    let drives = drives.map(|(name, parts)| (name.to_string(), parts.clone()));
    let rates = system.states.iter().map(Own::named_rate);
    loads.chain(drives).chain(rates).collect()
}

/// Text such as "`rope`: between `mast` and the ground".
fn described(tie: &Tie) -> String {
    let ends = tie.bodies.each_ref().map(|body| match body {
        Some(body) => format!("`{body}`"),
        None => "the ground".to_owned(),
    });
    format!("`{}`: between {} and {}", tie.name, ends[0], ends[1])
}

/// Describes the bodies and joints of a system, and the terms that do not appear in its equations.
pub fn describe_system(
    system: &System,
    work: &mut Workspace,
    equations: &SystemEquations,
) -> Report {
    let name = |body: usize| format!("`{}`", system.bodies[body].name);
    let joints = system.connections().enumerate().map(|(number, joint)| {
        let carrier = joint.carrier.map_or("the ground".to_owned(), name);
        let (kind, carried) = (joint.kind.word, name(joint.carried));
        let closes = if number < system.joints.len() {
            ""
        } else {
            ", closes a loop"
        };
        format!(
            "`{}`: {kind} from {carrier} to {carried}{closes}",
            joint.name
        )
    });
    let mut skipped = equations.left_out.clone();
    if !work.graph.is_zero_vector(&system.gravity) {
        skipped
            .push("the weight of each body: the ground accelerates against it instead".to_owned());
    }
    let mut lists = vec![("Joints", joints.collect())];
    for (heading, ties) in [("Links", &system.links), ("Cables", &system.cables)] {
        if !ties.is_empty() {
            lists.push((heading, ties.iter().map(described).collect()));
        }
    }
    let laws = list_laws_of_system(system, work);
    Report {
        laws,
        lists,
        skipped,
    }
}
