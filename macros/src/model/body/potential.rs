//! Potentials, in all forms in which they were read.

use proc_macro2::Ident;

use crate::model::kinematics::Turn;
use crate::model::words::Frame;
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

/// The energies of all potentials as functions of where bodies are, of turned vectors, and of
/// coordinates of joints.
pub struct Form {
    pub energies: Vec<Id>,
    /// Those of the first energies.
    pub charges: Vec<Charges>,
    pub turns: Vec<Turn>,
    pub bodies: Vec<Displaced>,
    /// The coordinates of joints, of a system.
    pub coordinates: Vec<Id>,
    /// What symbols stand for that were kept apart, besides turned vectors.
    pub stands_for: Vec<(Id, Id)>,
}

/// A body that potentials act on, moved by itself.
pub struct Displaced {
    pub body: Frame,
    /// The symbols of a displacement: the position of G, or what is added to it where it is no
    /// coordinate. Under a joint it is that of the point that the joint holds.
    pub displacement: Components,
    /// In the plane of a system, what its angle is told by.
    pub angle: Option<Id>,
    /// Whether the symbols of its attitude turn it alone.
    pub has_own_attitude: bool,
}

/// What a uniform field sees of charges: `sum e` and `p = sum e r` in body axes, about G.
#[derive(Clone, Copy)]
pub struct Charges {
    /// How many they are.
    pub count: usize,
    pub net: Id,
    pub dipole: Components,
}
