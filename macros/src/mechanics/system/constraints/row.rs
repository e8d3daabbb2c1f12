//! One scalar constraint.

use crate::symbolic::Id;

/// A constraint, as the equations see it.
pub struct ConstraintRow {
    pub name: String,
    /// Zero in all states of the motion; a velocity constraint has none.
    pub value: Option<Id>,
    pub rate: Id,
    /// The derivative of the rate, if no joint accelerates.
    pub bias: Id,
    /// By the rates of the open coordinates, in the order of the links.
    pub slopes: Vec<Id>,
    /// The branches on which it is not trivial, if not all.
    pub active: Option<Id>,
}
