//! What a body is made of, for what is checked of it.

use crate::symbolic::Id;

use super::inertia::{Inertia, entries};

/// Mass and inertia of a body, as far as they are known.
#[derive(Clone, Copy)]
pub struct Substance {
    pub mass: Option<Id>,
    pub inertia: Inertia,
}

impl Substance {
    /// The entries xx, yy, zz, xy, yz, zx of the inertia, or the one of a planar body.
    pub fn inertia_entries(&self) -> Vec<Id> {
        match self.inertia {
            Inertia::Absent => Vec::new(),
            Inertia::Scalar(moment) => vec![moment],
            Inertia::Spatial(rows) => entries(&rows).to_vec(),
        }
    }
}
