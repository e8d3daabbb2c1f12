//! A part that rotates as one body.

use crate::mechanics::balances::inertia_about_center;
use crate::model::{Frame, Inertia, Model, Workspace};
use crate::symbolic::Components;

/// A part that rotates as one body in space.
#[derive(Clone, Copy)]
pub struct Solid {
    /// Its axes.
    pub body: Frame,
    /// Its inertia in its axes, about G or about the held point.
    pub rows: [Components; 3],
}

impl Solid {
    /// The part that is a single body, if it rotates in space.
    pub fn of(model: &Model, work: &mut Workspace) -> Option<Self> {
        let Inertia::Spatial(rows) = inertia_about_center(model, work) else {
            return None;
        };
        Some(Self {
            body: model.state.body,
            rows,
        })
    }
}
