//! A system, understood: bodies, and the joints that carry them.

mod joint_kind;

pub use joint_kind::{JointKind, Part};

use proc_macro2::Ident;

use crate::symbolic::{Components, Id};

use super::body::{Defaults, Inertia, Load, Substance};
use super::joints::Rates;
use super::kinematics::State;
use super::words::Frame;

/// A description of a system, understood.
pub struct System {
    pub is_planar: bool,
    pub bodies: Vec<Member>,
    /// Each carrier before what it carries; the joint of a body has the number of the body.
    pub joints: Vec<TreeJoint>,
    /// The acceleration of free fall in the field that acts on all mass alike, world axes.
    pub gravity: Components,
    /// How many derivatives of each input are given.
    pub derivatives: Vec<usize>,
    pub defaults: Defaults,
}

/// A body of a system.
pub struct Member {
    pub name: Ident,
    pub state: State,
    pub mass: Id,
    pub inertia: Inertia,
    /// All but gravity.
    pub loads: Vec<Load>,
}

/// A joint between a body and one before it, or the ground.
pub struct TreeJoint {
    pub name: Ident,
    pub kind: &'static JointKind,
    /// The body that carries it; none: the ground.
    pub carrier: Option<usize>,
    /// The body that it carries.
    pub carried: usize,
    /// Where it is on the carrier: from its G, in its axes; of the ground, in those of the world.
    pub place: Components,
    /// Where it is on the carried body, from its G, in its axes.
    pub pin: Components,
    /// Unit vectors, in the axes of the carried body where the coordinates are zero.
    pub directions: Vec<Components>,
    /// Of a screw, metres per radian.
    pub pitch: Option<Id>,
    /// How the carried body is turned where the coordinates are zero: about axes, one after the other,
    /// each in the axes that the ones before have made.
    pub turned: Vec<(Components, Id)>,
    /// The frames of its parts, the last one that of the carried body.
    pub frames: Vec<Frame>,
    /// Its coordinates, their rates and accelerations, in the order of the freedoms of its parts.
    pub coordinates: Rates,
    /// The given load along each freedom.
    pub drives: Vec<Id>,
    /// The unknown load along a freedom, by its name, if there is one.
    pub open: Vec<Option<Ident>>,
}

impl System {
    /// What the bodies are made of.
    pub fn substances(&self) -> Vec<Substance> {
        let bodies = self.bodies.iter().map(|body| Substance {
            mass: Some(body.mass),
            inertia: body.inertia,
        });
        bodies.collect()
    }
}
