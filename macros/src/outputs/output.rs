//! What an output is.

use crate::emit::code::Site;
use crate::emit::items::Addition;
use crate::errors::Errors;
use crate::lower::Offer;
use crate::mechanics::{Equations, Report};
use crate::model::{Model, Outline, Workspace};
use crate::symbolic::Id;

/// A part of what is generated for a body, from what it derives to what its documentation says. It
/// begins empty; then it is what a description with mistakes gets.
pub trait Output {
    /// How it is asked for; none of what a body has by itself.
    fn offer(&self) -> Option<&'static Offer> {
        None
    }

    /// Where it stands in a body; nowhere if the body does not have it.
    fn place(&self, outline: &Outline) -> Option<Place> {
        outline.rank(self.offer()?.word).map(Place::Asked)
    }

    /// Derives its expressions. `None` if there is no body, as the errors say.
    fn derive(&mut self, basis: &mut Basis<'_>) -> Option<()>;

    /// The expressions that code is generated for.
    fn roots(&self) -> Vec<Id> {
        Vec::new()
    }

    /// The entries of a tensor of which a body of doubles is to keep the principal axes.
    fn tensor(&self) -> Option<[Id; 6]> {
        None
    }

    /// What is told of it, and what it leaves out.
    fn describe(&self, _model: &Model, _work: &Workspace, _report: &mut Report) {}

    /// Its trait, implemented.
    fn emit(&self, site: &Site<'_>) -> Addition;
}

/// The order in which traits are implemented.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Place {
    First,
    /// In which it is asked for.
    Asked(usize),
    Last,
}

/// What an output is derived from.
pub struct Basis<'a> {
    pub outline: &'a Outline,
    pub model: &'a Model,
    pub equations: &'a Equations,
    pub work: &'a mut Workspace,
    pub errors: &'a mut Errors,
}
