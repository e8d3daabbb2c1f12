//! What is known of a body once its parts are composed.

use crate::symbolic::{Components, Graph, Id};

use super::inertia::Inertia;

/// What is known of a body once its parts are composed.
#[derive(Clone, Copy, Debug)]
pub struct Composed {
    pub mass: Id,
    /// About G.
    pub inertia: Inertia,
    pub has_holes: bool,
    pub origin: Origin,
}

/// The origin from which the points of a body are written.
#[derive(Clone, Copy, Debug)]
pub enum Drawn {
    /// The body's G.
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

/// The place of G of a body that is drawn from another origin.
#[derive(Clone, Copy, Debug)]
pub struct Origin {
    /// A place in the drawing from which offsets are measured: for a composed body, that of its
    /// first part.
    pub first: Components,
    /// G, measured from that place.
    pub center: Components,
}

impl Origin {
    /// The offset from G of a point that is written from the drawing origin.
    pub fn offset(&self, graph: &mut Graph, point: Components) -> Components {
        let from_first = graph.subtract_vectors(point, self.first);
        graph.subtract_vectors(from_first, self.center)
    }
}
