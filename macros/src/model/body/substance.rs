//! Mass and inertia of a body, for checks.

use crate::symbolic::Id;

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

    /// The entries of the inertia, and the mass.
    pub fn numbers(&self) -> Vec<Id> {
        let entries = self.inertia_entries().into_iter();
        entries.chain(self.mass).collect()
    }
}
