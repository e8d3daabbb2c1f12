//! The loads of joints, from the balances of everything that they carry: reactions and inverse
//! dynamics.

use crate::model::Labels;
use crate::symbolic::{Components, Graph, Id};

use super::articulated::wrench_on_carrier;
use super::bias::LinkMotion;
use super::link::{Freedom, Link, Tree};
use super::spatial::{Along, SpatialVector};

/// The motions of all links, with these accelerations of the coordinates, link by link.
pub fn motions(
    (graph, labels): (&mut Graph, &mut Labels),
    tree: &Tree,
    accelerations: &[Vec<Id>],
) -> Vec<LinkMotion> {
    let ground = LinkMotion::ground(graph, tree.gravity);
    let mut motions: Vec<LinkMotion> = Vec::new();
    for (link, rates) in tree.links.iter().zip(accelerations) {
        let carrier = link.carrier.map_or(ground, |carrier| motions[carrier]);
        let moving = carrier.carried(graph, link);
        let moving = moving.accelerated(graph, tree, link, rates);
        // the acceleration of a coordinate has a name of its own
        let SpatialVector { angular, linear } = moving.acceleration;
        let is_own = |vector: Components| rates.iter().any(|rate| vector.contains(rate));
        if !is_own(angular) {
            labels.explain(angular, "w' of each body, with the accelerations of joints");
            labels.vector_or_one("alpha_total", &link.name, angular);
        }
        if !is_own(linear) {
            labels.explain(
                linear,
                "a of each body, with those of joints, relative to free fall",
            );
            labels.vector(&format!("a_total_{}", link.name), linear);
        }
        motions.push(moving);
    }
    motions
}

/// The force and the moment of each joint on the carried body in the actual motion, about the
/// origin of the link, in its axes. Along the coordinates, they are the drives.
pub fn joint_loads(
    work: (&mut Graph, &mut Labels),
    tree: &Tree,
    accelerations: &[Vec<Id>],
) -> Vec<SpatialVector> {
    loads(work, tree, accelerations, driven)
}

/// The loads that follow from the balances, for given accelerations; `known` replaces components
/// that are known otherwise.
fn loads(
    (graph, labels): (&mut Graph, &mut Labels),
    tree: &Tree,
    accelerations: &[Vec<Id>],
    known: impl Fn(&mut Graph, &Link, &[Id], SpatialVector) -> SpatialVector,
) -> Vec<SpatialVector> {
    let motions = motions((graph, labels), tree, accelerations);
    let links = tree.links.iter().zip(&motions);
    let taken = links.map(|(link, moving)| {
        let taken = moving.taken_by(graph, &link.properties);
        taken.minus(graph, link.load())
    });
    let mut loads: Vec<SpatialVector> = taken.collect();
    for (index, link) in tree.links.iter().enumerate().rev() {
        let load = known(graph, link, &accelerations[index], loads[index]);
        loads[index] = load.quantities(graph);
        let mut name = |load: SpatialVector, of: &str| {
            load.explain(
                labels,
                "moment and force of each joint, in the axes of a body",
            );
            load.name(labels, ["joint_moment", "joint_force"], of);
        };
        name(loads[index], &link.name);
        if let Some(carrier) = link.carrier {
            let passed = wrench_on_carrier(graph, link, loads[index]);
            name(
                passed,
                &format!("{}_on_{}", link.name, tree.links[carrier].name),
            );
            loads[carrier] = loads[carrier].plus(graph, passed);
        }
    }
    loads
}

/// The load with its components along open coordinates replaced by the drives there.
fn driven(
    graph: &mut Graph,
    link: &Link,
    accelerations: &[Id],
    mut load: SpatialVector,
) -> SpatialVector {
    if link.is_free {
        return load;
    }
    for (freedom, rate) in link.open().zip(accelerations) {
        let own = graph.multiply(freedom.armature, *rate);
        let drive = graph.subtract(freedom.drive, own);
        let driven = freedom.twist.scaled(graph, drive);
        match freedom.twist.axis(graph) {
            Some(Along::Angular(axis)) => load.angular[axis] = driven.angular[axis],
            Some(Along::Linear(axis)) => load.linear[axis] = driven.linear[axis],
            None => {}
        }
    }
    load
}

/// The generalized force missing along each open coordinate, for these accelerations.
pub fn lacking(
    (graph, labels): (&mut Graph, &mut Labels),
    tree: &Tree,
    accelerations: &[Vec<Id>],
) -> Vec<Id> {
    let loads = loads((graph, labels), tree, accelerations, |_, _, _, load| load);
    let links = tree.links.iter().zip(loads).zip(accelerations);
    let freedoms = links.flat_map(|((link, load), rates)| {
        let freedoms = link.open().zip(rates);
        freedoms.map(move |(freedom, rate)| (freedom, load, *rate))
    });
    let all = freedoms.map(|(freedom, load, rate)| lacks(graph, freedom, load, rate));
    all.collect()
}

/// The generalized force missing along a coordinate, given its acceleration and the load of its
/// joint.
pub fn lacks(graph: &mut Graph, freedom: &Freedom, load: SpatialVector, acceleration: Id) -> Id {
    let carried = freedom.twist.dot(graph, load);
    let own = graph.multiply(freedom.armature, acceleration);
    let needed = graph.add(carried, own);
    graph.subtract(needed, freedom.drive)
}

/// What a load on a link contributes along each open coordinate, link by link.
pub fn along_freedoms(graph: &mut Graph, tree: &Tree, link: usize, load: SpatialVector) -> Vec<Id> {
    let mut loads: Vec<Option<SpatialVector>> = vec![None; tree.links.len()];
    loads[link] = Some(load);
    let mut at = link;
    while let (Some(carrier), Some(load)) = (tree.links[at].carrier, loads[at]) {
        let passed = wrench_on_carrier(graph, &tree.links[at], load);
        loads[carrier] = Some(passed.quantities(graph));
        at = carrier;
    }
    let links = tree.links.iter().zip(loads);
    let freedoms = links.flat_map(|(link, load)| link.open().map(move |freedom| (freedom, load)));
    let along = freedoms.map(|(freedom, load)| match load {
        Some(load) => freedom.twist.dot(graph, load),
        None => graph.zero(),
    });
    along.collect()
}

/// In world axes.
pub fn in_world(
    graph: &mut Graph,
    links: &[Link],
    index: usize,
    load: SpatialVector,
) -> SpatialVector {
    let mut turned = load;
    let mut at = Some(index);
    while let Some(index) = at {
        let link = &links[index];
        turned = SpatialVector {
            angular: link.turning.to_carrier(graph, turned.angular),
            linear: link.turning.to_carrier(graph, turned.linear),
        }
        .quantities(graph);
        at = link.carrier;
    }
    turned
}

/// A vector in world axes, in the axes of a link.
pub fn from_world(
    graph: &mut Graph,
    links: &[Link],
    index: usize,
    vector: Components,
) -> Components {
    let link = &links[index];
    let carried = match link.carrier {
        Some(carrier) => from_world(graph, links, carrier, vector),
        None => vector,
    };
    let turned = link.turning.to_link(graph, carried);
    graph.quantities(turned)
}
