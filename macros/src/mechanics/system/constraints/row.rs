//! One scalar constraint.

use crate::symbolic::Id;

/// A constraint in the form that the equations need.
pub struct ConstraintRow {
    pub name: String,
    /// Zero in all states of the motion; `None` for a constraint of velocities.
    pub value: Option<Id>,
    pub rate: Id,
    /// The derivative of the rate if no joint accelerates.
    pub bias: Id,
    /// The slopes along the rates of the open coordinates, in the order of the links.
    pub slopes: Vec<Id>,
    /// The condition under which it is not trivial, if there are branches where it is.
    pub active: Option<Id>,
}
