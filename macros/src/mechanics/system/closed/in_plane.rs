//! Loops in the plane: the motion is solved for in absolute angles, and then the loads.

use crate::mechanics::tree;
use crate::mechanics::tree::link::{Link, Tree};
use crate::model::Workspace;
use crate::symbolic::{Graph, Id};

use super::super::constraints::Ends;
use super::super::plane::{Absolute, Arms, derive_masses, of_hinge, of_row, shortest};
use super::super::reduced::{Balance, LinearRow, Reduced, loads, reduce};
use super::eliminated::Found;
use super::rows::{Known, Owner, follows_unknowns};

/// Solves the rows block by block. `None` if rows are dependent or trivial somewhere, or if loads
/// depend on those of constraints.
pub fn in_plane(work: &mut Workspace, known: &Known<'_>) -> Option<Found> {
    let tree = &known.built.tree;
    if known.is_partial() || follows_unknowns(work, tree) {
        return None;
    }
    let absolute = Absolute::of(&mut work.graph, tree, &known.placed);
    let mut arms = Arms::new(&known.placed);
    let rows = rows(&mut work.graph, known, &absolute, &mut arms);
    let count = rows.len();
    let reduced = resolve(work, known, (&absolute, &mut arms), &rows)?;
    arms.name((&mut work.graph, &mut work.labels), tree);
    let graph = &mut work.graph;
    let values = &reduced.values[..absolute.count];
    let accelerations = absolute.of_joints(graph, values);
    let accelerations: Vec<Id> = accelerations
        .into_iter()
        .map(|one| graph.quantity(one))
        .collect();
    // those of joints have names of their own
    let links = tree.links.iter().zip(&absolute.turns);
    for (link, own) in links.filter_map(|(link, own)| Some((link, own.as_ref()?))) {
        if values[*own] != accelerations[*own] {
            let name = format!("alpha_total_{}", link.name);
            work.labels.name(values[*own], name);
        }
    }
    let lacking = lacking(work, &known.in_world, &accelerations);
    let lacking = absolute.gathered(&mut work.graph, &lacking);
    Some(Found {
        accelerations,
        loads: loads(&mut work.graph, &reduced, &lacking, count),
        is_resolved: reduced.eliminated.is_empty(),
        spare: Vec::new(),
        loose: Vec::new(),
        follows: vec![false; count],
        light: Vec::new(),
    })
}

/// The rows in absolute coordinates: first those of joints, each with its joint, and then those of
/// written constraints.
fn rows(
    graph: &mut Graph,
    known: &Known<'_>,
    absolute: &Absolute,
    arms: &mut Arms<'_>,
) -> Vec<(Option<usize>, LinearRow)> {
    let mut rows = Vec::new();
    for (number, ends) in known.ends.iter().enumerate() {
        if ends.closing.kind.is_hinge() {
            let both = of_hinge(graph, &known.built.tree, absolute, arms, ends);
            rows.extend(both.map(|row| (Some(number), row)));
            continue;
        }
        for (owner, row) in &known.kept {
            if matches!(owner, Owner::Joint(of, _) if *of == number) {
                rows.push((Some(number), of_row(graph, absolute, row)));
            }
        }
    }
    let written = known.kept.iter();
    let written = written.filter(|(owner, _)| owner.number().is_some());
    rows.extend(written.map(|(_, row)| (None, of_row(graph, absolute, row))));
    rows
}

/// The motion. A hinge that closes a loop may become a carrier, so that fewer links are coupled.
/// This changes the loads of the rows of that hinge, but no others:
///
/// ```text
/// J' = J + W A        J'^T (m J' x - f) = J^T (m J x - f) + A^T W^T (..)
/// ```
///
/// So it is not done if these loads are solved for together with the motion instead of from it.
fn resolve(
    work: &mut Workspace,
    known: &Known<'_>,
    (absolute, arms): (&Absolute, &mut Arms<'_>),
    rows: &[(Option<usize>, LinearRow)],
) -> Option<Reduced> {
    let held: Vec<LinearRow> = rows.iter().map(|(_, row)| row.clone()).collect();
    let mut carrying: Vec<usize> = (0..known.ends.len()).collect();
    loop {
        let balances = balances(&mut work.graph, known, (absolute, arms), &carrying);
        let reduced = reduce(work, balances, held.clone())?;
        let eliminated = reduced.eliminated.iter();
        let eliminated: Vec<usize> = eliminated.filter_map(|(row, _)| rows[*row].0).collect();
        let count = carrying.len();
        carrying.retain(|joint| !eliminated.contains(joint));
        if carrying.len() == count {
            return Some(reduced);
        }
    }
}

/// The balances of absolute coordinates, with the drives of the joints. The hinges `carrying` may
/// become carriers.
fn balances(
    graph: &mut Graph,
    known: &Known<'_>,
    (absolute, arms): (&Absolute, &mut Arms<'_>),
    carrying: &[usize],
) -> Vec<Balance> {
    let tree = &known.built.tree;
    let ends: Vec<&Ends<'_>> = carrying.iter().map(|joint| &known.ends[*joint]).collect();
    let short = shortest(graph, tree, &ends);
    let (mut masses, mut driving) = derive_masses(graph, absolute, arms, &short);
    absolute.add_armatures(graph, tree, (&mut masses, &mut driving));
    let open = || tree.links.iter().flat_map(Link::open);
    let drives: Vec<Id> = open().map(|freedom| freedom.drive).collect();
    let drives = absolute.gathered(graph, &drives);
    let sides = masses.into_iter().zip(driving).zip(drives).zip(open());
    let balances = sides.map(|(((masses, driving), drive), freedom)| Balance {
        name: freedom.name.clone(),
        masses,
        driving: graph.add(driving, drive),
    });
    balances.collect()
}

/// The loads along the open coordinates that the solved accelerations still need.
fn lacking(work: &mut Workspace, tree: &Tree, accelerations: &[Id]) -> Vec<Id> {
    let by_link = tree.by_link(accelerations.iter().copied());
    let all = tree::lacking((&mut work.graph, &mut work.labels), tree, &by_link);
    let open = tree.links.iter().flat_map(Link::open);
    let named = all.into_iter().zip(open);
    let named = named.map(|(one, freedom)| {
        let one = work.graph.quantity(one);
        work.labels.name(one, format!("lacking_{}", freedom.name));
        one
    });
    named.collect()
}
