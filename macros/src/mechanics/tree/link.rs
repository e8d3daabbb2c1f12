//! The elements of a tree.

use crate::symbolic::{Components, Graph, Id};

use super::properties::Properties;
use super::spatial_vector::SpatialVector;
use super::turning::Turning;

/// Bodies, each carried by one before it or by the ground.
#[derive(Clone, PartialEq)]
pub struct Tree {
    pub links: Vec<Link>,
    /// The acceleration of free fall, world axes, in the one uniform field that acts on all mass.
    pub gravity: Components,
}

/// A body, and the joint that carries it. Joints of several axes have massless links between.
#[derive(Clone, PartialEq)]
pub struct Link {
    /// For the names of its quantities.
    pub name: String,
    /// None for the ground.
    pub carrier: Option<usize>,
    /// From the origin of the carrier to that of the link, in the carrier's axes.
    pub place: Components,
    /// From its axes to those of the carrier.
    pub turning: Turning,
    /// For a hinge that is rotated about one of its axes.
    pub angle: Option<Id>,
    pub freedoms: Vec<Freedom>,
    /// Its origin is arbitrary: its accelerations are absolute, independent of the carrier's.
    pub is_free: bool,
    pub properties: Properties,
    /// The loads on it except gravity, about its origin, in its axes.
    pub force: Components,
    pub moment: Components,
}

/// A direction in which a joint lets its link move.
#[derive(Clone, PartialEq)]
pub struct Freedom {
    /// The motion of unit rate, in the axes of the link, about its origin.
    pub twist: SpatialVector,
    /// The rate of its coordinate.
    pub rate: Id,
    /// The inertia along it alone, as of a geared rotor: it takes a separate load to accelerate,
    /// and has no other effect.
    pub armature: Id,
    /// The load along it, which acts on the link, and on the carrier with the opposite sign.
    pub drive: Id,
    /// Its acceleration, if its motion is prescribed.
    pub given: Option<Id>,
    pub name: String,
}

impl Tree {
    /// Items of open freedoms, link by link.
    pub fn by_link<T>(&self, of_freedoms: impl IntoIterator<Item = T>) -> Vec<Vec<T>> {
        let mut rest = of_freedoms.into_iter();
        let links = self.links.iter();
        links
            .map(|link| rest.by_ref().take(link.open().count()).collect())
            .collect()
    }

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

    /// Whether a link is held by its carrier, and has and carries no mass.
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
    /// The coordinates that accelerate freely.
    pub fn open(&self) -> impl Iterator<Item = &Freedom> + Clone {
        self.freedoms.iter().filter(|one| one.given.is_none())
    }

    /// The loads on it except gravity.
    pub fn load(&self) -> SpatialVector {
        SpatialVector {
            angular: self.moment,
            linear: self.force,
        }
    }
}
