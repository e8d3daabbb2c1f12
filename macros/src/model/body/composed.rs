//! What the parts of a body make together.

use crate::symbolic::{Components, Graph, Id};

use super::inertia::Inertia;

/// What the parts of a body make together.
#[derive(Clone, Copy, Debug)]
pub struct Composed {
    pub mass: Id,
    /// About G.
    pub inertia: Inertia,
    /// Where the first part is, from the drawing origin.
    pub first: Components,
    /// G, from there.
    pub center: Components,
}

impl Composed {
    /// The offset from G of what was written from the drawing origin.
    pub fn offset(&self, graph: &mut Graph, point: Components) -> Components {
        let from_first = graph.subtract_vectors(point, self.first);
        graph.subtract_vectors(from_first, self.center)
    }
}
