//! Potentials, in all forms in which they were read.

use proc_macro2::Ident;

use crate::model::kinematics::Turn;
use crate::model::words::Frame;
use crate::symbolic::{Components, Id};

/// What becomes a load by differentiation.
#[derive(Clone)]
pub struct Potentials {
    pub list: Vec<Potential>,
    /// The same energies, in one form or more.
    pub forms: Vec<Form>,
}

/// A scalar potential, or a uniform field on charges.
#[derive(Clone)]
pub struct Potential {
    pub name: Ident,
    /// Its place among the given loads.
    pub place: usize,
    /// Those that a uniform field acts on.
    pub charges: Option<Charges>,
}

/// Scalars as functions of where bodies are and how they move, of turned vectors, and of coordinates
/// of joints.
#[derive(Clone)]
pub struct Form {
    /// The energies of potentials, or what constraints keep at zero.
    pub values: Vec<Id>,
    /// Those of the first values.
    pub charges: Vec<Charges>,
    pub turns: Vec<Turn>,
    pub bodies: Vec<Displaced>,
    /// The freedoms of joints, of a system.
    pub along: Vec<Along>,
    /// What symbols stand for that were kept apart, besides turned vectors.
    pub stands_for: Vec<(Id, Id)>,
}

/// A body, moved by itself.
#[derive(Clone)]
pub struct Displaced {
    pub body: Frame,
    /// The symbols of a displacement: the position of G, or what is added to it where it is no
    /// coordinate. Under a joint it is that of the point that the joint holds.
    pub displacement: Components,
    /// Those of the velocity of the same point, world axes, and of the angular velocity, body axes; zero
    /// where nothing depends on them.
    pub velocity: Components,
    pub angular_velocity: Components,
    /// In the plane of a system, what its angle is told by.
    pub angle: Option<Id>,
    /// Whether the symbols of its attitude turn it alone.
    pub has_own_attitude: bool,
}

impl Displaced {
    /// The symbols, and zeros, of how it moves.
    pub fn rates(&self) -> impl Iterator<Item = Id> {
        self.velocity.into_iter().chain(self.angular_velocity)
    }
}

/// A freedom of a joint, by the symbols of its coordinate and of its rate.
#[derive(Clone)]
pub struct Along {
    /// The number of the joint, and of the freedom in it.
    pub joint: usize,
    pub freedom: usize,
    /// None: it has only a rate, as a ball joint has.
    pub place: Option<Id>,
    pub rate: Id,
}

/// What a uniform field sees of charges: `sum e` and `p = sum e r` in body axes, about G.
#[derive(Clone, Copy)]
pub struct Charges {
    /// How many they are.
    pub count: usize,
    pub net: Id,
    pub dipole: Components,
}
