//! The loop that a joint closes, relative to the link that carries both of its ends: the motion of
//! that link makes no difference to the joint.

use crate::mechanics::tree::link::Tree;
use crate::model::{Connection, Labels};
use crate::symbolic::{Components, Graph};

use super::placed::{Placed, seen_from};

/// Both sides of a joint that closes a loop.
pub struct Ends<'a> {
    pub closing: &'a Connection,
    /// The links, `None` for the ground, and the offsets of the joint from their origins.
    pub links: [Option<usize>; 2],
    pub offsets: [Components; 2],
    pub is_planar: bool,
}

/// The places of the links of a loop. In space, they are relative to the last link that carries
/// both ends, in its axes. In the plane, where the absolute angles are known, they are relative to
/// the origin of that link, in world axes.
pub struct Loop {
    /// The last link that carries both ends, `None` for the ground.
    apex: Option<usize>,
    /// The apex itself.
    start: Placed,
    links: Vec<Option<Placed>>,
}

impl Loop {
    /// `in_world` are the places of all links in world axes.
    pub fn of(
        (graph, labels): (&mut Graph, &mut Labels),
        (tree, in_world): (&Tree, &[Placed]),
        ends: &Ends<'_>,
    ) -> Self {
        let at_rest = Placed::at_rest(graph);
        let Some(apex) = apex(tree, ends.links) else {
            return Self {
                apex: None,
                start: at_rest,
                links: in_world.iter().cloned().map(Some).collect(),
            };
        };
        let start = if ends.is_planar {
            in_world[apex].at_origin(graph)
        } else {
            at_rest
        };
        let mut links: Vec<Option<Placed>> = vec![None; tree.links.len()];
        for (index, link) in tree.links.iter().enumerate() {
            let carrier = link.carrier.and_then(|carrier| {
                if carrier == apex {
                    Some(&start)
                } else {
                    links[carrier].as_ref()
                }
            });
            let is_between = |end: Option<usize>| end.is_some_and(|end| tree.is_above(end, index));
            let Some(carrier) = carrier.filter(|_| ends.links.into_iter().any(is_between)) else {
                continue;
            };
            let next = carrier.carried(graph, link, None);
            next.label(graph, labels, (tree, index), Some(apex));
            links[index] = Some(next);
        }
        Self {
            apex: Some(apex),
            start,
            links,
        }
    }

    /// The place of a link of the loop, `None` for the ground.
    pub fn placed(&self, link: Option<usize>) -> &Placed {
        let below = link.filter(|_| link != self.apex);
        below
            .and_then(|link| self.links[link].as_ref())
            .unwrap_or(&self.start)
    }

    /// Names the arms of both ends.
    pub fn label_arms(
        &self,
        (graph, labels): (&mut Graph, &mut Labels),
        tree: &Tree,
        ends: &Ends<'_>,
    ) {
        for (link, offset) in ends.links.into_iter().zip(ends.offsets) {
            let arm = self.placed(link).to_frame(graph, offset);
            if let Some(link) = link {
                labels.vector(&format!("arm_{}", seen_from((tree, link), self.apex)), arm);
            }
        }
    }

    /// Vectors along the axes of the loop, in world axes.
    pub fn to_world<const N: usize>(
        &self,
        graph: &mut Graph,
        in_world: &[Placed],
        vectors: [Components; N],
    ) -> [Components; N] {
        match self.apex {
            Some(apex) if self.start.turning != in_world[apex].turning => {
                vectors.map(|vector| in_world[apex].to_frame(graph, vector))
            }
            _ => vectors,
        }
    }
}

/// The last link that carries both ends.
fn apex(tree: &Tree, [one, other]: [Option<usize>; 2]) -> Option<usize> {
    let (mut at, other) = (one, other?);
    while let Some(link) = at {
        if tree.is_above(other, link) {
            break;
        }
        at = tree.links[link].carrier;
    }
    at
}
