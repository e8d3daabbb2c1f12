//! What a joint carries, treated as one body.

use crate::mechanics::closed_forms::at_rest;
use crate::mechanics::tree::{Built, Properties};
use crate::model::{Workspace, displaced};
use crate::symbolic::Components;

/// Everything that a joint carries, with the coordinates of further joints at zero, in the axes of
/// the body of the joint.
pub struct Carried {
    /// The vector to the center of mass from the origin of the body, or from the held point.
    pub center: Components,
    /// The inertia about the origin.
    pub about_origin: [Components; 3],
    /// The inertia about the center of mass.
    pub about_center: [Components; 3],
}

impl Carried {
    pub fn by(joint: usize, built: &Built, work: &mut Workspace) -> Self {
        let whole = together(work, built, built.body(joint));
        let [mass, entries @ ..] = whole.entries();
        let rest = at_rest(work, &[&[mass], &entries[..]].concat(), |_| false);
        let [mass, x, y, z, xx, yy, zz, xy, yz, zx] = core::array::from_fn(|entry| rest[entry]);
        let graph = &mut work.graph;
        let center = [x, y, z].map(|first| graph.divide(first, mass));
        let about_origin = [[xx, xy, zx], [xy, yy, yz], [zx, yz, zz]];
        let lighter = graph.negate(mass);
        Self {
            center,
            about_origin,
            about_center: displaced(graph, lighter, center, &about_origin),
        }
    }
}

/// The mass, first moment and inertia of a link together with everything that it carries.
fn together(work: &mut Workspace, built: &Built, root: usize) -> Properties {
    let (links, graph) = (&built.tree.links, &mut work.graph);
    let mut sums: Vec<Properties> = links.iter().map(|link| link.properties).collect();
    for (index, link) in links.iter().enumerate().skip(root + 1).rev() {
        if let Some(carrier) = link.carrier.filter(|_| built.tree.is_above(index, root)) {
            let seen = sums[index].turned(graph, link.turning);
            let seen = seen.seen_from(graph, link.place);
            sums[carrier] = sums[carrier].plus(graph, &seen);
        }
    }
    sums[root]
}
