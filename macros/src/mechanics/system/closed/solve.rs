//! The accelerations and the constraint loads of a system with constraints outside its tree.

use std::collections::BTreeSet;

use crate::mechanics::tree::link::{Link, Tree};
use crate::mechanics::tree::{Built, MassMatrix};
use crate::mechanics::variation::Direction;
use crate::model::{Closing, Frame, System, TreeJoint, Workspace};
use crate::symbolic::{Components, Graph, Id};

use super::super::constraints::{
    Ends, Placed, Row, place_links, push_written, replace_in_tree, rows_of_joint, rows_of_written,
};
use super::assembly::{Assembly, Coordinates};
use super::dependent::{dependent, groups};
use super::eliminated::{Following, Found, eliminated};
use super::in_plane::{Known, in_plane};
use super::unsettled::{Keeper, Spare, Unsettled, bare};

/// The solution of such a system.
pub struct Closed {
    /// The accelerations of the open freedoms, link by link.
    pub accelerations: Vec<Vec<Id>>,
    pub constraints: Vec<Row>,
    /// For each row, its number if it is a written constraint.
    pub written: Vec<Option<usize>>,
    /// For each row, the number of its joint, and whether its load is a moment.
    pub parts: Vec<Option<(usize, bool)>>,
    /// Which rows follow from others in closed states.
    pub follows: Vec<bool>,
    /// The diagonal of the mass matrix of the tree.
    pub inertias: Vec<Id>,
    /// Force and moment of each loop-closing joint on the carried body, at its point there, world
    /// axes.
    pub wrenches: Vec<[Components; 2]>,
    /// The load of each written constraint, for one unit of its gradient.
    pub loads: Vec<Id>,
    /// The symbols of these loads, each with its solution.
    pub values: Vec<(Id, Id)>,
    /// The same for the accelerations on which loads may depend.
    pub moved: Vec<(Id, Id)>,
    /// The tree with these loads on its links.
    pub loaded: Tree,
    pub unsettled: Unsettled,
}

impl Closed {
    /// The solutions for all symbols on which loads depend.
    pub fn settled(&self) -> Vec<(Id, Id)> {
        [&self.values[..], &self.moved].concat()
    }
}

/// Solves for all constraint loads. The form of the tree does not matter, but the origins of its
/// links are at their joints. `motion` is the change of the state.
pub fn close(
    system: &System,
    work: &mut Workspace,
    built: &Built,
    (motion, coordinates): (&Direction, &Coordinates),
) -> Closed {
    let tree = moved_in_world(work, &built.tree);
    let placed = {
        let free: Vec<Option<[Components; 2]>> = free_links(system, work, built);
        place_links(&mut work.graph, &built.tree, |link| free[link])
    };
    let ends: Vec<Ends<'_>> = system
        .closings
        .iter()
        .map(|closing| ends(system, work, built, closing))
        .collect();
    let kept = keepers(system, work, built, (&placed, &ends), motion);
    let mut unsettled = Unsettled::default();
    let (idle, kept): (Vec<_>, Vec<_>) = kept
        .into_iter()
        .partition(|(keeper, row)| keeper.is_idle(work, row));
    for (keeper, _) in &idle {
        unsettled.add(keeper, BTreeSet::new());
    }
    let matrix = MassMatrix::derive(&mut work.graph, &mut work.labels, &tree);
    let parts = kept
        .iter()
        .map(|(keeper, _)| keeper.joint_part(&work.graph));
    let parts = parts.collect();
    let written: Vec<Option<usize>> = kept.iter().map(|(keeper, _)| keeper.number()).collect();
    let symbols = &system.constraints.loads;
    let followed: Vec<Option<Id>> = written.iter().map(|one| Some(symbols[(*one)?])).collect();
    let known = Known {
        built,
        in_world: &tree,
        placed: &placed,
        ends: &ends,
        kept: &kept,
    };
    let is_idle = !idle.is_empty();
    let open = system.joints.iter().filter(|joint| !joint.is_driven());
    let accelerations: Vec<Id> = open.flat_map(TreeJoint::accelerations).collect();
    let following = Following {
        loads: &followed,
        accelerations: &accelerations,
    };
    let found = found(
        system,
        work,
        (&known, coordinates),
        (&matrix, following),
        is_idle,
    );
    unsettled.light.clone_from(&found.light);
    for (row, others, _) in &found.spare {
        let others = others.iter().map(|other| kept[*other].1.name.clone());
        unsettled.add(&kept[*row].0, others.collect());
    }
    let spare = spare(system, work, [&kept, &idle], &found);
    let symbols_of_motion = accelerations.into_iter();
    let moved = symbols_of_motion.zip(found.accelerations.iter().copied());
    let moved: Vec<(Id, Id)> = moved.collect();
    let mut accelerations = found.accelerations.into_iter();
    let links = built.tree.links.iter();
    let accelerations =
        links.map(|link| accelerations.by_ref().take(link.open().count()).collect());
    let accelerations = accelerations.collect();
    let (wrenches, loads) = loads_of(system, work, &kept, found.loads.into_iter());
    for (constraint, load) in system.constraints.list.iter().zip(&loads) {
        let name = format!("{}_load", constraint.name.replace('.', "_"));
        work.labels.name(*load, name);
    }
    if !spare.is_empty() {
        unsettled.axes = axes(system, work, built, &placed);
    }
    for loads in spare {
        let mut tree = bare(&work.graph, built);
        push_written(system, work, built, &mut tree, &loads.1);
        let known = (&tree, &placed[..], &ends[..]);
        let spare = Spare::new(&mut work.graph, built, known, loads);
        unsettled.spare.push(spare);
    }
    let mut loaded = built.tree.clone();
    for (ends, wrench) in ends.iter().zip(&wrenches) {
        push(&mut work.graph, &mut loaded, &placed, ends, *wrench);
    }
    push_written(system, work, built, &mut loaded, &loads);
    let values: Vec<(Id, Id)> = symbols.iter().copied().zip(loads.iter().copied()).collect();
    let settled = [&values[..], &moved].concat();
    replace_in_tree(&mut work.graph, &mut loaded, &settled);
    Closed {
        accelerations,
        constraints: kept.into_iter().map(|(_, row)| row).collect(),
        written,
        parts,
        follows: found.follows,
        inertias: (0..matrix.driving.len())
            .map(|freedom| matrix.rows[freedom][freedom])
            .collect(),
        wrenches,
        loads,
        values,
        moved,
        loaded,
        unsettled,
    }
}

