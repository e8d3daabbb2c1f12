//! The meaning of a system: bodies, and the joints that carry them.

mod joint_kind;

pub use joint_kind::{Axes, Holds, JointKind, Part};

use core::ops::Deref;

use proc_macro2::Ident;

use crate::errors::Extent;
use crate::symbolic::{Components, Id};

use super::body::{Constraint, Defaults, Form, Inertia, Load, Potentials, Shared, Substance};
use super::joints::Rates;
use super::kinematics::{Own, State};
use super::words::{Checks, Frame, Variable};

/// The meaning of a description of a system.
pub struct System {
    pub is_planar: bool,
    pub bodies: Vec<Member>,
    /// The joints of the tree. Each carrier precedes what it carries, and the joint of a body has
    /// the index of the body.
    pub joints: Vec<TreeJoint>,
    /// The joints that close loops.
    pub closings: Vec<Connection>,
    /// The indices of the moving joints, in the order of the state.
    pub written: Vec<usize>,
    /// The points whose Jacobians are requested: the body of each, and the offset from its G in its
    /// axes.
    pub points: Vec<(usize, Components)>,
    /// The acceleration of free fall in the fields that accelerate all bodies equally, in world
    /// axes.
    pub gravity: Components,
    /// The same bodies with unknown masses, if a regressor is requested.
    pub unweighed: Option<Shared>,
    pub cables: Vec<Tie>,
    /// Massless links, which are also written constraints.
    pub links: Vec<Tie>,
    /// The properties of links and cables, and the inertia of bodies with added mass.
    pub properties: Vec<Property>,
    /// User-defined states.
    pub states: Vec<Own>,
    pub constraints: Constraints,
    pub potentials: Potentials,
    /// Energies other than those of uniform fields: those of cables, and those of potentials once
    /// these have become loads.
    pub energies: Vec<Id>,
    /// The number of given derivatives of each input.
    pub derivatives: Vec<usize>,
    /// Whether its equations have to be differentiated, or compared with those of a closed form.
    pub is_differentiated: bool,
    pub defaults: Defaults,
    pub checks: Checks,
}

/// A body of a system.
pub struct Member {
    pub name: Ident,
    pub state: State,
    pub mass: Id,
    pub inertia: Inertia,
    /// All loads except gravity.
    pub loads: Vec<Load>,
    /// The fields that constitute gravity.
    pub weights: Vec<Load>,
    /// The loads that depend on the acceleration of the body itself, as functions of it.
    pub felt: Option<Felt>,
}

/// Loads of a body as functions of symbols for its own acceleration.
pub struct Felt {
    /// The angular acceleration and the acceleration of G, in body axes.
    pub acceleration: [Components; 2],
    pub loads: Vec<Load>,
}

impl Member {
    pub fn substance(&self) -> Substance {
        Substance {
            name: Some(self.name.to_string()),
            mass: Some(self.mass),
            inertia: self.inertia,
            swings: self.state.swings,
        }
    }
}

/// How a joint connects two bodies, or a body and the ground: its two sides, and its directions.
pub struct Connection {
    pub name: Ident,
    /// Where its name is written, in the description or in a file.
    pub written: Extent,
    pub kind: &'static JointKind,
    /// The carrier; `None` for the ground.
    pub carrier: Option<usize>,
    /// The carried body; if the joint closes a loop, the body on that side.
    pub carried: usize,
    /// Its point on the carrier, measured from the G of the carrier in its axes; on the ground, in
    /// world axes.
    pub place: Components,
    /// Its point on the carried body, measured from the body's G in its axes.
    pub pin: Components,
    /// The unit vectors that the parts of the kind refer to, in the axes of the carried body at
    /// zero coordinates. If the joint closes a loop and has a single axis in space, two vectors
    /// perpendicular to it follow.
    pub directions: Vec<Components>,
    /// For a screw: meters per radian.
    pub pitch: Option<Id>,
    /// The attitude of the carried body at zero coordinates, as rotations in sequence. Each is
    /// about an axis of the frame that the preceding ones have rotated; the first is about an axis
    /// of the carrier.
    pub turned: Vec<(Components, Id)>,
}

