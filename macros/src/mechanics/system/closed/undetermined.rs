//! Overconstrained systems: loads that the equations do not determine.

use std::collections::BTreeSet;

use crate::errors::Errors;
use crate::mechanics::proofs::may_vanish;
use crate::mechanics::tree::link::Tree;
use crate::mechanics::tree::{Built, Properties};
use crate::mechanics::unknowns::{dependent, lost, trivial};
use crate::model::{System, Workspace};
use crate::symbolic::{Components, Elimination, Equation, Graph, Id, Node};

use super::super::constraints::ConstraintRow;
use super::rows::{Known, Owner};

/// Which loads the equations do not determine, by the index of what they belong to.
#[derive(Default)]
pub struct Undetermined {
    /// Loads that balance each other, so that they may be added to any solution.
    pub spare: Vec<Spare>,
    /// Written constraints that are trivial or redundant, each with the names of those that it
    /// follows from.
    pub written: Vec<(usize, BTreeSet<String>)>,
    /// Coordinates without inertia.
    pub light: Vec<usize>,
    /// The first axis of each joint that has one, in world axes: first the joints of the tree, then
    /// those that close loops. Only known if there are spare loads.
    pub axes: Vec<Option<Components>>,
}

/// A state of self-stress: loads that balance each other on all bodies. Those of a joint are its
/// force and moment on the carried body, at its point on that body, in world axes.
pub struct Spare {
    /// The loads of joints that close loops.
    pub closings: Vec<[Components; 2]>,
    /// The loads of joints of the tree.
    pub joints: Vec<[Components; 2]>,
    /// The loads of written constraints.
    pub loads: Vec<Id>,
}

impl Spare {
    /// Made from the loads of the joints that close loops, and the effect of written constraints on
    /// the links of a `tree` without other loads.
    pub fn new(
        graph: &mut Graph,
        known: &Known<'_>,
        tree: &Tree,
        (closings, loads): (Vec<[Components; 2]>, Vec<Id>),
    ) -> Self {
        let placed = &known.placed;
        let links = known.built.links.iter().map(|links| links.end - 1);
        let joints = links.map(|link| {
            let is_above = |other: usize| tree.is_above(other, link);
            let mut sums = [graph.zeros(); 2];
            for (number, other) in tree.links.iter().enumerate() {
                if is_above(number) {
                    let pair = [other.force, other.moment];
                    let pair = pair.map(|part| placed[number].to_frame(graph, part));
                    subtract_at(
                        graph,
                        &mut sums,
                        pair,
                        (placed[number].origin, placed[link].origin),
                    );
                }
            }
            for (ends, wrench) in known.ends.iter().zip(&closings) {
                let [on_carrier, on_carried] = ends.links.map(|link| link.is_some_and(is_above));
                let Some(carried) = ends.links[1].filter(|_| on_carried != on_carrier) else {
                    continue;
                };
                let place = placed[carried].spot(graph, ends.offsets[1]).place;
                let wrench = if on_carried {
                    *wrench
                } else {
                    wrench.map(|part| graph.negate_vector(part))
                };
                subtract_at(graph, &mut sums, wrench, (place, placed[link].origin));
            }
            sums
        });
        Self {
            joints: joints.collect(),
            closings,
            loads,
        }
    }

    /// The load of a joint, by its index; joints that close loops come after those of the tree.
    pub fn wrench(&self, joint: usize) -> [Components; 2] {
        let behind = joint.checked_sub(self.joints.len());
        behind.map_or_else(|| self.joints[joint], |closing| self.closings[closing])
    }
}

/// Subtracts a force and a moment that act at one place from their sums about another place.
fn subtract_at(
    graph: &mut Graph,
    sums: &mut [Components; 2],
    [force, moment]: [Components; 2],
    (place, center): (Components, Components),
) {
    let arm = graph.subtract_vectors(place, center);
    let lever = graph.cross(arm, force);
    let whole = graph.add_vectors(moment, lever);
    for (sum, part) in sums.iter_mut().zip([force, whole]) {
        *sum = graph.subtract_vectors(*sum, part);
    }
}

impl Undetermined {
    /// Adds a constraint whose load is not determined, with the names of those that can replace it.
    pub fn add(&mut self, owner: &Owner, others: BTreeSet<String>) {
        if let Owner::Written(number) = owner {
            self.written.push((*number, others));
        }
    }
}

/// The equations for the loads that cancel the effect of one unit of the load of a column.
pub fn without_column(graph: &mut Graph, equations: &[Equation], column: usize) -> Vec<Equation> {
    let equations = equations.iter().map(|equation| {
        let mut equation = equation.clone();
        let unit = equation.coefficients.remove(column);
        equation.sample.remove(column);
        equation.sizes.remove(column);
        equation.right = graph.negate(unit);
        equation
    });
    equations.collect()
}

/// The tree without loads, and with bodies without mass.
pub fn bare(graph: &Graph, built: &Built) -> Tree {
    let mut tree = built.tree.clone();
    tree.gravity = graph.zeros();
    for link in &mut tree.links {
        link.properties = Properties::none(graph);
        (link.force, link.moment) = (graph.zeros(), graph.zeros());
        for freedom in &mut link.freedoms {
            freedom.drive = graph.zero();
        }
    }
    tree
}

