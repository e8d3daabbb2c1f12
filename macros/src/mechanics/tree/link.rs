//! What a tree is made of.

use crate::symbolic::{Components, Graph, Id};

use super::pair::Pair;
use super::properties::Properties;
use super::turning::Turning;

/// Bodies, each carried by one before it or by the ground.
#[derive(Clone, PartialEq)]
pub struct Tree {
    pub links: Vec<Link>,
    /// The acceleration of free fall, world axes, in the one uniform field that acts on all mass.
    pub gravity: Components,
}

/// A body, and the joint that carries it. Joints of several axes have links without mass between.
#[derive(Clone, PartialEq)]
pub struct Link {
    /// For the names of what is computed for it.
    pub name: String,
    /// None: the ground.
    pub carrier: Option<usize>,
    /// From the origin of the carrier to that of the link, in the carrier's axes.
    pub place: Components,
    /// From its axes to those of the carrier.
    pub turning: Turning,
    /// Of a hinge that is turned about one of its axes.
    pub angle: Option<Id>,
    pub freedoms: Vec<Freedom>,
    /// Its origin may go anywhere: its accelerations are found as they are, without the carrier's.
    pub is_free: bool,
    pub properties: Properties,
    /// Of the loads on it but gravity, about its origin, in its axes.
    pub force: Components,
    pub moment: Components,
}

/// A way in which a joint lets its link move.
#[derive(Clone, PartialEq)]
pub struct Freedom {
    /// The motion of unit rate, in the axes of the link, about its origin.
    pub twist: Pair,
    /// The rate of its coordinate.
    pub rate: Id,
    /// The inertia along it alone, as a rotor behind gears has it: it takes a load of its own to accelerate,
    /// and nothing else.
    pub armature: Id,
    /// The load along it, which acts on the link, and on the carrier with the opposite sign.
    pub drive: Id,
    /// Its acceleration, if it moves as is prescribed.
    pub given: Option<Id>,
    pub name: String,
}

impl Tree {
    /// Whether a link is this one, or is carried by it.
    pub fn is_above(&self, mut link: usize, below: usize) -> bool {
        while link != below {
            let Some(carrier) = self.links[link].carrier else {
                return false;
            };
            link = carrier;
        }
        true
    }

    /// Whether a link is held by its carrier, and has and carries nothing.
    pub fn is_idle(&self, graph: &Graph, index: usize) -> bool {
        let link = &self.links[index];
        let is_zero = |vector: &Components| graph.is_zero_vector(vector);
        let loads = [link.force, link.moment, link.properties.first];
        let is_bare = graph.is_zero(link.properties.mass)
            && loads.iter().chain(&link.properties.inertia).all(is_zero);
        let mut above =
            (0..self.links.len()).filter(|other| self.links[*other].carrier == Some(index));
        link.freedoms.is_empty() && is_bare && above.all(|other| self.is_idle(graph, other))
    }
}

impl Link {
    /// The freedoms that accelerate as they are driven.
    pub fn open(&self) -> impl Iterator<Item = &Freedom> + Clone {
        self.freedoms.iter().filter(|one| one.given.is_none())
    }

    /// The loads on it but gravity.
    pub fn load(&self) -> Pair {
        Pair {
            angular: self.moment,
            linear: self.force,
        }
    }
}
