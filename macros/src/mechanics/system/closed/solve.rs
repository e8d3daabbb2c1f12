//! The accelerations and the constraint loads of a system with constraints outside its tree.

use std::collections::BTreeSet;

use crate::mechanics::following::Added;
use crate::mechanics::tree::link::{Link, Tree};
use crate::mechanics::tree::{Built, MassMatrix};
use crate::mechanics::variation::Direction;
use crate::model::{System, TreeJoint, Workspace};
use crate::symbolic::{Components, Graph, Id};

use super::super::constraints::{ConstraintRow, Ends, Loop, push_written};
use super::dependent::dependent;
use super::eliminated::{Following, Found, eliminated};
use super::groups::{full, groups};
use super::in_plane::in_plane;
use super::rank::{Coordinates, Rank, rank};
use super::rows::{Known, Owner, follows_unknowns};
use super::undetermined::{Spare, Undetermined, bare};

/// The constraints of such a system, and their loads.
pub struct Closed {
    pub kept: Vec<(Owner, ConstraintRow)>,
    /// For each constraint, whether it follows from the others in closed states.
    pub follows: Vec<bool>,
    /// The diagonal of the mass matrix of the tree.
    pub inertias: Vec<Id>,
    /// The force and moment of each loop-closing joint on the carried body, at its point on that
    /// body, in world axes.
    pub wrenches: Vec<[Components; 2]>,
    /// The load of each written constraint, per unit of its gradient.
    pub loads: Vec<Id>,
    pub undetermined: Undetermined,
}

impl Closed {
    /// The rows of all constraints.
    pub fn rows(&self) -> impl ExactSizeIterator<Item = &ConstraintRow> {
        self.kept.iter().map(|(_, row)| row)
    }
}

/// Solves for the accelerations of the open freedoms, link by link, and for the loads of all
/// constraints, which are put on the links of `loaded`.
pub fn close(
    system: &System,
    work: &mut Workspace,
    (built, added): (&Built, Option<&Added>),
    (motion, coordinates): (&Direction, &Coordinates),
    loaded: &mut Tree,
) -> (Vec<Vec<Id>>, Closed) {
    let known = Known::of(system, work, (built, added), motion);
    let matrix = MassMatrix::derive(&mut work.graph, &mut work.labels, &known.in_world);
    let open = system.joints.iter().filter(|joint| !joint.is_driven());
    let symbols: Vec<Id> = open.flat_map(TreeJoint::accelerations).collect();
    let found = found(system, work, (&known, coordinates), (&matrix, &symbols));
    let spare = spare(system, work, &known, &found);
    let (wrenches, loads) = loads_of(system, work, &known.kept, &found.loads);
    for (constraint, load) in system.constraints.list.iter().zip(&loads) {
        let name = format!("{}_load", constraint.name.replace('.', "_"));
        work.labels.name(*load, name);
    }
    let undetermined = undetermined(system, work, &known, (&found, spare));
    for ((ends, own), wrench) in known.ends.iter().zip(&known.loops).zip(&wrenches) {
        push(&mut work.graph, loaded, own, ends, *wrench);
    }
    push_written(system, work, built, loaded, &loads);
    let wrenches = known.wrenches_in_world(&mut work.graph, &wrenches);
    let freedoms = 0..matrix.driving.len();
    let closed = Closed {
        kept: known.kept,
        follows: found.follows,
        inertias: freedoms.map(|one| matrix.rows[one][one]).collect(),
        wrenches,
        loads,
        undetermined,
    };
    (built.tree.by_link(found.accelerations), closed)
}

/// The loads that the equations do not determine; `spare` are sets of loads that balance each
/// other.
fn undetermined(
    system: &System,
    work: &mut Workspace,
    known: &Known<'_>,
    (found, spare): (&Found, Vec<Loads>),
) -> Undetermined {
    let mut undetermined = Undetermined {
        light: found.light.clone(),
        ..Undetermined::default()
    };
    for (owner, _) in &known.idle {
        undetermined.add(owner, BTreeSet::new());
    }
    for (row, others, _) in &found.spare {
        let others = others.iter().map(|other| known.kept[*other].1.name.clone());
        undetermined.add(&known.kept[*row].0, others.collect());
    }
    if !spare.is_empty() {
        undetermined.axes = axes(system, work, known);
    }
    for loads in spare {
        let mut tree = bare(&work.graph, known.built);
        push_written(system, work, known.built, &mut tree, &loads.1);
        let closings = known.wrenches_in_world(&mut work.graph, &loads.0);
        let spare = Spare::new(&mut work.graph, known, &tree, (closings, loads.1));
        undetermined.spare.push(spare);
    }
    undetermined
}

