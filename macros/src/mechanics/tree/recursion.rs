//! The articulated-body recursion: from the tips to the ground, and back.

use crate::model::Labels;
use crate::symbolic::{Components, Graph, Id};

use super::articulated::{Eliminated, Passed, name_passed, wrench_on_carrier};
use super::bias::derive_bias;
use super::link::{Link, Tree};
use super::mass_matrix::MassMatrix;
use super::reductions::{drop_frames, merge_welds, reduced};
use super::regrouping::left_out;
use super::spatial::{SpatialInertia, SpatialVector};

/// The accelerations of the coordinates, link by link in the order of the tree. For a free link,
/// those of its origin along world axes come first.
pub struct Accelerations(Vec<Vec<Id>>);

/// The accelerations of all joints, and the tree that they were derived from.
pub struct SolvedTree {
    pub accelerations: Vec<Vec<Id>>,
    pub left_out: Vec<String>,
    /// The tree in the form with the fewest operations.
    pub reduced: Tree,
}

/// Solves for the accelerations of all joints, and names their parts.
pub fn derive_tree(graph: &mut Graph, labels: &mut Labels, tree: &Tree) -> SolvedTree {
    let mut tree = tree.clone();
    drop_frames(graph, &mut tree);
    merge_welds(graph, &mut tree);
    let best = reduced(graph, &tree, |graph, tree| {
        let found = solve(graph, &mut Labels::silent(), tree);
        cost(graph, &found)
    });
    SolvedTree {
        accelerations: solve(graph, labels, &best).0,
        left_out: left_out(graph, &tree, &best),
        reduced: best,
    }
}

fn cost(graph: &Graph, found: &Accelerations) -> u32 {
    graph.late_cost(&found.0.concat()).total()
}

/// Solves by the recursion, or by the mass matrix if that is cheaper, as it is for few degrees of
/// freedom.
fn solve(graph: &mut Graph, labels: &mut Labels, tree: &Tree) -> Accelerations {
    let mut names = labels.part();
    let mut best = recursion(graph, &mut names, tree).folded(graph, &mut names);
    let freedoms = || tree.links.iter().map(|link| link.open().count());
    if freedoms().sum::<usize>() <= 2 {
        let mut others = labels.part();
        let mut solved = MassMatrix::derive(graph, &mut others, tree).solve(graph, &mut others);
        let by_matrix = freedoms().map(|count| solved.drain(..count).collect());
        let by_matrix = Accelerations(by_matrix.collect()).folded(graph, &mut others);
        if cost(graph, &by_matrix) < cost(graph, &best) {
            (best, names) = (by_matrix, others);
        }
    }
    labels.adopt(names);
    best
}

impl Accelerations {
    fn folded(&self, graph: &mut Graph, labels: &mut Labels) -> Self {
        let (folded, images) = graph.folded(&self.0.concat());
        labels.follow(&images);
        let mut folded = folded.into_iter();
        let links = self.0.iter();
        Self(
            links
                .map(|link| folded.by_ref().take(link.len()).collect())
                .collect(),
        )
    }
}

const ARTICULATED: &str =
    "inertia of a body with all that it carries, while the joints move freely";

/// From the tips to the ground: inertias and loads, with each joint freed; and back.
fn recursion(graph: &mut Graph, labels: &mut Labels, tree: &Tree) -> Accelerations {
    let bias = derive_bias(graph, labels, tree);
    let mut inertia: Vec<SpatialInertia> = Vec::new();
    let mut lacking: Vec<SpatialVector> = Vec::new();
    for (link, (_, own)) in tree.links.iter().zip(&bias) {
        inertia.push(SpatialInertia::of(graph, link));
        lacking.push(*own);
    }
    let mut eliminated: Vec<Vec<Eliminated>> = Vec::new();
    let mut passed = Vec::new();
    for (index, link) in tree.links.iter().enumerate().rev() {
        let (mut own, mut load) = (inertia[index].quantities(graph), lacking[index]);
        load = load.quantities(graph);
        own.name(labels, &link.name, ARTICULATED);
        load.name_lacking(labels, &link.name);
        let gone = link.open().map(|freedom| {
            let gone = own.eliminate(graph, freedom, &mut load);
            gone.name(labels, &freedom.name);
            own = own.quantities(graph);
            load = load.quantities(graph);
            let meaning = "the same inertia while the joint gives way";
            let yielding = format!("{}_yielding", link.name);
            own.name(labels, &yielding, meaning);
            load.name_lacking(labels, &yielding);
            gone
        });
        eliminated.push(gone.collect());
        if let Some(carrier) = link.carrier {
            let seen = own.seen_by_carrier(graph, link);
            inertia[carrier] = inertia[carrier].plus(graph, &seen);
            let wrench = wrench_on_carrier(graph, link, load);
            lacking[carrier] = lacking[carrier].plus(graph, wrench);
            passed.push(Passed(link, seen, wrench));
        }
    }
    eliminated.reverse();
    name_passed(labels, tree, &passed);
    outwards(graph, labels, tree, &eliminated)
}

/// From the ground to the tips: the accelerations of the coordinates, from those of the carriers.
fn outwards(
    graph: &mut Graph,
    labels: &mut Labels,
    tree: &Tree,
    eliminated: &[Vec<Eliminated>],
) -> Accelerations {
    let mut moving: Vec<SpatialVector> = Vec::new();
    let mut all = Vec::new();
    for (link, gone) in tree.links.iter().zip(eliminated) {
        let carried = match link.carrier {
            Some(carrier) => {
                let at = acceleration_at(graph, link, moving[carrier]);
                let of = format!("linear_{}_at_{}", tree.links[carrier].name, link.name);
                labels.vector(&of, at.linear);
                at.seen_in(graph, link.turning)
            }
            None => SpatialVector::zero(graph),
        };
        let mut acceleration = carried;
        let mut found = Vec::new();
        for freedom in gone.iter().rev() {
            let carried = freedom.share.dot(graph, acceleration);
            let rate = graph.subtract(freedom.drive, carried);
            let rate = graph.quantity(rate);
            let made = freedom.twist.scaled(graph, rate);
            acceleration = acceleration.plus(graph, made);
            found.push(rate);
        }
        found.reverse();
        let acceleration = acceleration.quantities(graph);
        acceleration.name(labels, ["angular", "linear"], &link.name);
        carried.name(labels, ["angular_carried", "linear_carried"], &link.name);
        moving.push(acceleration);
        if link.is_free {
            let linear: Components = acceleration.linear;
            let mut linear = link.turning.to_carrier(graph, linear);
            if link.falls {
                linear = graph.add_vectors(linear, tree.gravity);
            }
            for ((rate, part), freedom) in found.iter_mut().zip(linear).zip(link.open()) {
                if graph.is_zero_vector(&freedom.twist.angular) {
                    *rate = part;
                }
            }
        }
        all.push(found);
    }
    Accelerations(all)
}

/// The acceleration that the carrier gives the link at its origin, in the axes of the carrier.
fn acceleration_at(graph: &mut Graph, link: &Link, carrier: SpatialVector) -> SpatialVector {
    let swept = graph.cross(carrier.angular, link.place);
    let linear = graph.add_vectors(carrier.linear, swept);
    SpatialVector {
        angular: carrier.angular,
        linear: graph.quantities(linear),
    }
}
