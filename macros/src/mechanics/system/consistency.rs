//! How far a state is from what is kept, and the way back: along the slopes of the constraints,
//! in the metric of what each freedom has of the kinetic energy alone.

use crate::mechanics::tree::link::Link;
use crate::mechanics::unknowns::{Consistency, Reach, summed_size};
use crate::model::{System, Workspace};
use crate::symbolic::{Function, Id};

use super::equations::SystemEquations;
use super::rates::order;

/// The constraints as the runtime is told of them, each with what it may be in a state of this size.
pub fn derive_system_consistency(
    system: &System,
    work: &mut Workspace,
    equations: &SystemEquations,
) -> Vec<(Consistency, Reach)> {
    let Some(closed) = &equations.closed else {
        return Vec::new();
    };
    let order = order(system, &equations.built);
    let motion = motion(work, equations, &closed.inertias);
    let turn = turn(work, equations, &closed.inertias);
    let graph = &mut work.graph;
    let directions: Vec<Vec<Id>> = closed
        .constraints
        .iter()
        .map(|row| {
            let parts = row.slopes.iter().zip(&closed.inertias);
            parts
                .map(|(slope, inertia)| graph.divide(*slope, *inertia))
                .collect()
        })
        .collect();
    let rows =
        closed
            .constraints
            .iter()
            .zip(&directions)
            .enumerate()
            .map(|(number, (row, direction))| {
                let coupling: Vec<Id> = directions
                    .iter()
                    .map(|other| {
                        let parts = row.slopes.iter().zip(other);
                        let parts: Vec<Id> = parts.map(|(a, b)| graph.multiply(*a, *b)).collect();
                        graph.sum(&parts)
                    })
                    .collect();
                let position = row.value.map(|value| (value, summed_size(graph, value)));
                let fast = summed_size(graph, row.rate);
                // where an angle or a rate alone is kept at zero, its terms do not tell how large it could be
                let mut reached = |size: Id, of_all: Id| {
                    let square = graph.multiply(coupling[number], of_all);
                    let across = graph.apply(Function::Sqrt, &[square]);
                    graph.apply(Function::Max, &[size, across])
                };
                let reach = Reach {
                    position: position.map(|(_, size)| reached(size, turn)),
                    velocity: reached(fast, motion),
                };
                let consistency = Consistency {
                    name: row.name.clone(),
                    position,
                    velocity: (row.rate, reach.velocity),
                    direction: order.iter().map(|freedom| direction[*freedom]).collect(),
                    coupling,
                };
                (consistency, reach)
            });
    rows.collect()
}

/// The same as twice the kinetic energy, with an angle of one in the place of the rate of each freedom
/// that turns, and nothing for those that slide.
fn turn(work: &mut Workspace, equations: &SystemEquations, inertias: &[Id]) -> Id {
    let freedoms = equations.built.tree.links.iter().flat_map(Link::open);
    let turning = freedoms
        .zip(inertias)
        .filter(|(freedom, _)| !work.graph.is_zero_vector(&freedom.twist.angular));
    let inertias: Vec<Id> = turning.map(|(_, inertia)| *inertia).collect();
    work.graph.sum(&inertias)
}

/// Twice the kinetic energy, as if each freedom moved alone.
fn motion(work: &mut Workspace, equations: &SystemEquations, inertias: &[Id]) -> Id {
    let freedoms = equations.built.tree.links.iter().flat_map(Link::open);
    let graph = &mut work.graph;
    let parts: Vec<Id> = freedoms
        .zip(inertias)
        .map(|(freedom, inertia)| {
            let square = graph.multiply(freedom.rate, freedom.rate);
            graph.multiply(*inertia, square)
        })
        .collect();
    graph.sum(&parts)
}
