//! What the parts of a body make together.

use crate::symbolic::{Components, Graph, Id};

use super::inertia::Inertia;

/// What the parts of a body make together.
#[derive(Clone, Copy, Debug)]
pub struct Composed {
    pub mass: Id,
    /// About G.
    pub inertia: Inertia,
    pub origin: Origin,
}

/// How the points of a body are written.
#[derive(Clone, Copy, Debug)]
pub enum Drawn {
    /// From its G.
    Alone,
    /// From elsewhere.
    From(Origin),
    /// From elsewhere, and where that is was reported.
    Lost,
}

impl Drawn {
    pub fn origin(self) -> Option<Origin> {
        match self {
            Self::From(origin) => Some(origin),
            Self::Alone | Self::Lost => None,
        }
    }
}

/// Where G of a body is that is drawn from somewhere else.
#[derive(Clone, Copy, Debug)]
pub struct Origin {
    /// Of parts, where the first one is, from the drawing origin.
    pub first: Components,
    /// G, from there.
    pub center: Components,
}

impl Origin {
    /// The offset from G of what was written from the drawing origin.
    pub fn offset(&self, graph: &mut Graph, point: Components) -> Components {
        let from_first = graph.subtract_vectors(point, self.first);
        graph.subtract_vectors(from_first, self.center)
    }
}
