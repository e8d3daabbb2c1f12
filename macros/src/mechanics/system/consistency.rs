//! How far a state is from what is kept, and the way back: along the slopes of the constraints,
//! in the metric of what each freedom has of the kinetic energy alone.

use crate::mechanics::unknowns::{Consistency, Reach, summed_size};
use crate::model::{System, Workspace};
use crate::symbolic::Id;

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
    let rows = closed
        .constraints
        .iter()
        .zip(&directions)
        .map(|(row, direction)| {
            let coupling = directions.iter().map(|other| {
                let parts = row.slopes.iter().zip(other);
                let parts: Vec<Id> = parts.map(|(a, b)| graph.multiply(*a, *b)).collect();
                graph.sum(&parts)
            });
            let coupling = coupling.collect();
            let position = row.value.map(|value| (value, summed_size(graph, value)));
            let fast = summed_size(graph, row.rate);
            let consistency = Consistency {
                name: row.name.clone(),
                position,
                velocity: (row.rate, fast),
                direction: order.iter().map(|freedom| direction[*freedom]).collect(),
                coupling,
            };
            let reach = Reach {
                position: position.map(|(_, size)| size),
                velocity: fast,
            };
            (consistency, reach)
        });
    rows.collect()
}
