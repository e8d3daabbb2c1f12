//! The distance of a state from its constraints, and the correction along their slopes. The metric
//! is the kinetic energy of each coordinate by itself.

use crate::mechanics::tree::link::Link;
use crate::mechanics::unknowns::{Consistency, Reach, reached, summed_size};
use crate::model::{Labels, System, Workspace};
use crate::symbolic::{Function, Graph, Id};

use super::closed::Closed;
use super::constraints::ConstraintRow;
use super::equations::SystemEquations;
use super::rates::order;

/// The constraints as they are passed to the runtime, each with the rounding error that it may have
/// in a state of this size.
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
    let (directions, couplings) = corrections(&mut work.graph, closed);
    label(&mut work.labels, closed, &couplings);
    let graph = &mut work.graph;
    let owners = closed.kept.iter().map(|(owner, _)| owner);
    let parts: Vec<_> = owners.map(|owner| owner.joint_part(graph)).collect();
    let rows = closed.rows().enumerate();
    let rows = rows.map(|(number, row)| {
        let own = couplings[number][number];
        // a row that is flat where a linkage folds gets the tolerance of the other rows of its joint
        let part = parts[number];
        let is_alike = |other: &usize| *other == number || part.is_some() && parts[*other] == part;
        let alike = (0..couplings.len()).filter(is_alike);
        let first = alike.clone().next().unwrap_or(number);
        let largest = alike.fold(own, |largest, other| {
            graph.apply(Function::Max, &[largest, couplings[other][other]])
        });
        // if a constraint keeps a single angle or rate at zero, its own terms do not bound its
        // rounding error
        let mut within = |value: Id, coupling: Id, of_state: Id| {
            let size = summed_size(graph, value);
            reached(graph, size, coupling, of_state)
        };
        let mut reach = |coupling: Id| Reach {
            position: row.value.map(|value| within(value, coupling, turn)),
            velocity: within(row.rate, coupling, motion),
        };
        let sizes = reach(own);
        let consistency = Consistency {
            name: row.name.clone(),
            position: row.value.zip(sizes.position),
            facing: row.facing,
            velocity: (row.rate, sizes.velocity),
            direction: order
                .iter()
                .map(|freedom| directions[number][*freedom])
                .collect(),
            coupling: couplings[number].clone(),
            part: first,
            follows: closed.follows[number],
        };
        (consistency, reach(largest))
    });
    rows.collect()
}

/// The change of the coordinates per unit of each row, and the resulting changes of all rows.
fn corrections(graph: &mut Graph, closed: &Closed) -> (Vec<Vec<Id>>, Vec<Vec<Id>>) {
    let mut directions = Vec::new();
    for row in closed.rows() {
        let parts = row.slopes.iter().zip(&closed.inertias);
        let parts = parts.map(|(slope, inertia)| graph.divide(*slope, *inertia));
        directions.push(parts.collect());
    }
    let mut couplings = Vec::new();
    for row in closed.rows() {
        let others = directions
            .iter()
            .map(|other: &Vec<Id>| graph.inner(&row.slopes, other));
        couplings.push(others.collect());
    }
    (directions, couplings)
}

/// Names the changes of rows per unit of a load, as inverse masses.
fn label(labels: &mut Labels, closed: &Closed, couplings: &[Vec<Id>]) {
    let names = || closed.rows().map(ConstraintRow::spelled);
    for (own, couplings) in names().zip(couplings) {
        for (other, coupling) in names().zip(couplings) {
            let of = if own == other {
                own.clone()
            } else {
                format!("{own}_{other}")
            };
            labels.name(*coupling, format!("inverse_mass_{of}"));
        }
    }
}

/// Twice the kinetic energy, as below, with the rate of each rotation set to one, and that of each
/// slide to the distance of its joint from the origin of the carrier.
fn turn(work: &mut Workspace, equations: &SystemEquations, inertias: &[Id]) -> Id {
    let graph = &mut work.graph;
    let links = equations.built.tree.links.iter();
    let freedoms = links.flat_map(|link| link.open().map(move |freedom| (link, freedom)));
    let parts = freedoms.zip(inertias).map(|((link, freedom), inertia)| {
        if !graph.is_zero_vector(&freedom.twist.angular) {
            return *inertia;
        }
        let square = graph.inner(&link.place, &link.place);
        graph.multiply(*inertia, square)
    });
    let parts: Vec<Id> = parts.collect();
    let sum = graph.sum(&parts);
    work.labels.name(sum, "turning_inertia");
    sum
}

/// Twice the kinetic energy, as if each freedom moved by itself.
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
    let sum = graph.sum(&parts);
    work.labels.name(sum, "twice_kinetic_energy");
    sum
}
