//! A gyrostat: a body with rotors, symmetric about the axis e of all rotors.
//!
//! ```text
//! w' = n w x e + r' e        r = w . e; n' and r' constant
//! ```
//!
//! With A the moment of inertia across the axis, and h the angular momentum along it including that
//! of the rotors, `n = r - h/A`. All of these follow from the acceleration.

use crate::mechanics::proofs::all_vanish;
use crate::model::Workspace;
use crate::symbolic::{Components, Id, Number};

use super::constants::{at_rest, constants};

/// The quantities that determine the motion of a gyrostat.
pub struct Gyrostat {
    /// e, a unit vector, body axes.
    pub axis: Components,
    /// n, in a state.
    pub spin: Id,
    /// n', constant.
    pub drift: Id,
    /// r', constant.
    pub along: Id,
}

/// The rotation of a body, and the symbols on which its acceleration may depend.
pub struct Turning<'a> {
    /// Body axes.
    pub angular_velocity: Components,
    pub angular_acceleration: Components,
    /// The rates of a state, with their accelerations.
    pub rates: &'a [(Id, Id)],
}

impl Turning<'_> {
    /// The acceleration of a rate.
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

    /// The gyrostat about the first of these axes that is the axis of one.
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

/// n, if there is one: half the turn of the map from w to w' about e, where w is along e and only
/// rates are not zero. Nothing divides by a component of the axis, which may vanish.
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