/// The rows whose loads are not determined, each with the rows that can replace it.
pub fn open(solved: &Elimination, count: usize) -> Vec<(usize, Vec<usize>)> {
    let row = |column: &usize| column.checked_sub(count);
    let undetermined = solved.undetermined.iter();
    let open = undetermined.filter_map(|one| {
        let others = one.others.iter().filter_map(row).collect();
        Some((row(&one.column)?, others))
    });
    open.collect()
}

/// Whether no motion changes the distance that these rows of a joint measure together, and it is not
/// zero. A carrier that rotates in the plane turns the axes of the rows; the sum of the squares stays.
/// Parameters may have values that make the distance zero.
fn are_held_apart(work: &mut Workspace, rows: &[&ConstraintRow]) -> bool {
    let graph = &mut work.graph;
    let mut slopes = rows.iter().flat_map(|row| &row.slopes);
    if !slopes.all(|slope| graph.vanishes(*slope)) {
        return false;
    }
    let measured = rows.iter().filter_map(|row| Some((row.value?, row.rate)));
    let (values, rates): (Vec<Id>, Vec<Id>) = measured.unzip();
    let is_decided = |id: Id| match graph.node(id) {
        Node::Number(number) => !number.is_undecided(),
        Node::Symbol(_) => !graph.is_early(id),
        _ => true,
    };
    if !graph.nodes_of(&values).into_iter().all(is_decided) {
        return false;
    }
    let [square, change] = [&values, &rates].map(|factors| graph.inner(&values, factors));
    graph.vanishes(change) && !may_vanish(work, square)
}

/// Reports joints that close loops which no motion can close, because other joints hold both of their
/// ends.
pub fn check_closed(
    system: &System,
    work: &mut Workspace,
    kept: &[(Owner, ConstraintRow)],
    errors: &mut Errors,
) -> Option<()> {
    let parts = kept.iter().filter_map(|(owner, row)| {
        let (number, _) = owner.joint_part(&work.graph)?;
        Some((number, row))
    });
    let mut joints: Vec<(usize, Vec<&ConstraintRow>)> = Vec::new();
    for (number, row) in parts {
        match joints.last_mut() {
            Some((last, rows)) if *last == number => rows.push(row),
            _ => joints.push((number, vec![row])),
        }
    }
    let apart = joints.iter().filter(|(_, rows)| {
        rows.iter().any(|row| are_held_apart(work, &[*row])) || are_held_apart(work, rows)
    });
    let apart: Vec<usize> = apart.map(|(number, _)| *number).collect();
    for number in &apart {
        let joint = &system.closings[*number];
        let message = format!(
            "no motion closes `{0}`: other joints hold both of its ends, and not in the same place or direction; \
             move one of its points, or leave `{0}` out",
            joint.name
        );
        errors.push(joint.written, message);
    }
    apart.is_empty().then_some(())
}

/// Reports written constraints that change where no acceleration changes them.
pub fn check_lost(
    system: &System,
    rows: &[(Owner, ConstraintRow)],
    errors: &mut Errors,
) -> Option<()> {
    let before = errors.count();
    for (owner, row) in rows.iter().filter(|(_, row)| row.activity.is_lost) {
        if let Some(number) = owner.number() {
            let constraint = &system.constraints.list[number];
            let message = lost(&row.name, constraint.level);
            errors.push(constraint.extent, message);
        }
    }
    (errors.count() == before).then_some(())
}

/// Reports written constraints that are trivial or redundant; `followed` are the symbols of loads
/// that other loads depend on. A link may be redundant, unless something depends on its tension.
pub fn check_kept(
    system: &System,
    work: &Workspace,
    (undetermined, followed): (&Undetermined, &[Id]),
    errors: &mut Errors,
) -> Option<()> {
    let before = errors.count();
    for (number, others) in &undetermined.written {
        let constraint = &system.constraints.list[*number];
        let name = &constraint.name;
        let is_link = system.is_link(&constraint.place);
        let message = if is_link && others.is_empty() {
            format!(
                "the ends of `{name}` are held already, wherever they move: nothing determines its tension; leave \
                 it out"
            )
        } else if is_link {
            continue;
        } else if others.is_empty() {
            trivial(name, constraint.level)
        } else {
            dependent(name, others)
        };
        errors.push(constraint.extent, message);
    }
    let kept = system
        .constraints
        .list
        .iter()
        .zip(&system.constraints.loads);
    for (number, (constraint, symbol)) in kept.enumerate() {
        let mut spare = undetermined.spare.iter();
        let is_reported = errors.count() > before;
        let is_open = spare.any(|spare| !work.graph.vanishes(spare.loads[number]));
        if is_open && followed.contains(symbol) && !is_reported {
            let message = format!(
                "other loads depend on the load of `{}`, which the balances do not determine",
                constraint.name
            );
            errors.push(constraint.extent, message);
        }
    }
    (errors.count() == before).then_some(())
}
