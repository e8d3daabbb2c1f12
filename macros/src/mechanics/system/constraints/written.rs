//! Written constraints, of positions and of velocities, with their loads. A load acts along the
//! gradient of its constraint, so it does no work in a motion that the constraint allows.

use crate::mechanics::tree::Built;
use crate::mechanics::tree::link::{Link, Tree};
use crate::mechanics::unknowns::activity;
use crate::mechanics::variation::{Derived, Direction, Slopes, derive_unit_loads};
use crate::model::{Constraint, Level, System, Workspace};
use crate::symbolic::{Graph, Id};

use super::row::ConstraintRow;

/// The rows of all written constraints.
pub fn rows(
    system: &System,
    work: &mut Workspace,
    built: &Built,
    motion: &Direction,
) -> Vec<ConstraintRow> {
    let freedoms = built.tree.links.iter().flat_map(Link::open);
    let rates: Vec<Id> = freedoms.map(|freedom| freedom.rate).collect();
    let list = system.constraints.list.iter();
    list.map(|constraint| row(work, constraint, motion, &rates))
        .collect()
}

fn row(
    work: &mut Workspace,
    constraint: &Constraint,
    motion: &Direction,
    rates: &[Id],
) -> ConstraintRow {
    let (value, rate) = match constraint.level {
        Level::Position => {
            let rate = Slopes::of(work, constraint.value).along(work, motion);
            (Some(work.graph.quantity(constraint.value)), rate)
        }
        Level::Velocity => (None, constraint.value),
    };
    let slopes = Slopes::of(work, rate);
    let bias = slopes.along(work, motion);
    let slopes: Vec<Id> = rates
        .iter()
        .map(|rate| {
            let slope = slopes.by_symbol(work, *rate);
            work.graph.quantity(slope)
        })
        .collect();
    ConstraintRow {
        name: constraint.name.clone(),
        value,
        facing: None,
        rate: work.graph.quantity(rate),
        bias: work.graph.quantity(bias),
        activity: activity(work, &slopes, constraint.level, [rate, bias]),
        slopes,
    }
}

/// Puts the loads of all written constraints on the links of a tree and along its freedoms.
pub fn push(system: &System, work: &mut Workspace, built: &Built, tree: &mut Tree, loads: &[Id]) {
    let Some(form) = &system.constraints.form else {
        return;
    };
    let levels = system.constraints.list.iter().map(|one| one.level);
    let units = derive_unit_loads(work, form, levels);
    for (unit, load) in units.iter().zip(loads) {
        push_one(system, work, built, tree, (unit, *load));
    }
}

fn push_one(
    system: &System,
    work: &mut Workspace,
    built: &Built,
    tree: &mut Tree,
    (unit, load): (&Derived, Id),
) {
    let Some(form) = &system.constraints.form else {
        return;
    };
    let add = |graph: &mut Graph, sum: Id, part: Id| {
        let part = graph.multiply(load, part);
        graph.add(sum, part)
    };
    for (displaced, draw) in form.bodies.iter().zip(&unit.on) {
        let mut bodies = system.bodies.iter();
        let Some(body) = bodies.position(|body| body.state.body == displaced.body) else {
            continue;
        };
        let force = work.components(draw.force, displaced.body);
        let link = &mut tree.links[built.body(body)];
        let sums = link.force.iter_mut().chain(&mut link.moment);
        for (sum, part) in sums.zip(force.into_iter().chain(draw.moment)) {
            *sum = add(&mut work.graph, *sum, part);
        }
    }
    for (along, part) in form.along.iter().zip(&unit.along) {
        let links = built.links[along.joint].clone();
        let mut freedoms = tree.links[links]
            .iter_mut()
            .flat_map(|link| &mut link.freedoms);
        if let Some(freedom) = freedoms.nth(along.freedom) {
            freedom.drive = add(&mut work.graph, freedom.drive, *part);
        }
    }
}
