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
    let order = order(system, equations);
    let motion = motion(work, equations, &closed.inertias);
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
                // where a rate alone is kept at zero, its terms do not tell how large it could be
                let square = graph.multiply(coupling[number], motion);
                let across = graph.apply(Function::Sqrt, &[square]);
                let reached = graph.apply(Function::Max, &[fast, across]);
                let consistency = Consistency {
                    name: row.name.clone(),
                    position,
                    velocity: (row.rate, fast),
                    direction: order.iter().map(|freedom| direction[*freedom]).collect(),
                    coupling,
                };
                let reach = Reach {
                    position: position.map(|(_, size)| size),
                    velocity: reached,
                };
                (consistency, reach)
            });
    rows.collect()
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
