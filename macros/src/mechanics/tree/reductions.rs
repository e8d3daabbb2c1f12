//! Choices that change only the cost of the computation (R36): where on the axis of its hinge the
//! origin of a link is, and whether a link is written in the axes of its carrier. Each is tried,
//! and kept if it is cheaper.

use crate::symbolic::{Graph, Id};

use super::link::Tree;
use super::properties::Properties;
use super::regrouping::{keep_axes, regroup};
use super::spatial::{Along, SpatialInertia};
use super::turning::Turning;

/// The most operations of all trees that are tried, added up. With a limit on operations, not on
/// time, systems of many bodies expand quickly, and the same description always has the same
/// expansion.
const TRIED: u32 = 20_000;
/// The same limit if equal legs change together, since each such change gains more.
const TRIED_ALIKE: u32 = 45_000;

/// The form of a tree.
#[derive(Clone)]
struct Choice {
    /// For each link, the place on the axis of its hinge to which its origin is moved, by its index
    /// among the places that are tried.
    slides: Vec<Option<usize>>,
    /// Whether each link is written in the axes of its carrier.
    borrows: Vec<bool>,
    /// For each hinge, the index of the moment of inertia across its axis that is eliminated.
    sides: Vec<usize>,
}

impl Choice {
    fn apply(&self, graph: &mut Graph, tree: &Tree) -> Tree {
        let mut written = tree.clone();
        for (index, chosen) in self.slides.iter().enumerate() {
            if let Some(chosen) = chosen
                && let Some(Some(distance)) = distances(graph, tree, index).get(*chosen)
            {
                slide_origin(graph, &mut written, index, *distance);
            }
        }
        let mut tree = written;
        regroup(graph, &mut tree, &self.sides);
        keep_axes(graph, &mut tree);
        for (index, borrows) in self.borrows.iter().enumerate() {
            if *borrows {
                borrow_axes(graph, &mut tree, index);
            }
        }
        tree
    }

    /// The form with one change, made in all of these equal links.
    fn changed(&self, links: &[usize], change: Change) -> Self {
        let mut changed = self.clone();
        for link in links {
            match change {
                Change::Slide(place) => changed.slides[*link] = place,
                Change::Borrow => changed.borrows[*link] = !self.borrows[links[0]],
                Change::Side => changed.sides[*link] = 3 - self.sides[links[0]],
            }
        }
        changed
    }
}

/// A change that a link may get.
#[derive(Clone, Copy)]
enum Change {
    Slide(Option<usize>),
    Borrow,
    Side,
}

/// A search for the tree with the fewest operations.
struct Search<'a, C> {
    tree: &'a Tree,
    cost: C,
    choice: Choice,
    /// The forms that were tried so far, the best of them, and its cost.
    seen: Vec<Tree>,
    best: Tree,
    least: u32,
    tried: u32,
}

impl<C: Fn(&mut Graph, &Tree) -> u32> Search<'_, C> {
    /// Changes one link after another, or several equal ones at once, as long as that helps and at
    /// most this many operations are tried.
    fn descend(&mut self, graph: &mut Graph, alike: &[Vec<usize>], most: u32) {
        loop {
            let before = self.least;
            for links in alike {
                let places = distances(graph, self.tree, links[0]).len();
                let slides = (0..places).map(Some).chain([None]).map(Change::Slide);
                for change in slides.chain([Change::Borrow, Change::Side]) {
                    if self.tried > most {
                        return;
                    }
                    self.try_out(graph, links, change);
                }
            }
            if self.least == before {
                return;
            }
        }
    }

    fn try_out(&mut self, graph: &mut Graph, links: &[usize], change: Change) {
        let changed = self.choice.changed(links, change);
        let written = changed.apply(graph, self.tree);
        if self.seen.contains(&written) {
            return;
        }
        let found = (self.cost)(graph, &written);
        self.tried += found;
        if found < self.least {
            (self.least, self.best, self.choice) = (found, written.clone(), changed);
        }
        self.seen.push(written);
    }
}

/// The tree in the form with the fewest operations among those that are tried; `cost` is the cost
/// of the accelerations of a tree.
pub fn reduced(graph: &mut Graph, tree: &Tree, cost: impl Fn(&mut Graph, &Tree) -> u32) -> Tree {
    let count = tree.links.len();
    let choice = Choice {
        slides: vec![None; count],
        borrows: vec![false; count],
        sides: vec![2; count],
    };
    let best = choice.apply(graph, tree);
    let least = cost(graph, &best);
    let mut search = Search {
        tree,
        cost,
        choice,
        seen: vec![best.clone()],
        best,
        least,
        tried: least,
    };
    let hinges: Vec<usize> = (0..count)
        .filter(|index| hinge(graph, tree, *index).is_some())
        .collect();
    // start at the tips: then it is known whether everything that a link carries rotates about one
    // axis
    let mut alike = alike(graph, tree, &hinges);
    alike.reverse();
    if alike.len() < hinges.len() {
        search.descend(graph, &alike, TRIED_ALIKE);
    }
    let each: Vec<Vec<usize>> = hinges.iter().map(|index| vec![*index]).collect();
    search.descend(graph, &each, TRIED);
    search.best
}

