//! The unknown components of loads: what one unit of each does.

use crate::errors::Extent;
use crate::families::LoadKind;
use crate::mechanics::balances::arm;
use crate::model::{Frame, Model, Point, Reaction, Vector, Workspace};
use crate::symbolic::{Components, Elimination, Id};

/// A force with the point at which it acts, and a moment.
pub type Acting = (Vector, Point, Vector);

/// One unit of an unknown component of a load.
pub struct Unit<'m> {
    pub load: &'m Reaction,
    pub axis: usize,
    pub place: Extent,
    /// Of the component by itself.
    pub direction: Vector,
    /// With that of the loads that follow it.
    pub force: Vector,
    /// The same, about the center.
    pub moment: Vector,
}

impl<'m> Unit<'m> {
    /// Of an unknown component, by its axis and its place, with what follows it.
    pub fn new(
        model: &Model,
        work: &mut Workspace,
        load: &'m Reaction,
        frame: Frame,
        (axis, place): (usize, Extent),
        followers: &[Acting],
    ) -> Self {
        let direction = load.direction(work, frame, axis);
        let own = match load.kind {
            LoadKind::Force => (direction, load.point, Vector::ZERO),
            LoadKind::Moment => (Vector::ZERO, load.point, direction),
        };
        let (force, moment) = about_center(model, work, &[&[own], followers].concat());
        Self {
            load,
            axis,
            place,
            direction,
            force,
            moment,
        }
    }

    /// Of each unknown component of loads by itself, in the axes in which it is written, or others.
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

    /// What messages call it.
    pub fn name(&self, model: &Model) -> String {
        self.load.component_name(model.motion, self.axis)
    }
}

/// The force of loads that act at points, and their moment about the center.
fn about_center(model: &Model, work: &mut Workspace, loads: &[Acting]) -> (Vector, Vector) {
    let center = model.state.center(work);
    let (mut forces, mut moments) = (Vec::new(), Vec::new());
    for &(force, point, moment) in loads {
        moments.push(moment);
        if !force.is_zero() {
            let arm = arm(model, work, point, center);
            moments.push(work.cross(arm, force));
            forces.push(force);
        }
    }
    (work.sum(forces), work.sum(moments))
}

/// What messages call unknowns, and their places.
pub fn names<'u>(
    model: &Model,
    units: impl IntoIterator<Item = &'u Unit<'u>>,
) -> Vec<(String, Extent)> {
    let units = units.into_iter();
    units.map(|unit| (unit.name(model), unit.place)).collect()
}

/// Names the values of unknowns, and what is divided by for them.
pub fn name_values(work: &mut Workspace, names: &[(String, Extent)], elimination: &Elimination) {
    for ((name, _), value) in names.iter().zip(&elimination.values) {
        work.labels.name(*value, name.replace('.', "_"));
    }
    for (column, reciprocal) in &elimination.pivots {
        let (name, _) = &names[*column];
        work.labels.divide_for(*reciprocal, name.clone());
    }
}

/// A load: what is known of it, and the values of its units.
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

/// A load that is solved for, as a result in these axes.
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