/// The solution block by block, if there is one and it costs no more than eliminating everything
/// together.
fn found(
    system: &System,
    work: &mut Workspace,
    (known, coordinates): (&Known<'_>, &Coordinates),
    (matrix, accelerations): (&MassMatrix, &[Id]),
) -> Found {
    let rank = if follows_unknowns(work, &known.in_world) {
        Rank::default()
    } else {
        let rows = known.kept.iter().map(|(_, row)| row.clone());
        let rows: Vec<ConstraintRow> = rows.collect();
        let written = known.kept.iter().filter_map(|(owner, _)| owner.number());
        let written = written.count();
        let some = |graph: &Graph, closed: &[bool]| full(&groups(graph, &known.kept, closed));
        rank(system, work, (&rows, written, coordinates), matrix, &some)
    };
    if let Some(found) = where_closed(work, (known, coordinates), matrix, &rank) {
        return found;
    }
    let is_full = |rows: &Vec<bool>| rows.iter().all(|is_new| *is_new);
    let is_regular = rank.anywhere.as_ref().is_none_or(is_full);
    let by_blocks = if system.is_planar && known.idle.is_empty() && is_regular {
        in_plane(work, known)
    } else {
        None
    };
    match by_blocks {
        Some(by_blocks) if by_blocks.is_resolved => by_blocks,
        by_blocks => {
            let symbols = &system.constraints.loads;
            let kept = known.kept.iter();
            let loads = kept.map(|(owner, _)| Some(symbols[owner.number()?]));
            let following = Following {
                loads: &loads.collect::<Vec<Option<Id>>>(),
                accelerations,
            };
            let eliminated = eliminated(work, matrix, &known.kept, following);
            let cost = |found: &Found| work.graph.late_cost(&found.accelerations).total();
            let by_blocks = by_blocks.filter(|one| cost(one) < cost(&eliminated));
            by_blocks.unwrap_or(eliminated)
        }
    }
}

/// The solution with rows that depend on each other in closed states. `None` if there are no such
/// rows, or if a written constraint follows from others in all states.
fn where_closed(
    work: &mut Workspace,
    (known, coordinates): (&Known<'_>, &Coordinates),
    matrix: &MassMatrix,
    rank: &Rank,
) -> Option<Found> {
    let (anywhere, closed) = (rank.anywhere.as_ref()?, rank.closed.as_ref()?);
    let is_needed = anywhere.iter().zip(closed).map(|(a, b)| *a || *b);
    let mut all = known.kept.iter().zip(is_needed);
    let is_redundant = all.any(|((owner, _), is_needed)| owner.number().is_some() && !is_needed);
    let count = |rows: &[bool]| rows.iter().filter(|is_new| **is_new).count();
    let most = if is_redundant {
        count(anywhere)
    } else {
        anywhere.len()
    };
    if count(closed) >= most {
        return None;
    }
    let open = known.built.tree.links.iter().flat_map(Link::open);
    let graph = &work.graph;
    let is_turning: Vec<bool> = open
        .map(|freedom| !graph.is_zero_vector(&freedom.twist.angular))
        .collect();
    let groups = groups(&work.graph, &known.kept, closed);
    dependent(
        work,
        (matrix, rank.is_settled),
        &known.kept,
        &groups,
        (&coordinates.rates, &is_turning),
    )
}

/// The force and moment of each joint that closes a loop, in the axes of the loop, and the load of
/// each written constraint.
type Loads = (Vec<[Components; 2]>, Vec<Id>);

/// Sets of loads that balance each other. The load of an idle row is such a set by itself.
fn spare(system: &System, work: &mut Workspace, known: &Known<'_>, found: &Found) -> Vec<Loads> {
    let always = found.spare.iter().map(|(.., loads)| loads);
    let mut spare = Vec::new();
    for loads in always.chain(&found.loose) {
        spare.push(loads_of(system, work, &known.kept, loads));
    }
    for own in known.idle.chunks(1) {
        let one = work.graph.one();
        spare.push(loads_of(system, work, own, &[one]));
    }
    spare
}

/// The loads of joints and constraints, from those of all rows.
fn loads_of(
    system: &System,
    work: &mut Workspace,
    kept: &[(Owner, ConstraintRow)],
    found: &[Id],
) -> Loads {
    let mut wrenches = vec![[work.graph.zeros(); 2]; system.closings.len()];
    let mut loads = vec![work.graph.zero(); system.constraints.list.len()];
    for ((owner, _), load) in kept.iter().zip(found) {
        match owner {
            Owner::Joint(number, unit) => {
                for (sum, unit) in wrenches[*number].iter_mut().zip(unit) {
                    let part = work.graph.scale_vector(*load, *unit);
                    *sum = work.graph.add_vectors(*sum, part);
                }
            }
            Owner::Written(number) => loads[*number] = work.graph.quantity(*load),
        }
    }
    (wrenches, loads)
}

/// The first axis of each joint that has one, in world axes.
fn axes(system: &System, work: &mut Workspace, known: &Known<'_>) -> Vec<Option<Components>> {
    let axes = system.connections().map(|joint| {
        let axis = joint.directions.first()?;
        let placed = &known.placed[known.built.body(joint.carried)];
        Some(placed.to_frame(&mut work.graph, *axis))
    });
    axes.collect()
}

/// Puts the load of a joint on both of its links, at its point on the carried one.
fn push(
    graph: &mut Graph,
    tree: &mut Tree,
    own: &Loop,
    ends: &Ends<'_>,
    [force, moment]: [Components; 2],
) {
    let place = own.placed(ends.links[1]).spot(graph, ends.offsets[1]).place;
    for (link, is_carried) in [(ends.links[0], false), (ends.links[1], true)] {
        let placed = own.placed(link);
        let Some(link) = link else { continue };
        let arm = graph.subtract_vectors(place, placed.origin);
        let lever = graph.cross(arm, force);
        let about = graph.add_vectors(moment, lever);
        let turning = placed.turning;
        let both = [force, about].map(|part| {
            let part = turning.to_link(graph, part);
            let part = graph.quantities(part);
            if is_carried {
                part
            } else {
                graph.negate_vector(part)
            }
        });
        let link = &mut tree.links[link];
        link.force = graph.add_vectors(link.force, both[0]);
        link.moment = graph.add_vectors(link.moment, both[1]);
    }
}
