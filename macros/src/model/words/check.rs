//! Checks: claims about a body or a system, each made for one state.

use proc_macro2::Ident;

use crate::errors::Extent;
use crate::symbolic::{Comparison, Components, Id};

/// The claims of a description.
#[derive(Clone, Default)]
pub struct Checks {
    /// Those that can be decided.
    pub list: Vec<Check>,
    /// The number of errors in the others, which hide no other error.
    pub mistakes: usize,
    /// The symbols of quantities that are derived later, if there are checks.
    pub answers: Option<Answers>,
    /// For a system: the names of joints, with the symbols of their force and moment.
    pub held: Vec<(Ident, [Components; 2])>,
}

/// Symbols of quantities of the motion.
#[derive(Clone, Copy)]
pub struct Answers {
    pub kinetic: Id,
    pub potential: Id,
    pub linear_momentum: Components,
    pub angular_momentum: Components,
}

/// One check: the claims made for one state.
#[derive(Clone)]
pub struct Check {
    pub name: Ident,
    pub claims: Vec<Claim>,
    /// Symbols, each with its value in this state.
    pub given: Vec<(Id, Id, Extent)>,
}

/// A comparison; `a > b` is `b < a`.
#[derive(Clone)]
pub struct Claim {
    pub comparison: Comparison,
    pub sides: [Id; 2],
    /// Whether the first side was written on the right.
    pub is_turned: bool,
    pub place: Extent,
}
