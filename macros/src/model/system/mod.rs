//! The meaning of a system: bodies, and the joints that carry them.

mod joint_kind;

pub use joint_kind::{Axes, Holds, JointKind, Part};

use core::ops::Deref;

use proc_macro2::Ident;

use crate::symbolic::{Components, Id};

use super::body::{Constraint, Defaults, Form, Inertia, Load, Potentials, Substance};
use super::joints::Rates;
use super::kinematics::{Own, State};
use super::words::{Checks, Frame, Variable};

/// The meaning of a description of a system.
pub struct System {
    pub is_planar: bool,
    pub bodies: Vec<Member>,
    /// Each carrier precedes what it carries; the joint of a body has the index of the body.
    pub joints: Vec<TreeJoint>,
    /// The joints that close loops.
    pub closings: Vec<Connection>,
    /// The moving joints, by index, in the order of the state.
    pub written: Vec<usize>,
    /// Points whose Jacobians are requested: the body, and the offset from its G, in its axes.
    pub points: Vec<(usize, Components)>,
    /// The acceleration of free fall in the field that acts on all mass equally, world axes.
    pub gravity: Components,
    pub cables: Vec<Tie>,
    /// Massless links, which written constraints keep.
    pub links: Vec<Tie>,
    /// The properties of links and cables.
    pub properties: Vec<Property>,
    /// User-defined states.
    pub states: Vec<Own>,
    pub constraints: Constraints,
    pub potentials: Potentials,
    /// Energies other than those of uniform fields: of cables, and of potentials once these are
    /// loads.
    pub energies: Vec<Id>,
    /// The number of given derivatives of each input.
    pub derivatives: Vec<usize>,
    /// Its equations must be differentiated, or be proved to be those of a closed form.
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
    /// All except gravity.
    pub loads: Vec<Load>,
    /// The fields that constitute gravity.
    pub weights: Vec<Load>,
}

impl Member {
    pub fn substance(&self) -> Substance {
        Substance {
            name: Some(self.name.to_string()),
            mass: Some(self.mass),
            inertia: self.inertia,
        }
    }
}

/// A joint as it connects two bodies, or a body and the ground: its two sides, and its directions.
pub struct Connection {
    pub name: Ident,
    pub kind: &'static JointKind,
    /// The carrier; none for the ground.
    pub carrier: Option<usize>,
    /// The carried body; of a joint that closes a loop, the body on that side.
    pub carried: usize,
    /// Its point on the carrier: from its G, in its axes; on the ground in world axes.
    pub place: Components,
    /// Its point on the carried body, from its G, in its axes.
    pub pin: Components,
    /// Unit vectors, in the axes of the carried body at zero coordinates, to which the parts of the
    /// kind refer; where it closes a loop, two across the single axis of a joint in space follow.
    pub directions: Vec<Components>,
    /// For a screw, metres per radian.
    pub pitch: Option<Id>,
    /// The rotation of the carried body at zero coordinates: about axes in sequence,
    /// each in the axes rotated by those before, the first one in the carrier's axes.
    pub turned: Vec<(Components, Id)>,
}

/// The constraints of the motion of a system.
#[derive(Default)]
pub struct Constraints {
    pub list: Vec<Constraint>,
    /// The symbols of their loads: given loads may depend on these.
    pub loads: Vec<Id>,
    /// The same scalars as functions of each body separately, if there are any.
    pub form: Option<Form>,
}

/// A massless connection between two points.
pub struct Tie {
    pub name: Ident,
    /// The bodies at its ends; none for the ground.
    pub bodies: [Option<Ident>; 2],
}

/// A property of a link or a cable: finite and not negative.
#[derive(Clone)]
pub struct Property {
    /// Its owner.
    pub of: Ident,
    pub word: &'static str,
    pub value: Id,
    pub may_vanish: bool,
}

/// A joint between a body and one before it, or the ground: it carries the body.
pub struct TreeJoint {
    pub connection: Connection,
    /// The frames of its parts, the last one that of the carried body.
    pub frames: Vec<Frame>,
    /// Its coordinates, their rates and accelerations, in the order of its parts.
    pub coordinates: Rates,
    /// The given load along each coordinate, the sum of all drives.
    pub drives: Vec<Id>,
    /// The given drives, by name.
    pub driven_by: Vec<(Ident, Vec<Id>)>,
    /// An inertia along its single coordinate, in addition to that of the carried body.
    pub armature: Option<Id>,
    /// The acceleration along each coordinate, if its motion is prescribed.
    pub given: Vec<Option<Id>>,
    /// The unknown load along a coordinate, by its name, if there is one.
    pub open: Vec<Option<Ident>>,
}

impl Deref for TreeJoint {
    type Target = Connection;

    fn deref(&self) -> &Connection {
        &self.connection
    }
}

impl TreeJoint {
    /// The rate of the coordinate, if it has a single one.
    pub fn rate(&self) -> Option<Id> {
        let rates = [Variable::Velocity, Variable::AngularVelocity];
        rates
            .iter()
            .find_map(|variable| self.coordinates.get(*variable, 0))
    }

    /// Its coordinates are positions and attitudes in the world.
    pub fn is_in_world(&self) -> bool {
        let is_alone = self.kind.holds == Holds::Center;
        let is_ball = self.kind.parts == [Part::Ball] && self.turned.is_empty();
        self.carrier.is_none() && (is_alone || is_ball)
    }

    /// Its accelerations, by its coordinates.
    pub fn accelerations(&self) -> Vec<Id> {
        let second = self.kind.shape.into_iter().flat_map(|shape| shape.second);
        let parts = second.flat_map(|field| {
            (0..field.names.len()).map(|part| (field.variable, field.first + part))
        });
        parts
            .filter_map(|(variable, part)| self.coordinates.get(variable, part))
            .collect()
    }

    /// Its motion is prescribed.
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

    /// Only the joints of its tree hold it.
    pub fn is_tree(&self) -> bool {
        self.closings.is_empty() && self.constraints.list.is_empty()
    }

    /// The joint to the ground that carries a body.
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
