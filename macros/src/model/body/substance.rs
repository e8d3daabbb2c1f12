//! What a body is made of, for what is checked of it.

use crate::symbolic::Id;

use super::inertia::Inertia;

/// Mass and inertia of a body, as far as they are known.
pub struct Substance {
    /// What a body of a system is called.
    pub name: Option<String>,
    pub mass: Option<Id>,
    pub inertia: Inertia,
}

impl Substance {
    /// The entries xx, yy, zz, xy, yz, zx of the inertia, or the one of a planar body.
    pub fn inertia_entries(&self) -> Vec<Id> {
        self.inertia.distinct_entries()
    }
}
