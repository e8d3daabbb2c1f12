//! Potentials, in all forms in which they were read.

use proc_macro2::Ident;

use crate::model::kinematics::Turn;
use crate::model::words::Frame;
use crate::symbolic::{Components, Id};

/// Potentials and fields that become loads by differentiation.
#[derive(Clone, Default)]
pub struct Potentials {
    pub list: Vec<Potential>,
    /// The same energies, in one or more forms.
    pub forms: Vec<Form>,
}

/// A scalar potential, or a uniform field on charges.
#[derive(Clone)]
pub struct Potential {
    pub name: Ident,
    /// Its index among the given loads.
    pub place: usize,
    /// The charges on which a uniform field acts.
    pub charges: Option<Charges>,
}

/// Scalars as functions of the places and motions of bodies, of rotated vectors, and of coordinates
/// of joints.
#[derive(Clone)]
pub struct Form {
    /// The energies of potentials, or the values of constraints.
    pub values: Vec<Id>,
    /// The charges that belong to the first values.
    pub charges: Vec<Charges>,
    pub turns: Vec<Turn>,
    pub bodies: Vec<Displaced>,
    /// The coordinates of joints, for a system.
    pub along: Vec<Along>,
    /// Symbols that were kept apart, other than rotated vectors, each with its expression.
    pub stands_for: Vec<(Id, Id)>,
}

/// A body that is displaced separately.
#[derive(Clone)]
pub struct Displaced {
    pub body: Frame,
    /// The symbols of a displacement: the position of G or, where that is no coordinate, an
    /// increment of it. For a body under a joint, they displace the point that the joint holds.
    pub displacement: Components,
    /// The symbols of the velocity of the same point, in world axes, and of the angular velocity,
    /// in body axes; zero where nothing depends on them.
    pub velocity: Components,
    pub angular_velocity: Components,
    /// In a planar system, the symbol of its angle.
    pub angle: Option<Id>,
    /// Whether the symbols of its attitude rotate this body only.
    pub has_own_attitude: bool,
}

impl Displaced {
    /// The symbols of its velocities, or zeros.
    pub fn rates(&self) -> impl Iterator<Item = Id> {
        self.velocity.into_iter().chain(self.angular_velocity)
    }
}

/// A coordinate of a joint, with the symbols of the coordinate and of its rate.
#[derive(Clone)]
pub struct Along {
    /// The index of the joint, and that of the coordinate among those of the joint.
    pub joint: usize,
    pub freedom: usize,
    /// `None` if there is only a rate, as for a ball joint.
    pub place: Option<Id>,
    pub rate: Id,
}

/// The charges in a uniform field: `sum e`, and `p = sum e r` about G in body axes.
#[derive(Clone, Copy)]
pub struct Charges {
    /// Their number.
    pub count: usize,
    pub net: Id,
    pub dipole: Components,
}
