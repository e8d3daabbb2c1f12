//! The effect of one unit of each unknown component of a load.

use crate::errors::Extent;
use crate::mechanics::balances::{about_pole, moments_about, resultant};
use crate::model::{Frame, Load, Model, Reaction, Vector, Workspace};
use crate::symbolic::{Components, Elimination, Id};

/// One unit of an unknown component of a load.
pub struct Unit<'m> {
    pub load: &'m Reaction,
    pub axis: usize,
    pub place: Extent,
    /// The load that is one unit of this component.
    pub direction: Vector,
    /// The force, including that of the loads that depend on it.
    pub force: Vector,
    /// The moment about the center, likewise.
    pub moment: Vector,
}

impl<'m> Unit<'m> {
    /// One unit of the unknown component with this axis and place, including dependent loads.
    pub fn new(
        model: &Model,
        work: &mut Workspace,
        load: &'m Reaction,
        frame: Frame,
        (axis, place): (usize, Extent),
        followers: &[Load],
    ) -> Self {
        let direction = load.direction(work, frame, axis);
        let center = model.state.center(work);
        let (force, moment) = about_pole(&model.state, work, load, direction, center);
        let following = resultant(work, followers);
        let mut moments = moments_about(&model.state, work, followers, center);
        moments.insert(0, moment);
        let (force, moment) = (work.add(force, following), work.sum(moments));
        Self {
            load,
            axis,
            place,
            direction,
            force,
            moment,
        }
    }

    /// One unit of each unknown component of these loads, in the axes in which it is written, or in
    /// other axes if given.
    pub fn list(
        model: &Model,
        work: &mut Workspace,
        loads: impl IntoIterator<Item = &'m Reaction>,
        frame: Option<Frame>,
    ) -> Vec<Self> {
        let mut units = Vec::new();
        for load in loads {
            let frame = frame.unwrap_or(load.frame);
            let unknown = load.unknown.iter();
            units.extend(unknown.map(|one| Self::new(model, work, load, frame, *one, &[])));
        }
        units
    }

    /// Its name in messages.
    pub fn name(&self, model: &Model) -> String {
        self.load.component_name(model.motion, self.axis)
    }
}

/// The names of unknowns for messages, and their places.
pub fn names<'u>(
    model: &Model,
    units: impl IntoIterator<Item = &'u Unit<'u>>,
) -> Vec<(String, Extent)> {
    let units = units.into_iter();
    units.map(|unit| (unit.name(model), unit.place)).collect()
}

/// Names the values of unknowns and the divisors that give them.
pub fn name_values(work: &mut Workspace, names: &[(String, Extent)], elimination: &Elimination) {
    for ((name, _), value) in names.iter().zip(&elimination.values) {
        work.labels.name(*value, name.replace('.', "_"));
    }
    for (column, reciprocal) in &elimination.pivots {
        let (name, _) = &names[*column];
        work.labels.divide_for(*reciprocal, name.clone());
    }
}

/// A load: the sum of its known part and its units times their values.
pub fn assemble<'u>(
    work: &mut Workspace,
    load: &Reaction,
    solved: impl IntoIterator<Item = (&'u Unit<'u>, Id)>,
) -> Vector {
    let mut parts = vec![work.vector(load.frame, load.known)];
    for (unit, value) in solved {
        if core::ptr::eq(unit.load, load) {
            parts.push(work.scale(value, unit.direction));
        }
    }
    work.sum(parts)
}

/// A solved load, as a result in these axes.
pub fn named_result(
    work: &mut Workspace,
    load: &Reaction,
    whole: Vector,
    frame: Frame,
) -> Components {
    let components = work.components(whole, frame);
    let components = work.graph.results(components);
    work.labels.vector(&load.name.to_string(), components);
    components
}
