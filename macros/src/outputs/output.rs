//! The interface of an output.

use crate::emit::code::Site;
use crate::emit::items::Addition;
use crate::errors::Errors;
use crate::lower::Offer;
use crate::mechanics::Report;
use crate::model::{Outline, Workspace};
use crate::symbolic::Id;

use super::subject::Subject;

/// A part of the generated code of a body or a system, from derivation to documentation. It begins
/// empty; for an invalid description it stays so.
pub trait Output<S: Subject> {
    /// How it is requested; `None` for outputs that every body has.
    fn offer(&self) -> Option<&'static Offer> {
        None
    }

    /// Its place in a body; `None` if the body does not have it.
    fn place(&self, outline: &Outline) -> Option<Place> {
        outline.rank(self.offer()?.word).map(Place::Asked)
    }

    /// Derives its expressions. `None` means that there is no body; the errors say why.
    fn derive(&mut self, basis: &mut Basis<'_, S>) -> Option<()>;

    /// The expressions that code is generated for.
    fn roots(&self) -> Vec<Id> {
        Vec::new()
    }

    /// The entries of a tensor whose principal axes a body of doubles stores.
    fn tensor(&self) -> Option<[Id; 6]> {
        None
    }

    /// Adds what it reports, and the terms that it leaves out.
    fn describe(&self, _model: &S, _work: &Workspace, _report: &mut Report) {}

    /// Implements its trait.
    fn emit(&self, site: &Site<'_>) -> Addition;
}

/// A subject with a list of outputs.
pub trait Listed: Subject {
    /// The outputs, in the order of derivation.
    fn outputs() -> Vec<Box<dyn Output<Self>>>;

    /// The outputs, in the order in which they are offered.
    fn offered() -> Vec<Box<dyn Output<Self>>>;
}

/// The order in which traits are implemented.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Place {
    First,
    /// In the order in which outputs are requested.
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
