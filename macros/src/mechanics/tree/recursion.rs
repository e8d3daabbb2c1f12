//! The articulated-body recursion: from the tips to the ground, and back.

use crate::symbolic::{Components, Graph, Id};

use super::articulated::{Articulated, Eliminated, wrench_on_carrier};
use super::bias::{Pair, derive_bias};
use super::link::{Link, Tree};
use super::mass_matrix::MassMatrix;
use super::reductions::{drop_frames, reduced};

/// The accelerations of the coordinates, link by link in the order of its freedoms; of a link that
/// is free, those of its origin along world axes first.
pub struct Accelerations(pub Vec<Vec<Id>>);

/// Solves for the accelerations of all joints.
pub fn derive_tree(graph: &mut Graph, tree: &Tree) -> Accelerations {
    let mut tree = tree.clone();
    drop_frames(graph, &mut tree);
    let best = reduced(graph, &tree, |graph, tree| {
        let found = solve(graph, tree);
        cost(graph, &found)
    });
    solve(graph, &best)
}

fn cost(graph: &Graph, found: &Accelerations) -> u32 {
    graph.late_cost(&found.0.concat()).total()
}

/// By the recursion; of few freedoms by the mass matrix, if that is cheaper.
fn solve(graph: &mut Graph, tree: &Tree) -> Accelerations {
    let mut best = recursion(graph, tree).folded(graph);
    let freedoms = || tree.links.iter().map(|link| link.freedoms.len());
    if freedoms().sum::<usize>() <= 2 {
        let mut solved = MassMatrix::derive(graph, tree).solve(graph);
        let by_matrix = freedoms().map(|count| solved.drain(..count).collect());
        let by_matrix = Accelerations(by_matrix.collect()).folded(graph);
        if cost(graph, &by_matrix) < cost(graph, &best) {
            best = by_matrix;
        }
    }
    best
}

impl Accelerations {
    fn folded(&self, graph: &mut Graph) -> Self {
        let mut folded = graph.folded(&self.0.concat()).into_iter();
        let links = self.0.iter();
        Self(links.map(|link| folded.by_ref().take(link.len()).collect()).collect())
    }
}

fn recursion(graph: &mut Graph, tree: &Tree) -> Accelerations {
    let bias = derive_bias(graph, tree);
    let mut inertia: Vec<Articulated> = Vec::new();
    let mut lacking: Vec<Pair> = Vec::new();
    for (link, (_, own)) in tree.links.iter().zip(&bias) {
        inertia.push(Articulated::of(graph, &link.properties));
        lacking.push(*own);
    }
    let mut eliminated: Vec<Vec<Eliminated>> = Vec::new();
    for (index, link) in tree.links.iter().enumerate().rev() {
        let (mut own, mut load) = (inertia[index].quantities(graph), lacking[index]);
        load = load.quantities(graph);
        let gone = link.freedoms.iter().map(|freedom| {
            let gone = own.eliminate(graph, freedom.twist, freedom.drive, &mut load);
            own = own.quantities(graph);
            load = load.quantities(graph);
            gone
        });
        eliminated.push(gone.collect());
        if let Some(carrier) = link.carrier {
            let seen = own.seen_by_carrier(graph, link);
            inertia[carrier] = inertia[carrier].plus(graph, &seen);
            let wrench = wrench_on_carrier(graph, link, load);
            lacking[carrier] = lacking[carrier].plus(graph, wrench);
        }
    }
    eliminated.reverse();
    let mut moving: Vec<Pair> = Vec::new();
    let mut all = Vec::new();
    for (link, gone) in tree.links.iter().zip(&eliminated) {
        let mut acceleration = match link.carrier {
            Some(carrier) => acceleration_at(graph, link, moving[carrier]),
            None => Pair::zero(graph),
        };
        let mut found = Vec::new();
        for freedom in gone.iter().rev() {
            let carried = freedom.share.dot(graph, acceleration);
            let rate = graph.subtract(freedom.drive, carried);
            let rate = graph.quantity(rate);
            let made = Pair::of(&freedom.twist).scaled(graph, rate);
            acceleration = acceleration.plus(graph, made);
            found.push(rate);
        }
        found.reverse();
        moving.push(acceleration.quantities(graph));
        if link.is_free {
            let linear: Components = acceleration.linear;
            let linear = link.turning.to_carrier(graph, linear);
            let linear = graph.add_vectors(linear, tree.gravity);
            for ((rate, part), freedom) in found.iter_mut().zip(linear).zip(&link.freedoms) {
                if graph.is_zero_vector(&freedom.twist.angular) {
                    *rate = part;
                }
            }
        }
        all.push(found);
    }
    Accelerations(all)
}

/// What the carrier's acceleration makes at the origin of the link, in its axes.
fn acceleration_at(graph: &mut Graph, link: &Link, carrier: Pair) -> Pair {
    let swept = graph.cross(carrier.angular, link.place);
    let linear = graph.add_vectors(carrier.linear, swept);
    let linear = graph.quantities(linear);
    Pair {
        angular: link.turning.to_link(graph, carrier.angular),
        linear: link.turning.to_link(graph, linear),
    }
    .quantities(graph)
}
