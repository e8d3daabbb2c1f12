//! Loops in the plane: the motion in absolute angles, and after it the loads.

use crate::mechanics::tree::link::Tree;
use crate::mechanics::tree::{Built, joint_loads};
use crate::mechanics::unknowns::reactions_in;
use crate::model::{Part, Workspace};
use crate::symbolic::Id;

use super::super::plane::{Absolute, Arms, derive_masses, of_hinge, of_row, shortest};
use super::super::reduced::{loads, reduce};
use super::eliminated::Found;
use super::joints::Ends;
use super::row::Row;
use super::unsettled::Keeper;
use super::world::Placed;

/// A system, and what is kept of it.
pub struct Known<'a> {
    pub built: &'a Built,
    /// Its tree, with the accelerations of free links along world axes.
    pub in_world: &'a Tree,
    pub placed: &'a [Placed],
    pub ends: &'a [Ends<'a>],
    pub kept: &'a [(Keeper, Row)],
}

/// Resolves block by block what is kept; nothing where rows are dependent, say nothing somewhere, or
/// loads follow those of constraints.
pub fn in_plane(work: &mut Workspace, known: &Known<'_>) -> Option<Found> {
    let tree = &known.built.tree;
    let links = tree.links.iter();
    let given = links.flat_map(|link| {
        let drives = link.freedoms.iter().map(|freedom| freedom.drive);
        drives.chain(link.force).chain(link.moment)
    });
    let given: Vec<Id> = given.collect();
    let is_partial = known.kept.iter().any(|(_, row)| row.active.is_some());
    if is_partial || !reactions_in(work, &given).is_empty() {
        return None;
    }
    let graph = &mut work.graph;
    let absolute = Absolute::of(graph, tree, known.placed);
    let mut arms = Arms::new(known.placed);
    let mut rows = Vec::new();
    for (number, ends) in known.ends.iter().enumerate() {
        let own = known.kept.iter();
        let own = own.filter(|(keeper, _)| matches!(keeper, Keeper::Joint(of, _) if *of == number));
        match ends.closing.kind.parts {
            [Part::Turn(_)] => rows.extend(of_hinge(graph, tree, &absolute, &mut arms, ends)),
            _ => rows.extend(own.map(|(_, row)| of_row(graph, &absolute, row))),
        }
    }
    let written = known.kept.iter();
    let written = written.filter(|(keeper, _)| keeper.number().is_some());
    rows.extend(written.map(|(_, row)| of_row(graph, &absolute, row)));
    let short = shortest(graph, tree, known.ends);
    let (masses, mut driving) = derive_masses(graph, &absolute, &mut arms, &short);
    let open = || tree.links.iter().flat_map(|link| link.open().map(move |one| (link, one)));
    let drives: Vec<Id> = open().map(|(_, freedom)| freedom.drive).collect();
    let drives = absolute.gathered(graph, &drives);
    for (driving, drive) in driving.iter_mut().zip(drives) {
        *driving = graph.add(*driving, drive);
    }
    let count = rows.len();
    let reduced = reduce(work, masses, driving, rows)?;
    let graph = &mut work.graph;
    let values = &reduced.values[..absolute.count];
    let accelerations = absolute.of_joints(graph, values);
    let accelerations: Vec<Id> = accelerations
        .into_iter()
        .map(|one| graph.quantity(one))
        .collect();
    let lacking = lacking(work, known.in_world, &accelerations);
    let lacking = absolute.gathered(&mut work.graph, &lacking);
    Some(Found {
        accelerations,
        loads: loads(&mut work.graph, &reduced, &lacking, count),
        is_resolved: reduced.eliminated.is_empty(),
        spare: Vec::new(),
    })
}

/// What lacks along the open freedoms for the accelerations that are found.
fn lacking(work: &mut Workspace, tree: &Tree, accelerations: &[Id]) -> Vec<Id> {
    let mut rest = accelerations.iter().copied();
    let by_link: Vec<Vec<Id>> = tree
        .links
        .iter()
        .map(|link| rest.by_ref().take(link.open().count()).collect())
        .collect();
    let graph = &mut work.graph;
    let carried = joint_loads(graph, tree, &by_link);
    let mut all = Vec::new();
    for (link, load) in tree.links.iter().zip(carried) {
        for freedom in link.open() {
            let needed = freedom.twist.dot(graph, load);
            let lacking = graph.subtract(needed, freedom.drive);
            all.push(graph.quantity(lacking));
        }
    }
    all
}
