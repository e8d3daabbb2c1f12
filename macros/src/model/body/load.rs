//! Given loads.

use proc_macro2::Ident;

use crate::errors::Extent;
use crate::families::{Family, LoadKind};
use crate::model::kinematics::{Point, Vector, Workspace};
use crate::symbolic::{Components, Id};

/// A given load: a force at a point, a moment, or both.
#[derive(Clone)]
pub struct Load {
    pub name: Ident,
    pub family: Family,
    pub force: Vector,
    /// The point of action of the force.
    pub point: Point,
    /// The moment, without that of the force.
    pub moment: Vector,
    /// For the potential of a rod: the pull `-dU/du` at its axis u, in world axes. The moment is
    /// `u x` this.
    pub pull: Option<Components>,
    /// The potential from which the load is derived, if there is one. Such a load acts all over the
    /// body, and `point` is arbitrary.
    pub potential: Option<Id>,
    /// What errors about the load underline.
    pub extent: Extent,
    /// The place where it mentions an unknown reaction.
    pub mention: Option<Extent>,
}

impl Load {
    /// Whether it depends on an acceleration.
    pub fn follows(&self, work: &Workspace) -> bool {
        let parts = work.entries(&[self.force, self.moment]);
        !work.accelerations_in(&parts).is_empty()
    }

    /// A load that is only a force or only a moment.
    pub fn new(name: Ident, family: Family, kind: LoadKind, vector: Vector, point: Point) -> Self {
        let (force, moment) = match kind {
            LoadKind::Force => (vector, Vector::ZERO),
            LoadKind::Moment => (Vector::ZERO, vector),
        };
        Self {
            extent: name.span().into(),
            name,
            family,
            force,
            point,
            moment,
            pull: None,
            potential: None,
            mention: None,
        }
    }

    /// The same load with another force and moment.
    pub fn with(&self, force: Vector, moment: Vector) -> Self {
        let name = self.name.clone();
        Self {
            name,
            force,
            moment,
            ..*self
        }
    }
}
