//! Vectors that are fixed in links, in world axes.

use crate::mechanics::tree::link::Tree;
use crate::model::Labels;
use crate::symbolic::{Components, Graph, Id};

use super::super::constraints::Placed;

/// The vectors formed so far for each link. A vector parallel to one of them becomes a multiple of
/// it.
pub struct Arms<'a> {
    placed: &'a [Placed],
    /// Each vector in the axes of the link, and in those of the world.
    known: Vec<Vec<[Components; 2]>>,
}

/// A vector of a link, written as `along a + across z x a` with an arm a of the link, so that
/// products with the vector become products with the arm.
pub struct ByArm {
    arm: Components,
    along: Id,
    across: Id,
}

/// `z x v`
pub fn quarter_turn(graph: &mut Graph, [x, y, _]: Components) -> Components {
    let zero = graph.zero();
    [graph.negate(y), x, zero]
}

impl<'a> Arms<'a> {
    pub fn new(placed: &'a [Placed]) -> Self {
        Self {
            placed,
            known: vec![Vec::new(); placed.len()],
        }
    }

    /// A vector of a link, in world axes. The opposite of a known vector is its negative.
    pub fn world(&mut self, graph: &mut Graph, link: usize, vector: Components) -> Components {
        if graph.is_zero_vector(&vector) {
            return vector;
        }
        let mut parts = vector.into_iter();
        let first = parts.find(|part| !graph.is_zero(*part));
        let is_negative = first.is_some_and(|first| graph.split_sign(first).0);
        let signed = |graph: &mut Graph, vector: Components| {
            if is_negative {
                graph.negate_vector(vector)
            } else {
                vector
            }
        };
        let vector = signed(graph, vector);
        let mut known = self.known[link].iter();
        let found = if let Some([_, found]) = known.find(|[own, _]| *own == vector) {
            *found
        } else {
            let found = self.placed[link].to_frame(graph, vector);
            self.known[link].push([vector, found]);
            found
        };
        signed(graph, found)
    }

    /// Names of all known vectors: the force on each link, and arms.
    pub fn name(&self, (graph, labels): (&mut Graph, &mut Labels), tree: &Tree) {
        for (link, known) in tree.links.iter().zip(&self.known) {
            let opposite = graph.negate_vector(link.force);
            for &[own, found] in known {
                if own == link.force {
                    labels.vector(&format!("force_{}", link.name), found);
                } else if own == opposite {
                    let force = graph.negate_vector(found);
                    labels.vector(&format!("force_{}", link.name), force);
                } else {
                    labels.vector(&format!("arm_{}", link.name), found);
                }
            }
        }
    }

    /// The angular velocity of a link.
    pub fn turning_rate(&self, link: usize) -> Id {
        self.placed[link].w[2]
    }

    /// A vector of a link, written with the link's first arm that is known early. If that arm may
    /// be zero for some parameters, the vector is its own arm instead.
    pub fn by_arm(&mut self, graph: &mut Graph, link: usize, vector: Components) -> ByArm {
        let mut known = self.known[link].iter();
        if let Some([own, arm]) = known.find(|[own, _]| graph.are_early(own)).copied()
            && graph.are_early(&vector)
        {
            let square = graph.norm_squared(own);
            let products = [graph.dot(own, vector), graph.cross(own, vector)[2]];
            let [along, across] = products.map(|product| graph.divide(product, square));
            let is_number = |one: &Id| graph.as_number(*one).is_some();
            if is_number(&square) || [along, across].iter().all(is_number) {
                return ByArm { arm, along, across };
            }
        }
        ByArm {
            arm: self.world(graph, link, vector),
            along: graph.one(),
            across: graph.zero(),
        }
    }
}

impl ByArm {
    /// `s . v`
    pub fn dot(&self, graph: &mut Graph, v: Components) -> Id {
        let (along, across) = self.products(graph, v);
        let (a, b) = (
            graph.multiply(self.along, along),
            graph.multiply(self.across, across),
        );
        graph.add(a, b)
    }

    /// `z . (s x v)`, which is `(z x s) . v`.
    pub fn cross(&self, graph: &mut Graph, v: Components) -> Id {
        let (along, across) = self.products(graph, v);
        let (a, b) = (
            graph.multiply(self.along, across),
            graph.multiply(self.across, along),
        );
        graph.subtract(a, b)
    }

    fn products(&self, graph: &mut Graph, v: Components) -> (Id, Id) {
        (graph.dot(self.arm, v), graph.cross(self.arm, v)[2])
    }
}