/// The constraints of the motion of a system.
#[derive(Default)]
pub struct Constraints {
    pub list: Vec<Constraint>,
    /// The symbols of their loads. Given loads may depend on these.
    pub loads: Vec<Id>,
    /// The same scalars as functions of separately displaced bodies, if there are any.
    pub form: Option<Form>,
}

/// A massless connection between two points.
pub struct Tie {
    pub name: Ident,
    /// The bodies at its ends; `None` for the ground.
    pub bodies: [Option<Ident>; 2],
}

/// A property that is finite and not negative: of a link or a cable, the armature of a joint, or the
/// inertia of a body with added mass.
#[derive(Clone)]
pub struct Property {
    /// What it belongs to.
    pub of: Ident,
    pub word: &'static str,
    pub value: Id,
    pub may_vanish: bool,
}

/// A joint that carries a body, on an earlier body or on the ground.
pub struct TreeJoint {
    pub connection: Connection,
    /// The frames after each of its parts; the last one is that of the carried body.
    pub frames: Vec<Frame>,
    /// Its coordinates, their rates and accelerations, in the order of its parts.
    pub coordinates: Rates,
    /// The given load along each coordinate: the sum of all given drives.
    pub drives: Vec<Id>,
    /// The given drives, by name.
    pub driven_by: Vec<(Ident, Vec<Id>)>,
    /// An inertia along its single coordinate, in addition to that of the carried body.
    pub armature: Option<Id>,
    /// For each coordinate, its acceleration, if its motion is prescribed.
    pub given: Vec<Option<Id>>,
    /// For each coordinate, the name of the unknown load along it, if there is one.
    pub open: Vec<Option<Ident>>,
}

impl Deref for TreeJoint {
    type Target = Connection;

    fn deref(&self) -> &Connection {
        &self.connection
    }
}

impl TreeJoint {
    /// The rate of its coordinate, if it has only one.
    pub fn rate(&self) -> Option<Id> {
        let rates = [Variable::Velocity, Variable::AngularVelocity];
        rates
            .iter()
            .find_map(|variable| self.coordinates.get(*variable, 0))
    }

    /// Whether its coordinates are positions and attitudes in the world.
    pub fn is_in_world(&self) -> bool {
        let is_alone = self.kind.holds == Holds::Center;
        let is_ball = self.kind.parts == [Part::Ball] && self.turned.is_empty();
        self.carrier.is_none() && (is_alone || is_ball)
    }

    /// Its accelerations, in the order of its coordinates.
    pub fn accelerations(&self) -> Vec<Id> {
        let second = self.kind.shape.into_iter().flat_map(|shape| shape.second);
        let parts = second.flat_map(|field| {
            (0..field.names.len()).map(|part| (field.variable, field.first + part))
        });
        parts
            .filter_map(|(variable, part)| self.coordinates.get(variable, part))
            .collect()
    }

    /// Whether its motion is prescribed.
    pub fn is_driven(&self) -> bool {
        self.given.iter().any(Option::is_some)
    }
}

impl System {
    /// All joints: first those of its tree, then those that close loops.
    pub fn connections(&self) -> impl Iterator<Item = &Connection> {
        let tree = self.joints.iter().map(|joint| &joint.connection);
        tree.chain(&self.closings)
    }

    /// Whether only the joints of its tree hold it.
    pub fn is_tree(&self) -> bool {
        self.closings.is_empty() && self.constraints.list.is_empty()
    }

    /// The joint to the ground that carries a body, directly or indirectly.
    pub fn root(&self, mut body: usize) -> usize {
        while let Some(carrier) = self.joints[body].carrier {
            body = carrier;
        }
        body
    }

    /// Whether a constraint is that of a massless link.
    pub fn is_link(&self, constraint: &Ident) -> bool {
        self.links.iter().any(|link| link.name == *constraint)
    }
}
