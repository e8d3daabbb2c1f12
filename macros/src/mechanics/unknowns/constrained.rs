//! A constraint with its derivatives.

use proc_macro2::Ident;

use crate::mechanics::variation::{Rates, rates};
use crate::model::{Level, Model, Workspace};
use crate::symbolic::Id;

/// A constraint with its derivatives.
pub struct Constrained {
    pub name: String,
    pub place: Ident,
    /// `g`; a constraint of velocities has none.
    pub position: Option<Id>,
    /// `h`
    pub velocity: Id,
    /// `b`, and `A` by its linear and its angular part.
    pub rates: Rates,
}

/// Each constraint with what it says of velocities and accelerations.
pub fn differentiate(model: &Model, work: &mut Workspace) -> Vec<Constrained> {
    let written: Vec<_> = model
        .constraints
        .iter()
        .map(|constraint| {
            (
                constraint.name.clone(),
                constraint.place.clone(),
                constraint.level,
                constraint.value,
            )
        })
        .collect();
    let constraints = written.into_iter().map(|(name, place, level, value)| {
        let (position, velocity) = match level {
            Level::Position => (Some(value), rates(model, work, value).rate),
            Level::Velocity => (None, value),
        };
        Constrained {
            name,
            place,
            position,
            velocity,
            rates: rates(model, work, velocity),
        }
    });
    constraints.collect()
}
