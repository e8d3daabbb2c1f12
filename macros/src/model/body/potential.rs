//! Potentials, in all forms in which they were read.

use proc_macro2::Ident;

use crate::model::kinematics::Turn;
use crate::symbolic::{Components, Id};

/// What becomes a load by differentiation.
pub struct Potentials {
    pub list: Vec<Potential>,
    /// The same energies, in one form or more.
    pub forms: Vec<Form>,
}

/// A scalar potential, or a uniform field on charges.
pub struct Potential {
    pub name: Ident,
    /// Its place among the given loads.
    pub place: usize,
    /// Those that a uniform field acts on.
    pub charges: Option<Charges>,
}

/// The energies of all potentials as functions of where the body is, and of turned vectors.
pub struct Form {
    pub energies: Vec<Id>,
    /// Those of the first energies.
    pub charges: Vec<Charges>,
    pub turns: Vec<Turn>,
    /// The symbols of a displacement of the body: the position of G, or what is added to it where
    /// it is no coordinate.
    pub displacement: Components,
}

/// What a uniform field sees of charges: `sum e` and `p = sum e r` in body axes, about G.
#[derive(Clone, Copy)]
pub struct Charges {
    /// How many they are.
    pub count: usize,
    pub net: Id,
    pub dipole: Components,
}
