//! One scalar that is kept at zero.

use crate::symbolic::Id;

/// A constraint, as the equations see it.
pub struct Row {
    pub name: String,
    /// Zero in all states of the motion; what is written of velocities has none.
    pub value: Option<Id>,
    pub rate: Id,
    /// The derivative of the rate, if no joint accelerates.
    pub bias: Id,
    /// By the rates of the open freedoms, in the order of the links.
    pub slopes: Vec<Id>,
    /// Where it says something, if that is not everywhere.
    pub active: Option<Id>,
}
