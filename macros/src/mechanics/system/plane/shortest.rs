//! The choice of the joints that carry links. Absolute angles do not depend on where loops are cut,
//! and in short chains, inertia couples fewer links.

use crate::mechanics::tree::link::{Link, Tree};
use crate::symbolic::{Components, Graph};

use super::super::constraints::Ends;
use super::absolute::is_turn;

/// A tree in which some hinges that closed loops carry links, and others close the loops instead.
pub struct Shortest {
    pub tree: Tree,
    /// For each link, its index in the given tree.
    pub numbers: Vec<usize>,
}

/// A hinge that closes a loop: its two links, each with the offset of the hinge from the origin.
type Pin = [(Option<usize>, Components); 2];

/// The tree in which each link is carried by the hinge that brings it nearest to the ground.
pub fn shortest(graph: &mut Graph, tree: &Tree, ends: &[&Ends<'_>]) -> Shortest {
    let mut tree = tree.clone();
    let hinges = ends.iter().filter(|ends| ends.closing.kind.is_hinge());
    let mut pins: Vec<Pin> = hinges
        .map(|ends| [0, 1].map(|end| (ends.links[end], ends.offsets[end])))
        .collect();
    while let Some((pin, end)) = nearer(graph, &tree, &pins) {
        exchange(graph, &mut tree, &mut pins, pin, end);
    }
    sorted(&tree)
}

/// A hinge that would bring one of its links nearer to the ground by carrying it.
fn nearer(graph: &Graph, tree: &Tree, pins: &[Pin]) -> Option<(usize, usize)> {
    let depth = |link: Option<usize>| {
        let mut depth = 0;
        let mut at = link;
        while let Some(link) = at {
            depth += 1;
            at = tree.links[link].carrier;
        }
        depth
    };
    let is_open_hinge = |link: &Link| match link.freedoms.as_slice() {
        [freedom] => freedom.given.is_none() && !link.is_free && is_turn(graph, freedom),
        _ => false,
    };
    let all = pins.iter().enumerate();
    let mut all = all.flat_map(|(number, pin)| [0, 1].map(|end| (number, end, pin)));
    let found = all.find(|(_, end, pin)| {
        let (Some(link), (other, _)) = (pin[*end].0, pin[1 - end]) else {
            return false;
        };
        let is_above = other.is_some_and(|other| tree.is_above(other, link));
        is_open_hinge(&tree.links[link]) && !is_above && depth(other) + 1 < depth(Some(link))
    });
    found.map(|(number, end, _)| (number, end))
}

/// Lets a hinge that closed a loop carry a link. The hinge that carried the link closes the loop
/// instead.
fn exchange(graph: &mut Graph, tree: &mut Tree, pins: &mut [Pin], pin: usize, end: usize) {
    let ((Some(index), step), (carrier, place)) = (pins[pin][end], pins[pin][1 - end]) else {
        return;
    };
    let back = graph.negate_vector(step);
    let link = &mut tree.links[index];
    link.properties = link.properties.seen_from(graph, back);
    let lever = graph.cross(back, link.force);
    link.moment = graph.add_vectors(link.moment, lever);
    let before = (link.carrier, link.place);
    (link.carrier, link.place) = (carrier, place);
    for other in &mut tree.links {
        if other.carrier == Some(index) {
            other.place = graph.add_vectors(other.place, back);
        }
    }
    let zeros = graph.zeros();
    pins[pin][end] = (Some(index), zeros);
    pins[pin][1 - end] = before;
    for (link, offset) in pins.iter_mut().flatten() {
        if *link == Some(index) {
            *offset = graph.add_vectors(*offset, back);
        }
    }
}

/// The links, each after its carrier.
fn sorted(tree: &Tree) -> Shortest {
    let mut numbers: Vec<usize> = Vec::new();
    while numbers.len() < tree.links.len() {
        for (number, link) in tree.links.iter().enumerate() {
            let is_carried = link
                .carrier
                .is_none_or(|carrier| numbers.contains(&carrier));
            if is_carried && !numbers.contains(&number) {
                numbers.push(number);
            }
        }
    }
    let links = numbers.iter().map(|number| {
        let mut link = tree.links[*number].clone();
        let place = |carrier| numbers.iter().position(|known| *known == carrier);
        link.carrier = link.carrier.and_then(place);
        link
    });
    Shortest {
        tree: Tree {
            links: links.collect(),
            gravity: tree.gravity,
        },
        numbers,
    }
}
