//! A system that is held by more than the joints of its tree: the places of its links, and its
//! rows.

use crate::mechanics::following::{Added, unknowns_in};
use crate::mechanics::tree::Built;
use crate::mechanics::tree::link::{Link, Tree};
use crate::mechanics::variation::Direction;
use crate::model::{Connection, Frame, System, Workspace};
use crate::symbolic::{Components, Graph, Id};

use super::super::constraints::{
    ConstraintRow, Ends, Loop, Placed, place_links, rows_of_joint, rows_of_written,
};

/// The joint or written constraint that a row belongs to.
pub enum Owner {
    /// A joint that closes a loop, by its index, and the force and moment of a unit of the row's
    /// load, in the axes of the loop.
    Joint(usize, [Components; 2]),
    /// A written constraint, by the index of its load.
    Written(usize),
}

/// A system, and its rows.
pub struct Known<'a> {
    pub built: &'a Built,
    /// Its tree, with the inertia that loads add. The accelerations of free links are along world
    /// axes.
    pub in_world: Tree,
    /// The places of the links, in world axes.
    pub placed: Vec<Placed>,
    /// The ends of the joints that close loops.
    pub ends: Vec<Ends<'a>>,
    /// The loops that they close.
    pub loops: Vec<Loop>,
    pub kept: Vec<(Owner, ConstraintRow)>,
    /// The rows that do not restrict accelerations.
    pub idle: Vec<(Owner, ConstraintRow)>,
}

impl<'a> Known<'a> {
    /// The tree may have any form, but the origins of its links must be at their joints.
    /// `motion` is the change of the state in time.
    pub fn of(
        system: &'a System,
        work: &mut Workspace,
        (built, added): (&'a Built, Option<&Added>),
        motion: &Direction,
    ) -> Self {
        let mut in_world = moved_in_world(work, &built.tree);
        if let Some(added) = added {
            in_world = added.put_into(work, &in_world);
        }
        let free = free_links(system, work, built);
        let placed = place_links((&mut work.graph, &mut work.labels), &built.tree, |link| {
            free[link]
        });
        let closings = system.closings.iter();
        let ends: Vec<Ends<'_>> = closings
            .map(|closing| ends(system, work, built, closing))
            .collect();
        let loops = ends.iter().map(|ends| {
            let (graph, labels) = (&mut work.graph, &mut work.labels);
            let own = Loop::of((&mut *graph, &mut *labels), (&built.tree, &placed), ends);
            own.label_arms((graph, labels), &built.tree, ends);
            own
        });
        let loops: Vec<Loop> = loops.collect();
        let mut rows: Vec<(Owner, ConstraintRow)> = Vec::new();
        for (number, (ends, own)) in ends.iter().zip(&loops).enumerate() {
            let own = rows_of_joint(&mut work.graph, &built.tree, own, ends).into_iter();
            rows.extend(own.map(|one| (Owner::Joint(number, [one.force, one.moment]), one.row)));
        }
        let written = rows_of_written(system, work, built, motion).into_iter();
        let written = written.enumerate();
        rows.extend(written.map(|(number, row)| (Owner::Written(number), row)));
        let rows = rows.into_iter();
        let (idle, kept): (Vec<_>, Vec<_>) =
            rows.partition(|(owner, row)| owner.is_idle(work, row));
        for (_, row) in &kept {
            let open = built.tree.links.iter().flat_map(Link::open);
            row.label(&mut work.labels, open.map(|freedom| freedom.name.as_str()));
        }
        Self {
            built,
            in_world,
            placed,
            ends,
            loops,
            kept,
            idle,
        }
    }

    /// The force and moment of each joint that closes a loop, in world axes.
    pub fn wrenches_in_world(
        &self,
        graph: &mut Graph,
        wrenches: &[[Components; 2]],
    ) -> Vec<[Components; 2]> {
        let loops = self.loops.iter().zip(wrenches);
        loops
            .map(|(own, wrench)| own.to_world(graph, &self.placed, *wrench))
            .collect()
    }

    /// Whether some rows are trivial somewhere.
    pub fn is_partial(&self) -> bool {
        let mut rows = self.kept.iter();
        rows.any(|(_, row)| row.activity.condition.is_some())
    }
}

/// Whether loads on a tree depend on unknowns.
pub fn follows_unknowns(work: &Workspace, tree: &Tree) -> bool {
    let links = tree.links.iter();
    let given = links.flat_map(|link| {
        let drives = link.freedoms.iter().map(|freedom| freedom.drive);
        drives.chain(link.force).chain(link.moment)
    });
    let given: Vec<Id> = given.collect();
    !unknowns_in(work, &given).is_empty()
}

impl Owner {
    /// For the row of a joint: the index of the joint, and whether the load of the row is a moment.
    pub fn joint_part(&self, graph: &Graph) -> Option<(usize, bool)> {
        match self {
            Self::Joint(number, [force, _]) => Some((*number, graph.is_zero_vector(force))),
            Self::Written(_) => None,
        }
    }

    /// For the row of a written constraint: its index.
    pub fn number(&self) -> Option<usize> {
        match self {
            Self::Joint(..) => None,
            Self::Written(number) => Some(*number),
        }
    }

    /// Whether a row does not restrict accelerations. The row of a joint that holds in all states,
    /// as between parallel axes in space, can have any load.
    pub fn is_idle(&self, work: &Workspace, row: &ConstraintRow) -> bool {
        let rest = [row.rate, row.bias].into_iter().chain(row.value);
        let mut parts = row.slopes.iter().copied();
        let vanishes = |part: Id| work.graph.vanishes(part);
        match self {
            Self::Joint(..) => parts.chain(rest).all(vanishes),
            Self::Written(_) => parts.all(vanishes) || row.activity.is_nowhere(&work.graph),
        }
    }
}

fn ends<'a>(
    system: &'a System,
    work: &mut Workspace,
    built: &Built,
    closing: &'a Connection,
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

/// The tree with the accelerations of free links along world axes.
pub fn moved_in_world(work: &mut Workspace, tree: &Tree) -> Tree {
    let mut tree = tree.clone();
    for link in tree.links.iter_mut().filter(|link| link.is_free) {
        (link.is_free, link.falls) = (false, false);
        for freedom in &mut link.freedoms {
            freedom.twist.linear = link.turning.to_link(&mut work.graph, freedom.twist.linear);
        }
    }
    tree
}

/// The place and velocity of the free links, in world axes.
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
