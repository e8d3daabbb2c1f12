//! Mass and inertia of a body, for checks.

use crate::symbolic::{Components, Graph, Id};

use super::inertia::Inertia;

/// Mass and inertia of a body, as far as they are known.
pub struct Substance {
    /// The name, for a body of a system.
    pub name: Option<String>,
    pub mass: Option<Id>,
    pub inertia: Inertia,
    /// Whether its inertia may be that of a point mass or a rod.
    pub swings: bool,
}

impl Substance {
    /// The entries xx, yy, zz, xy, yz, zx of the inertia, or the single moment of a planar body.
    pub fn inertia_entries(&self) -> Vec<Id> {
        self.inertia.distinct_entries()
    }

    /// The inertia of a body that swings, about the point that holds it: the moment about the axis,
    /// if there is one. `None` for a body that does not swing: its inertia about G is enough.
    pub fn held(
        &self,
        graph: &mut Graph,
        point: Components,
        axis: Option<Components>,
    ) -> Option<Self> {
        let mass = self.mass.filter(|_| self.swings)?;
        let about_point = self.inertia.displaced(graph, mass, point);
        let inertia = match (about_point, axis) {
            (Inertia::Spatial(_), Some(axis)) => {
                let momentum = about_point.times(graph, axis);
                Inertia::Scalar(graph.dot(axis, momentum))
            }
            _ => about_point,
        };
        Some(Self {
            name: self.name.clone(),
            mass: None,
            inertia,
            swings: false,
        })
    }

    /// The entries of the inertia, and the mass.
    pub fn numbers(&self) -> Vec<Id> {
        let entries = self.inertia_entries().into_iter();
        entries.chain(self.mass).collect()
    }
}
