//! The distance of a state from its constraints, and the correction along their slopes,
//! in the metric of the kinetic energy of each coordinate alone.

use crate::mechanics::tree::link::Link;
use crate::mechanics::unknowns::{Consistency, Reach, summed_size};
use crate::model::{System, Workspace};
use crate::symbolic::{Function, Graph, Id};

use super::equations::SystemEquations;
use super::rates::order;

/// The constraints as the runtime sees them, each with the rounding that it may have in a state of
/// this size.
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
    let couplings: Vec<Vec<Id>> = closed
        .constraints
        .iter()
        .map(|row| {
            let others = directions.iter().map(|other| {
                let parts = row.slopes.iter().zip(other);
                let parts: Vec<Id> = parts.map(|(a, b)| graph.multiply(*a, *b)).collect();
                graph.sum(&parts)
            });
            others.collect()
        })
        .collect();
    let rows = closed.constraints.iter().enumerate();
    let rows = rows.map(|(number, row)| {
        let own = couplings[number][number];
        // a row without slope where a linkage folds counts with the largest coupling of its joint
        let part = closed.parts[number];
        let is_alike = |other: usize| part.is_some() && closed.parts[other] == part;
        let alike = (0..couplings.len()).filter(|other| is_alike(*other));
        let largest = alike.fold(own, |largest, other| {
            graph.apply(Function::Max, &[largest, couplings[other][other]])
        });
        let mut reach = |coupling: Id| Reach {
            position: row.value.map(|value| reached(graph, value, coupling, turn)),
            velocity: reached(graph, row.rate, coupling, motion),
        };
        let sizes = reach(own);
        let consistency = Consistency {
            name: row.name.clone(),
            position: row.value.zip(sizes.position),
            velocity: (row.rate, sizes.velocity),
            direction: order
                .iter()
                .map(|freedom| directions[number][*freedom])
                .collect(),
            coupling: couplings[number].clone(),
            follows: closed.follows[number],
        };
        (consistency, reach(largest))
    });
    rows.collect()
}

/// The size of a value in a state of this size. If an angle or a rate alone is kept at zero, its
/// terms give no size.
fn reached(graph: &mut Graph, value: Id, coupling: Id, of_state: Id) -> Id {
    let size = summed_size(graph, value);
    let square = graph.multiply(coupling, of_state);
    let across = graph.apply(Function::Sqrt, &[square]);
    graph.apply(Function::Max, &[size, across])
}

/// As twice the kinetic energy, with one in place of the rate of each rotation, and zero for each
/// slide.
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
