//! Choices that change how much is to be computed, and nothing else (R36): where the origin of a
//! link is on the axis of its hinge, and whether a link is written in the axes of its carrier. Each
//! is tried, and kept if it is cheaper.

use crate::symbolic::{Graph, Id};

use super::link::Tree;
use super::pair::Along;
use super::properties::Properties;
use super::regrouping::{keep_axes, regroup};
use super::turning::Turning;

/// How many operations the trees that are tried have together: a stated limit, so that many bodies
/// do not take long to expand, and the same description has the same expansion.
const TRIED: u32 = 20_000;

/// How a tree is written.
#[derive(Clone)]
struct Choice {
    /// How far the origin of each link is moved along the axis of its hinge.
    slides: Vec<Option<Id>>,
    /// Which links are written in the axes of their carriers.
    borrows: Vec<bool>,
    /// Of which of two moments across the axis of each hinge nothing is left.
    sides: Vec<usize>,
}

impl Choice {
    fn apply(&self, graph: &mut Graph, tree: &Tree) -> Tree {
        let mut tree = tree.clone();
        for (index, distance) in self.slides.iter().enumerate() {
            if let Some(distance) = distance {
                slide_origin(graph, &mut tree, index, *distance);
            }
        }
        regroup(graph, &mut tree, &self.sides);
        keep_axes(graph, &mut tree);
        for (index, borrows) in self.borrows.iter().enumerate() {
            if *borrows {
                borrow_axes(graph, &mut tree, index);
            }
        }
        tree
    }
}

/// The tree as it is written with the fewest operations of those that are tried; `cost` is what the
/// accelerations of a tree take.
pub fn reduced(graph: &mut Graph, tree: &Tree, cost: impl Fn(&mut Graph, &Tree) -> u32) -> Tree {
    let count = tree.links.len();
    let mut choice = Choice {
        slides: vec![None; count],
        borrows: vec![false; count],
        sides: vec![2; count],
    };
    let mut best = choice.apply(graph, tree);
    let mut least = cost(graph, &best);
    let mut tried = least;
    loop {
        let before = least;
        for index in 0..count {
            // what does not turn about an axis has no other choices
            if hinge(graph, tree, index).is_none() {
                continue;
            }
            let mut further = Vec::new();
            let slides = distances(graph, tree, index).into_iter().map(Some);
            for slide in slides.chain([None]) {
                if slide != choice.slides[index] {
                    let mut changed = choice.clone();
                    changed.slides[index] = slide;
                    further.push(changed);
                }
            }
            let mut changed = choice.clone();
            changed.borrows[index] = !changed.borrows[index];
            further.push(changed);
            let mut changed = choice.clone();
            changed.sides[index] = 3 - changed.sides[index];
            further.push(changed);
            for changed in further {
                if tried > TRIED {
                    return best;
                }
                let written = changed.apply(graph, tree);
                if written == best {
                    continue;
                }
                let found = cost(graph, &written);
                tried += found;
                if found < least {
                    (least, best, choice) = (found, written, changed);
                }
            }
        }
        if least == before {
            return best;
        }
    }
}

/// Writes a link in the axes of its carrier, if all that it carries turns about the same axis.
fn borrow_axes(graph: &mut Graph, tree: &mut Tree, index: usize) {
    let Some(axis) = hinge(graph, tree, index) else {
        return;
    };
    let turns_alike = (0..tree.links.len())
        .filter(|other| tree.links[*other].carrier == Some(index))
        .all(|other| hinge(graph, tree, other) == Some(axis) && tree.links[other].angle.is_some());
    let link = &mut tree.links[index];
    let (Some(angle), turning) = (link.angle, link.turning) else {
        return;
    };
    if !turns_alike {
        return;
    }
    link.turning = Turning::Parallel;
    link.angle = None;
    link.properties = link.properties.turned(graph, turning);
    link.force = turning.to_carrier(graph, link.force);
    link.moment = turning.to_carrier(graph, link.moment);
    for link in &mut tree.links {
        if link.carrier == Some(index) {
            link.place = turning.to_carrier(graph, link.place);
            let whole = link.angle.map_or(angle, |own| graph.add(angle, own));
            link.angle = Some(whole);
            link.turning = Turning::by_angle(graph, axis, whole);
        }
    }
}

