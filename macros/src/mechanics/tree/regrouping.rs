//! Parts of a link that could as well be fixed to its carrier, since its joint does not distinguish
//! them.

use crate::symbolic::Graph;

use super::link::{Freedom, Link, Tree};
use super::properties::Properties;
use super::spatial::Along;
use super::turning::Turning;

impl Properties {
    /// The part that moves as if it were fixed to the carrier, whatever the joint does: for a
    /// hinge, a rod along its axis; for a slide, the inertia; for a ball joint, a point mass at its
    /// center.
    fn fixed_part(&self, graph: &mut Graph, link: &Link, side: usize) -> Option<Self> {
        let mut part = Self::none(graph);
        match link.freedoms.as_slice() {
            [] => return Some(*self),
            [freedom] => match freedom.twist.axis(graph)? {
                Along::Linear(_) => part.inertia = self.inertia,
                Along::Angular(axis) => {
                    let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
                    part.mass = self.mass;
                    part.first[axis] = self.first[axis];
                    let across = (axis + side) % 3;
                    part.inertia[i][i] = self.inertia[across][across];
                    part.inertia[j][j] = self.inertia[across][across];
                }
            },
            freedoms => {
                let is_angular = |freedom: &Freedom| {
                    matches!(freedom.twist.axis(graph), Some(Along::Angular(_)))
                };
                if !freedoms.iter().all(is_angular) {
                    return None;
                }
                part.mass = self.mass;
            }
        }
        Some(part)
    }
}

/// Moves such parts of links to the carriers (R34). Parts that move to the ground are dropped.
pub fn regroup(graph: &mut Graph, tree: &mut Tree, sides: &[usize]) {
    for index in (0..tree.links.len()).rev() {
        let link = &tree.links[index];
        let own = link.properties;
        let Some(part) = own.fixed_part(graph, link, sides[index]) else {
            continue;
        };
        let is_massless = graph.is_zero(part.mass) && graph.is_zero_vector(&part.first);
        if !is_massless && !graph.are_early(&link.place) {
            continue;
        }
        let (place, turning, carrier) = (link.place, link.turning, link.carrier);
        // the part of a hinge has the same components in both axes; that of a welded link is
        // rotated
        let seen = if link.freedoms.is_empty() {
            part.turned(graph, turning)
        } else {
            part
        };
        tree.links[index].properties = own.minus(graph, &part);
        if let Some(carrier) = carrier {
            let seen = seen.seen_from(graph, place);
            let carried = tree.links[carrier].properties;
            tree.links[carrier].properties = carried.plus(graph, &seen);
        }
    }
}

/// Gives links whose rotation changes nothing the axes of their carriers (R37): symmetric rotors
/// that carry nothing, and on which no load acts except the drive and gravity.
pub fn keep_axes(graph: &Graph, tree: &mut Tree) {
    for index in 0..tree.links.len() {
        if turns_unseen(graph, tree, index) {
            tree.links[index].turning = Turning::Parallel;
        }
    }
}

/// What the equations leave out of each link, and why.
pub fn left_out(graph: &Graph, before: &Tree, after: &Tree) -> Vec<String> {
    let mut lines = Vec::new();
    for (index, (link, own)) in after.links.iter().zip(&before.links).enumerate() {
        let [freedom] = link.freedoms.as_slice() else {
            continue;
        };
        let (name, joint) = (&link.name, &freedom.joint);
        if matches!(link.turning, Turning::Parallel) && turns_unseen(graph, after, index) {
            lines.push(format!("the sine and cosine of `{joint}` in the accelerations: `{name}` is symmetric about its axis, carries nothing, and no load on it turns with it"));
        }
        if graph.is_zero(link.properties.mass) && !graph.is_zero(own.properties.mass) {
            let carrier = match beyond(graph, after, index).map(|carrier| &after.links[carrier]) {
                // it belongs to a massless link of the same joint
                Some(part) if part.name == *name => continue,
                Some(carrier) => format!("`{}`", carrier.name),
                None => "the ground".to_owned(),
            };
            lines.push(format!("the mass of `{name}` in its own balances: `{joint}` cannot tell it from a mass of {carrier} on its axis"));
        }
    }
    lines
}

/// The carrier of a link, beyond the massless parts of its joint.
fn beyond(graph: &Graph, tree: &Tree, index: usize) -> Option<usize> {
    let mut carrier = tree.links[index].carrier;
    while let Some(part) = carrier.map(|carrier| &tree.links[carrier])
        && part.name == tree.links[index].name
        && graph.is_zero(part.properties.mass)
    {
        carrier = part.carrier;
    }
    carrier
}

/// Whether the equations do not depend on the rotation of a link.
fn turns_unseen(graph: &Graph, tree: &Tree, index: usize) -> bool {
    let carries = (0..tree.links.len())
        .any(|other| tree.links[other].carrier == Some(index) && !tree.is_idle(graph, other));
    let link = &tree.links[index];
    let [freedom] = link.freedoms.as_slice() else {
        return false;
    };
    let Some(Along::Angular(axis)) = freedom.twist.axis(graph) else {
        return false;
    };
    let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
    let (rows, first) = (&link.properties.inertia, link.properties.first);
    let is_symmetric = rows[i][i] == rows[j][j]
        && [(0, 1), (1, 2), (2, 0)]
            .iter()
            .all(|(a, b)| graph.is_zero(rows[*a][*b]))
        && graph.is_along(first, axis);
    let is_loaded = !graph.is_zero_vector(&link.force) || !graph.is_zero_vector(&link.moment);
    is_symmetric && !is_loaded && link.added.is_zero(graph) && !carries
}