/// All rows.
fn keepers(
    system: &System,
    work: &mut Workspace,
    built: &Built,
    (placed, ends): (&[Placed], &[Ends<'_>]),
    motion: &Direction,
) -> Vec<(Keeper, Row)> {
    let mut kept: Vec<(Keeper, Row)> = Vec::new();
    for (number, ends) in ends.iter().enumerate() {
        let rows = rows_of_joint(&mut work.graph, &built.tree, placed, ends);
        let rows = rows.into_iter();
        kept.extend(rows.map(|one| (Keeper::Joint(number, [one.force, one.moment]), one.row)));
    }
    let written = rows_of_written(system, work, built, motion).into_iter();
    let written = written.enumerate();
    kept.extend(written.map(|(number, row)| (Keeper::Written(number), row)));
    kept
}

/// Block by block if that is possible, and not more expensive than eliminating all together.
fn found(
    system: &System,
    work: &mut Workspace,
    (known, coordinates): (&Known<'_>, &Coordinates),
    (matrix, following): (&MassMatrix, Following<'_>),
    is_idle: bool,
) -> Found {
    if let Some(found) = where_closed(system, work, (known, coordinates), matrix) {
        return found;
    }
    let by_blocks = if system.is_planar && !is_idle {
        in_plane(work, known)
    } else {
        None
    };
    match by_blocks {
        Some(by_blocks) if by_blocks.is_resolved => by_blocks,
        by_blocks => {
            let eliminated = eliminated(work, matrix, known.kept, following);
            let cost = |found: &Found| work.graph.late_cost(&found.accelerations).total();
            let by_blocks = by_blocks.filter(|one| cost(one) < cost(&eliminated));
            by_blocks.unwrap_or(eliminated)
        }
    }
}

/// The solution with rows that depend on each other only in closed states; none if there are no
/// such rows, or if loads depend on those of constraints.
fn where_closed(
    system: &System,
    work: &mut Workspace,
    (known, coordinates): (&Known<'_>, &Coordinates),
    matrix: &MassMatrix,
) -> Option<Found> {
    if known.is_followed(work) {
        return None;
    }
    let open = || known.built.tree.links.iter().flat_map(Link::open);
    let graph = &work.graph;
    let is_turning: Vec<bool> = open()
        .map(|freedom| !graph.is_zero_vector(&freedom.twist.angular))
        .collect();
    let rows = known.kept.iter().map(|(_, row)| row).collect();
    let independent = Assembly::new(system, work, coordinates, rows).independent()?;
    let groups = groups(&work.graph, known.kept, &independent);
    dependent(
        work,
        matrix,
        known.kept,
        groups,
        (&coordinates.rates, &is_turning),
    )
}

/// Loads that balance each other, from `loads_of`; for an idle row, any load.
fn spare(
    system: &System,
    work: &mut Workspace,
    [kept, idle]: [&[(Keeper, Row)]; 2],
    found: &Found,
) -> Vec<(Vec<[Components; 2]>, Vec<Id>)> {
    let always = found.spare.iter().map(|(.., loads)| loads);
    let mut spare = Vec::new();
    for loads in always.chain(&found.loose) {
        spare.push(loads_of(system, work, kept, loads.iter().copied()));
    }
    for own in idle.chunks(1) {
        let one = work.graph.one();
        spare.push(loads_of(system, work, own, [one].into_iter()));
    }
    spare
}

/// Force and moment of each joint that closes a loop, and the load of each written constraint, by
/// the loads of all rows.
fn loads_of(
    system: &System,
    work: &mut Workspace,
    kept: &[(Keeper, Row)],
    found: impl Iterator<Item = Id>,
) -> (Vec<[Components; 2]>, Vec<Id>) {
    let mut wrenches = vec![[work.graph.zeros(); 2]; system.closings.len()];
    let mut loads = vec![work.graph.zero(); system.constraints.list.len()];
    for ((keeper, _), load) in kept.iter().zip(found) {
        match keeper {
            Keeper::Joint(number, unit) => {
                for (sum, unit) in wrenches[*number].iter_mut().zip(unit) {
                    let part = work.graph.scale_vector(load, *unit);
                    *sum = work.graph.add_vectors(*sum, part);
                }
            }
            Keeper::Written(number) => loads[*number] = work.graph.quantity(load),
        }
    }
    (wrenches, loads)
}

/// The first axis of each joint that has one, world axes.
fn axes(
    system: &System,
    work: &mut Workspace,
    built: &Built,
    placed: &[Placed],
) -> Vec<Option<Components>> {
    let tree = system
        .joints
        .iter()
        .map(|joint| (joint.carried, &joint.directions));
    let closings = system.closings.iter();
    let closings = closings.map(|joint| (joint.carried, &joint.directions));
    let axes = tree.chain(closings).map(|(body, directions)| {
        let axis = directions.first()?;
        Some(placed[built.body(body)].to_world(&mut work.graph, *axis))
    });
    axes.collect()
}

fn ends<'a>(
    system: &'a System,
    work: &mut Workspace,
    built: &Built,
    closing: &'a Closing,
) -> Ends<'a> {
    let offset = |work: &mut Workspace, body: Option<usize>, place: Components| match body {
        None => place,
        Some(body) => work.graph.subtract_vectors(place, system.joints[body].pin),
    };
    Ends {
        closing,
        links: [closing.carrier, Some(closing.carried)].map(|body| Some(built.body(body?))),
        offsets: [
            offset(work, closing.carrier, closing.place),
            offset(work, Some(closing.carried), closing.pin),
        ],
        is_planar: system.is_planar,
    }
}

/// Puts the load of a joint on both of its links, at its point on the carried one.
fn push(
    graph: &mut Graph,
    tree: &mut Tree,
    placed: &[Placed],
    ends: &Ends<'_>,
    [force, moment]: [Components; 2],
) {
    let Some(carried) = ends.links[1] else { return };
    let place = placed[carried].spot(graph, ends.offsets[1]).place;
    for (link, is_carried) in [(ends.links[0], false), (ends.links[1], true)] {
        let Some(link) = link else { continue };
        let arm = graph.subtract_vectors(place, placed[link].origin);
        let lever = graph.cross(arm, force);
        let about = graph.add_vectors(moment, lever);
        let turning = placed[link].turning;
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

/// The tree with the accelerations of free links along world axes.
pub fn moved_in_world(work: &mut Workspace, tree: &Tree) -> Tree {
    let mut tree = tree.clone();
    for link in tree.links.iter_mut().filter(|link| link.is_free) {
        link.is_free = false;
        for freedom in &mut link.freedoms {
            freedom.twist.linear = link.turning.to_link(&mut work.graph, freedom.twist.linear);
        }
    }
    tree
}

/// Place and velocity of the links that are free, world axes.
fn free_links(
    system: &System,
    work: &mut Workspace,
    built: &Built,
) -> Vec<Option<[Components; 2]>> {
    let mut free = vec![None; built.tree.links.len()];
    for (number, body) in system.bodies.iter().enumerate() {
        let link = built.body(number);
        if built.tree.links[link].is_free {
            let state = [body.state.position, body.state.velocity];
            free[link] = Some(state.map(|vector| work.components(vector, Frame::WORLD)));
        }
    }
    free
}
