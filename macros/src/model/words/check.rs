//! Checks: what is claimed of a body or a system, and in which state.

use proc_macro2::Ident;

use crate::errors::Extent;
use crate::symbolic::{Comparison, Components, Id};

/// What a description claims.
#[derive(Clone, Default)]
pub struct Checks {
    pub list: Vec<Check>,
    /// The symbols of what is derived later, where there are checks.
    pub answers: Option<Answers>,
    /// Of a system: the symbols of what joints carry, force and moment, by name.
    pub held: Vec<(Ident, [Components; 2])>,
}

/// Symbols of what the motion answers.
#[derive(Clone, Copy)]
pub struct Answers {
    pub kinetic: Id,
    pub potential: Id,
    pub linear_momentum: Components,
    pub angular_momentum: Components,
}

/// One check: all that it claims, in one state.
#[derive(Clone)]
pub struct Check {
    pub name: Ident,
    pub claims: Vec<Claim>,
    /// Symbols, and what they are in this state.
    pub given: Vec<(Id, Id, Extent)>,
}

/// A comparison; `a > b` is `b < a`.
#[derive(Clone)]
pub struct Claim {
    pub comparison: Comparison,
    pub sides: [Id; 2],
    /// Whether the first side stands on the right.
    pub is_turned: bool,
    pub place: Extent,
}