/// The hinges, in groups of equal ones: they are carried by hinges about the same axes, and carry
/// as many links.
fn alike(graph: &Graph, tree: &Tree, hinges: &[usize]) -> Vec<Vec<usize>> {
    let described = |index: usize| {
        let mut axes = Vec::new();
        let mut next = Some(index);
        while let Some(link) = next {
            axes.push(hinge(graph, tree, link));
            next = tree.links[link].carrier;
        }
        let carried = tree
            .links
            .iter()
            .filter(|link| link.carrier == Some(index))
            .count();
        (axes, carried)
    };
    let mut groups: Vec<(_, Vec<usize>)> = Vec::new();
    for index in hinges {
        let own = described(*index);
        match groups.iter_mut().find(|(other, _)| *other == own) {
            Some((_, links)) => links.push(*index),
            None => groups.push((own, vec![*index])),
        }
    }
    groups.into_iter().map(|(_, links)| links).collect()
}

/// Writes a link in the axes of its carrier, if everything that it carries rotates about the same
/// axis.
fn borrow_axes(graph: &mut Graph, tree: &mut Tree, index: usize) {
    let Some(axis) = hinge(graph, tree, index) else {
        return;
    };
    let turns_alike = (0..tree.links.len())
        .filter(|other| tree.links[*other].carrier == Some(index))
        .filter(|other| !tree.is_idle(graph, *other))
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
    link.added = link.added.turned(graph, turning);
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

/// Merges all links that are welded to a link into it, from the tips to the ground. The welded
/// links remain, without mass.
pub fn merge_welds(graph: &mut Graph, tree: &mut Tree) {
    for index in (0..tree.links.len()).rev() {
        let link = tree.links[index].clone();
        let Some(carrier) = link.carrier.filter(|_| link.freedoms.is_empty()) else {
            continue;
        };
        let zeros = graph.zeros();
        let (place, turning) = (link.place, link.turning);
        let own = link.properties.turned(graph, turning);
        let own = own.seen_from(graph, place);
        let added = link.added.seen_by_carrier(graph, &link);
        let force = turning.to_carrier(graph, link.force);
        let moment = turning.to_carrier(graph, link.moment);
        let lever = graph.cross(place, force);
        let moment = graph.add_vectors(moment, lever);
        let below = &mut tree.links[carrier];
        below.properties = below.properties.plus(graph, &own);
        below.added = below.added.plus(graph, &added);
        below.force = graph.add_vectors(below.force, force);
        below.moment = graph.add_vectors(below.moment, moment);
        let link = &mut tree.links[index];
        link.properties = Properties::none(graph);
        link.added = SpatialInertia::none(graph);
        (link.force, link.moment) = (zeros, zeros);
    }
}

/// Writes links that are carried by frames at right angles in the axes of the carriers of the
/// frames.
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
            link.added = link.added.turned(graph, turning);
            link.force = turning.to_carrier(graph, link.force);
            link.moment = turning.to_carrier(graph, link.moment);
            for freedom in &mut link.freedoms {
                let twist = &mut freedom.twist;
                let before = graph.sum(&twist.angular);
                twist.angular = turning.to_carrier(graph, twist.angular);
                twist.linear = turning.to_carrier(graph, twist.linear);
                // the rotation may take an axis to the opposite of a coordinate axis
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
    }
}

/// A link, and everything that it carries.
fn carried_by(tree: &Tree, index: usize) -> Vec<usize> {
    let mut all = vec![index];
    for (other, link) in tree.links.iter().enumerate() {
        if link.carrier.is_some_and(|carrier| all.contains(&carrier)) {
            all.push(other);
        }
    }
    all
}

/// The coordinate axis of a hinge, if it rotates about one.
fn hinge(graph: &Graph, tree: &Tree, index: usize) -> Option<usize> {
    match tree.links[index].freedoms.as_slice() {
        [freedom] => match freedom.twist.axis(graph)? {
            Along::Angular(axis) => Some(axis),
            Along::Linear(_) => None,
        },
        _ => None,
    }
}

/// The displacements of an origin along the axis of its hinge that are tried: to the point nearest
/// to the origin of the carrier, to the center of mass, and to the carried joints. `None` if the
/// origin is there already.
fn distances(graph: &mut Graph, tree: &Tree, index: usize) -> Vec<Option<Id>> {
    let Some(axis) = hinge(graph, tree, index) else {
        return Vec::new();
    };
    let link = &tree.links[index];
    let mut distances = vec![graph.negate(link.place[axis])];
    if !graph.is_zero(link.properties.mass) {
        distances.push(graph.divide(link.properties.first[axis], link.properties.mass));
    }
    let carried = (0..tree.links.len())
        .filter(|other| tree.links[*other].carrier == Some(index) && !tree.is_idle(graph, *other));
    distances.extend(carried.map(|other| tree.links[other].place[axis]));
    let is_known = |distance: &Id| graph.is_early(*distance) && !graph.is_zero(*distance);
    let distances = distances.into_iter();
    distances
        .map(|distance| Some(distance).filter(is_known))
        .collect()
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
    link.added = link.added.seen_from(graph, back);
    let lever = graph.cross(back, link.force);
    link.moment = graph.add_vectors(link.moment, lever);
    for link in &mut tree.links {
        if link.carrier == Some(index) {
            link.place = graph.add_vectors(link.place, back);
        }
    }
}
