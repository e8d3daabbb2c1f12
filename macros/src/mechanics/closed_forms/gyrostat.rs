//! A gyrostat: a body with rotors that is symmetric about the axis e of all rotors.
//!
//! ```text
//! w' = n w x e + r' e        r = w . e; n' and r' constant
//! ```
//!
//! `n = r - h/A`, where A is the moment of inertia across the axis, and h is the angular momentum
//! along it, including that of the rotors. All of these follow from the acceleration.

use crate::mechanics::proofs::all_vanish;
use crate::model::Workspace;
use crate::symbolic::{Components, Id, Number};

use super::constants::{at_rest, constants};

/// What determines the motion of a gyrostat.
pub struct Gyrostat {
    /// The unit vector e, in body axes.
    pub axis: Components,
    /// n, as a function of the state.
    pub spin: Id,
    /// n', which is constant.
    pub drift: Id,
    /// r', which is constant.
    pub along: Id,
}

/// The rotation of a body, and the symbols that its acceleration may depend on.
pub struct Turning<'a> {
    /// In body axes.
    pub angular_velocity: Components,
    pub angular_acceleration: Components,
    /// The rates of a state, each with its acceleration.
    pub rates: &'a [(Id, Id)],
}

impl Turning<'_> {
    /// The acceleration that belongs to a rate.
    fn acceleration(&self, rate: Id) -> Option<Id> {
        let mut rates = self.rates.iter();
        let found = rates.find(|(symbol, _)| *symbol == rate);
        found.map(|(_, acceleration)| *acceleration)
    }
}

impl Gyrostat {
    pub fn roots(&self) -> Vec<Id> {
        [&self.axis[..], &[self.spin, self.drift, self.along]].concat()
    }

    /// The gyrostat about one of these axes: the first about which the body is a gyrostat.
    pub fn find(work: &mut Workspace, turning: &Turning<'_>, axes: &[Components]) -> Option<Self> {
        axes.iter()
            .find_map(|axis| Self::about(work, turning, *axis))
    }

    fn about(work: &mut Workspace, turning: &Turning<'_>, axis: Components) -> Option<Self> {
        let (w, acceleration) = (turning.angular_velocity, turning.angular_acceleration);
        let spin = spin(work, turning, axis);
        let graph = &mut work.graph;
        let along = graph.dot(acceleration, axis);
        let pushed = graph.scale_vector(along, axis);
        let across = graph.cross(w, axis);
        let turned = graph.scale_vector(spin, across);
        let known = graph.add_vectors(turned, pushed);
        let rest = graph.subtract_vectors(acceleration, known);
        if !all_vanish(work, &rest) {
            return None;
        }
        let drift = work.graph.change(&[spin], |id| turning.acceleration(id))[0];
        let excess = work.graph.subtract(along, drift);
        let along = if all_vanish(work, &[excess]) {
            drift
        } else {
            along
        };
        let known = constants(work, &[drift, along])?;
        work.labels.name(spin, "spin");
        Some(Self {
            axis,
            spin,
            drift: known[0],
            along: known[1],
        })
    }
}

/// n, if the body is a gyrostat: half the rotation about e in the linear map from w to w', taken
/// where w is along e and only rates are nonzero. Nothing is divided by a component of the axis,
/// which may vanish.
fn spin(work: &mut Workspace, turning: &Turning<'_>, axis: Components) -> Id {
    let w = turning.angular_velocity;
    let place = |id: Id| w.iter().position(|component| *component == id);
    let graph = &mut work.graph;
    let mut twice = graph.zero();
    for unit in graph.unit_vectors() {
        let across = graph.cross(unit, axis);
        let part = graph.dot(turning.angular_acceleration, across);
        let change = graph.change(&[part], |id| Some(unit[place(id)?]))[0];
        twice = graph.add(twice, change);
    }
    let half = graph.number(Number::ratio(1, 2));
    let spin = graph.distribute(half, twice);
    let along = graph.dot(w, axis);
    let along = graph.scale_vector(along, axis);
    let spin = graph.substitute(&[spin], |id| Some(along[place(id)?]));
    let is_rate = |id: Id| turning.acceleration(id).is_some();
    at_rest(work, &spin, is_rate)[0]
}
