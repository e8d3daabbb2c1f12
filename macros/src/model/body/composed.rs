//! The result of composing the parts of a body.

use crate::symbolic::{Components, Graph, Id};

use super::inertia::Inertia;

/// The result of composing the parts of a body.
#[derive(Clone, Copy, Debug)]
pub struct Composed {
    pub mass: Id,
    /// About G.
    pub inertia: Inertia,
    pub origin: Origin,
}

/// The origin of the points of a body.
#[derive(Clone, Copy, Debug)]
pub enum Drawn {
    /// Its G.
    Alone,
    /// Another origin.
    From(Origin),
    /// Another origin, whose place is unknown because of a reported error.
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

/// The place of G of a body drawn from another origin.
#[derive(Clone, Copy, Debug)]
pub struct Origin {
    /// For parts, the place of the first one, from the drawing origin.
    pub first: Components,
    /// G, from there.
    pub center: Components,
}

impl Origin {
    /// The offset from G of a point written from the drawing origin.
    pub fn offset(&self, graph: &mut Graph, point: Components) -> Components {
        let from_first = graph.subtract_vectors(point, self.first);
        graph.subtract_vectors(from_first, self.center)
    }
}
