//! What an output is.

use crate::emit::code::Site;
use crate::emit::items::Addition;
use crate::errors::Errors;
use crate::lower::Offer;
use crate::mechanics::Report;
use crate::model::{Outline, Workspace};
use crate::symbolic::Id;

use super::subject::Subject;

/// A part of what is generated for a body or a system, from what it derives to what its
/// documentation says. It begins empty; then it is what a description with mistakes gets.
pub trait Output<S: Subject> {
    /// How it is asked for; none of what a body has by itself.
    fn offer(&self) -> Option<&'static Offer> {
        None
    }

    /// Where it stands in a body; nowhere if the body does not have it.
    fn place(&self, outline: &Outline) -> Option<Place> {
        outline.rank(self.offer()?.word).map(Place::Asked)
    }

    /// Derives its expressions. `None` if there is no body, as the errors say.
    fn derive(&mut self, basis: &mut Basis<'_, S>) -> Option<()>;

    /// The expressions that code is generated for.
    fn roots(&self) -> Vec<Id> {
        Vec::new()
    }

    /// The entries of a tensor of which a body of doubles is to keep the principal axes.
    fn tensor(&self) -> Option<[Id; 6]> {
        None
    }

    /// What is told of it, and what it leaves out.
    fn describe(&self, _model: &S, _work: &Workspace, _report: &mut Report) {}

    /// Its trait, implemented.
    fn emit(&self, site: &Site<'_>) -> Addition;
}

/// What has a list of outputs.
pub trait Listed: Subject {
    /// In the order in which they are derived.
    fn outputs() -> Vec<Box<dyn Output<Self>>>;

    /// In the order in which they are offered.
    fn offered() -> Vec<Box<dyn Output<Self>>>;
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
pub struct Basis<'a, S: Subject> {
    pub outline: &'a Outline,
    pub model: &'a S,
    pub equations: &'a S::Equations,
    pub work: &'a mut Workspace,
    pub errors: &'a mut Errors,
}
