//! The elements of a tree.

use crate::symbolic::{Components, Graph, Id};

use super::properties::Properties;
use super::spatial::{SpatialInertia, SpatialVector};
use super::turning::Turning;

/// Bodies, each carried by one before it or by the ground.
#[derive(Clone, PartialEq)]
pub struct Tree {
    pub links: Vec<Link>,
    /// The acceleration of free fall, in world axes, in the uniform field that acts on all mass.
    pub gravity: Components,
}

/// A body, and the joint that carries it. A joint with several axes has massless links in between.
#[derive(Clone, PartialEq)]
pub struct Link {
    /// The name that its quantities get.
    pub name: String,
    /// The carrier; `None` for the ground.
    pub carrier: Option<usize>,
    /// The vector from the origin of the carrier to that of the link, in the axes of the carrier.
    pub place: Components,
    /// The rotation from its axes to those of the carrier.
    pub turning: Turning,
    /// The angle of a hinge that rotates about one of the coordinate axes.
    pub angle: Option<Id>,
    pub freedoms: Vec<Freedom>,
    /// Whether it is free: its accelerations are absolute and do not depend on a carrier, so its
    /// origin is arbitrary.
    pub is_free: bool,
    /// For a free link, whether it is solved for relative to free fall. With inertia that has no
    /// weight, this would lose digits.
    pub falls: bool,
    pub properties: Properties,
    /// The inertia that loads add to it, about its origin, in its axes.
    pub added: SpatialInertia,
    /// The loads on it except gravity, about its origin, in its axes.
    pub force: Components,
    pub moment: Components,
}

/// A direction in which a joint lets its link move.
#[derive(Clone, PartialEq)]
pub struct Freedom {
    /// The motion at unit rate, about the origin of the link, in its axes.
    pub twist: SpatialVector,
    /// The rate of its coordinate.
    pub rate: Id,
    /// An inertia along the coordinate only, such as that of a geared rotor. It takes a separate
    /// load to accelerate, and has no other effect.
    pub armature: Id,
    /// The load along the coordinate, which acts on the link, and with the opposite sign on the
    /// carrier.
    pub drive: Id,
    /// Its acceleration, if its motion is prescribed.
    pub given: Option<Id>,
    /// The joint, or the joint and the direction if it has several.
    pub name: String,
    pub joint: String,
}

impl Tree {
    /// Groups items, one for each open freedom, by link.
    pub fn by_link<T>(&self, of_freedoms: impl IntoIterator<Item = T>) -> Vec<Vec<T>> {
        let mut rest = of_freedoms.into_iter();
        let links = self.links.iter();
        links
            .map(|link| rest.by_ref().take(link.open().count()).collect())
            .collect()
    }

    /// Replaces symbols in all loads.
    pub fn replace(&mut self, graph: &mut Graph, values: &[(Id, Id)]) {
        for link in &mut self.links {
            link.force = graph.replaced(link.force, values);
            link.moment = graph.replaced(link.moment, values);
            for freedom in &mut link.freedoms {
                [freedom.drive] = graph.replaced([freedom.drive], values);
            }
        }
    }

    /// Whether `link` is `below`, or `below` carries it.
    pub fn is_above(&self, mut link: usize, below: usize) -> bool {
        while link != below {
            let Some(carrier) = self.links[link].carrier else {
                return false;
            };
            link = carrier;
        }
        true
    }

    /// Whether a link is held rigidly by its carrier, and neither has nor carries mass.
    pub fn is_idle(&self, graph: &Graph, index: usize) -> bool {
        let link = &self.links[index];
        let is_zero = |vector: &Components| graph.is_zero_vector(vector);
        let loads = [link.force, link.moment, link.properties.first];
        let is_bare = graph.is_zero(link.properties.mass)
            && link.added.is_zero(graph)
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

    /// Whether it moves along one twist from the ground, which its joint leaves open.
    pub fn moves_along_one_twist(&self) -> bool {
        self.carrier.is_none() && self.freedoms.len() == 1 && self.open().count() == 1
    }

    /// The loads on it except gravity.
    pub fn load(&self) -> SpatialVector {
        SpatialVector {
            angular: self.moment,
            linear: self.force,
        }
    }
}
