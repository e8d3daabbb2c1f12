//! A system, understood: bodies, and the joints that carry them.

mod joint_kind;

pub use joint_kind::{Axes, Holds, JointKind, Part};

use proc_macro2::Ident;

use crate::symbolic::{Components, Id};

use super::body::{Constraint, Defaults, Form, Inertia, Load, Potentials};
use super::joints::Rates;
use super::kinematics::{Own, State};
use super::words::{Checks, Frame, Variable};

/// A description of a system, understood.
pub struct System {
    pub is_planar: bool,
    pub bodies: Vec<Member>,
    /// Each carrier before what it carries; the joint of a body has the number of the body.
    pub joints: Vec<TreeJoint>,
    /// The joints that close loops.
    pub closings: Vec<Closing>,
    /// The joints that move, by number, in the order in which the state has them.
    pub written: Vec<usize>,
    /// Points whose Jacobians are asked for: the body, and where on it, from its G, in its axes.
    pub points: Vec<(usize, Components)>,
    /// The acceleration of free fall in the field that acts on all mass alike, world axes.
    pub gravity: Components,
    pub cables: Vec<Tie>,
    /// Links without mass, which written constraints keep.
    pub links: Vec<Tie>,
    /// What links and cables are made with.
    pub properties: Vec<Property>,
    /// States of its own.
    pub states: Vec<Own>,
    pub constraints: Kept,
    pub potentials: Potentials,
    /// Energies besides those of uniform fields: of cables, and of potentials once these are loads.
    pub energies: Vec<Id>,
    /// How many derivatives of each input are given.
    pub derivatives: Vec<usize>,
    pub defaults: Defaults,
    pub checks: Checks,
}

/// A body of a system.
pub struct Member {
    pub name: Ident,
    pub state: State,
    pub mass: Id,
    pub inertia: Inertia,
    /// All but gravity.
    pub loads: Vec<Load>,
    /// The fields that make up gravity.
    pub weights: Vec<Load>,
}

/// A joint between bodies that others carry already: it closes a loop.
pub struct Closing {
    pub name: Ident,
    pub kind: &'static JointKind,
    /// The body, or the ground, that would carry.
    pub carrier: Option<usize>,
    pub carried: usize,
    /// Where it is on the carrier, and on the carried body, from G, in its axes; of the ground, in those
    /// of the world.
    pub place: Components,
    pub pin: Components,
    /// Unit vectors, in the axes of the carried body; behind the one axis of a joint in space two that
    /// are across it.
    pub directions: Vec<Components>,
    /// Of a screw, metres per radian.
    pub pitch: Option<Id>,
    /// How the carried body is turned where the coordinates are zero: axes and angles, the first one
    /// from the carrier's axes.
    pub turned: Vec<(Components, Id)>,
}

/// What the motion of a system keeps at zero.
#[derive(Default)]
pub struct Kept {
    pub list: Vec<Constraint>,
    /// The symbols of the loads that keep them: given loads may follow these.
    pub loads: Vec<Id>,
    /// The same scalars as functions of each body by itself, if there are any.
    pub form: Option<Form>,
}

/// What is between two points and has no mass.
pub struct Tie {
    pub name: Ident,
    /// At its ends; none: the ground.
    pub bodies: [Option<Ident>; 2],
}

/// A number that a link or a cable is made with: finite and not negative.
#[derive(Clone)]
pub struct Property {
    /// Of what.
    pub of: Ident,
    pub word: &'static str,
    pub value: Id,
    pub may_vanish: bool,
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
    /// Unit vectors, in the axes of the carried body where the coordinates are zero; what parts of the
    /// kind go by.
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
    /// The given load along each freedom, the sum of all drives.
    pub drives: Vec<Id>,
    /// The given drives, by name.
    pub driven_by: Vec<(Ident, Vec<Id>)>,
    /// An inertia along its one coordinate, beside that of what it carries.
    pub armature: Option<Id>,
    /// The acceleration along each freedom, if its motion is prescribed.
    pub given: Vec<Option<Id>>,
    /// The unknown load along a freedom, by its name, if there is one.
    pub open: Vec<Option<Ident>>,
}

impl TreeJoint {
    /// The rate of the coordinate, if it has one alone.
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

    /// Its accelerations, by its freedoms.
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
    /// Nothing but the joints of its tree holds it.
    pub fn is_tree(&self) -> bool {
        self.closings.is_empty() && self.constraints.list.is_empty()
    }

    /// A constraint is what a link without mass keeps.
    pub fn is_link(&self, constraint: &Ident) -> bool {
        self.links.iter().any(|link| link.name == *constraint)
    }
}