/// Writes what is carried by frames of right angles in the axes of their carriers.
pub fn drop_frames(graph: &mut Graph, tree: &mut Tree) {
    for index in 0..tree.links.len() {
        let link = &tree.links[index];
        let Turning::By(rows) = link.turning else {
            continue;
        };
        let is_number = |a: &Id| {
            graph
                .as_number(*a)
                .is_some_and(|a| a.to_integer().is_some())
        };
        if !link.freedoms.is_empty() || !rows.iter().flatten().all(is_number) {
            continue;
        }
        let all = carried_by(tree, index);
        tree.links[index].turning = Turning::Parallel;
        let turning = Turning::By(rows);
        for other in all {
            let link = &mut tree.links[other];
            link.properties = link.properties.turned(graph, turning);
            link.force = turning.to_carrier(graph, link.force);
            link.moment = turning.to_carrier(graph, link.moment);
            for freedom in &mut link.freedoms {
                let twist = &mut freedom.twist;
                let before = graph.sum(&twist.angular);
                twist.angular = turning.to_carrier(graph, twist.angular);
                twist.linear = turning.to_carrier(graph, twist.linear);
                // an axis may be turned into the opposite of one
                let after = graph.sum(&twist.angular);
                if before != after {
                    link.angle = link.angle.map(|angle| graph.negate(angle));
                }
            }
            if other != index {
                link.place = turning.to_carrier(graph, link.place);
                link.turning = link.turning.seen_turned(graph, rows);
            }
        }
    }
    for index in 0..tree.links.len() {
        let link = &tree.links[index];
        let (carrier, place) = (link.carrier, link.place);
        if !link.freedoms.is_empty() || !matches!(link.turning, Turning::Parallel) {
            continue;
        }
        for other in &mut tree.links {
            if other.carrier == Some(index) {
                other.carrier = carrier;
                other.place = graph.add_vectors(other.place, place);
            }
        }
        let link = &mut tree.links[index];
        let zero = Properties::none(graph);
        let has_load = [link.force, link.moment];
        if link.properties == zero && has_load.iter().all(|load| graph.is_zero_vector(load)) {
            // nothing is left of it
            link.carrier = None;
        }
    }
}

/// A link, and all that it carries.
fn carried_by(tree: &Tree, index: usize) -> Vec<usize> {
    let mut all = vec![index];
    for (other, link) in tree.links.iter().enumerate() {
        if link.carrier.is_some_and(|carrier| all.contains(&carrier)) {
            all.push(other);
        }
    }
    all
}

/// The axis of a hinge.
fn hinge(graph: &Graph, tree: &Tree, index: usize) -> Option<usize> {
    match tree.links[index].freedoms.as_slice() {
        [freedom] => match freedom.twist.axis(graph)? {
            Along::Angular(axis) => Some(axis),
            Along::Linear(_) => None,
        },
        _ => None,
    }
}

/// How far an origin may be moved along the axis of its hinge: to where it is nearest to the origin of
/// the carrier, to the center of mass, and to what is carried.
fn distances(graph: &mut Graph, tree: &Tree, index: usize) -> Vec<Id> {
    let Some(axis) = hinge(graph, tree, index) else {
        return Vec::new();
    };
    let link = &tree.links[index];
    let mut distances = vec![graph.negate(link.place[axis])];
    if !graph.is_zero(link.properties.mass) {
        distances.push(graph.divide(link.properties.first[axis], link.properties.mass));
    }
    let carried = tree.links.iter().filter(|link| link.carrier == Some(index));
    distances.extend(carried.map(|link| link.place[axis]));
    distances.retain(|distance| graph.is_early(*distance) && !graph.is_zero(*distance));
    distances.dedup();
    distances
}

/// Moves the origin of a link along the axis of its hinge.
fn slide_origin(graph: &mut Graph, tree: &mut Tree, index: usize, distance: Id) {
    let Some(axis) = hinge(graph, tree, index) else {
        return;
    };
    let mut step = graph.zeros();
    step[axis] = distance;
    let back = graph.negate_vector(step);
    let link = &mut tree.links[index];
    link.place = graph.add_vectors(link.place, step);
    link.properties = link.properties.seen_from(graph, back);
    let lever = graph.cross(back, link.force);
    link.moment = graph.add_vectors(link.moment, lever);
    for link in &mut tree.links {
        if link.carrier == Some(index) {
            link.place = graph.add_vectors(link.place, back);
        }
    }
}
