//! Axes about which the inertia of a body is symmetric.

use std::collections::HashMap;

use crate::mechanics::proofs::all_vanish;
use crate::model::Workspace;
use crate::symbolic::{Components, Graph, Id, Node, Number, Spectrum};

use super::free_rotation::unit;
use super::solid::Solid;

/// The axes about which the body is symmetric: for each, the moments of inertia across it and along
/// it, and its unit vector. For a spherical body, these are the first of `directions` that is
/// known, and the body axes.
pub fn axes_of_symmetry(
    solid: &Solid,
    work: &mut Workspace,
    directions: &[Components],
) -> Vec<([Id; 2], Components)> {
    let rows = &solid.rows;
    let units = work.graph.unit_vectors();
    let moments = match work.graph.spectrum(rows) {
        None => {
            let axes: Vec<usize> = (0..3)
                .filter(|axis| is_symmetric(work, rows, *axis))
                .collect();
            if axes.is_empty() {
                let axis = likely_axis(&mut work.graph, rows);
                let about = axis.and_then(|axis| Some((moments_about(work, rows, axis)?, axis)));
                return about.into_iter().collect();
            }
            if axes.len() < 2 {
                let across = |axis: usize| rows[(axis + 1) % 3][(axis + 1) % 3];
                let about = |axis| ([across(axis), rows[axis][axis]], units[axis]);
                return axes.into_iter().map(about).collect();
            }
            [rows[0][0]; 2]
        }
        Some(Spectrum::General(_)) => return Vec::new(),
        Some(Spectrum::Symmetric(symmetry)) => {
            let graph = &mut work.graph;
            let moments =
                [&symmetry.across, &symmetry.along].map(|moment| graph.number(moment.clone()));
            return vec![(moments, unit(graph, &symmetry.axis))];
        }
        Some(Spectrum::Spherical(moment)) => [work.graph.number(moment); 2],
    };
    let graph = &mut work.graph;
    let known = directions
        .iter()
        .find_map(|vector| known_direction(graph, vector));
    known
        .into_iter()
        .chain(units)
        .map(|axis| (moments, axis))
        .collect()
}

/// Whether a tensor of parameters is symmetric about a coordinate axis.
fn is_symmetric(work: &mut Workspace, rows: &[Components; 3], axis: usize) -> bool {
    let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
    let difference = work.graph.subtract(rows[i][i], rows[j][j]);
    let roots = [difference, rows[0][1], rows[1][2], rows[2][0]];
    all_vanish(work, &roots)
}

/// The moments across an axis and about it, if a tensor of parameters is symmetric about it:
/// `J = a 1 + (b - a) e e`.
fn moments_about(
    work: &mut Workspace,
    rows: &[Components; 3],
    axis: Components,
) -> Option<[Id; 2]> {
    let graph = &mut work.graph;
    let turned = graph.transform(rows, axis);
    let about = graph.dot(axis, turned);
    let trace = graph.sum(&[rows[0][0], rows[1][1], rows[2][2]]);
    let both = graph.subtract(trace, about);
    let half = graph.number(Number::ratio(1, 2));
    let across = graph.multiply(half, both);
    let more = graph.subtract(about, across);
    let mut rest = Vec::new();
    for i in 0..3 {
        let along = graph.multiply(more, axis[i]);
        for j in 0..=i {
            let part = graph.multiply(along, axis[j]);
            let left = graph.subtract(rows[i][j], part);
            rest.push(if i == j {
                graph.subtract(left, across)
            } else {
                left
            });
        }
    }
    all_vanish(work, &rest).then_some([across, about])
}

/// The axis about which a tensor of parameters is symmetric for some values of these.
fn likely_axis(graph: &mut Graph, rows: &[Components; 3]) -> Option<Components> {
    let shares = (0..128).map(|share| graph.number(Number::one() + Number::ratio(share, 128)));
    let shares: Vec<Id> = shares.collect();
    let entries = rows.concat();
    let symbols: HashMap<Id, Id> = graph
        .nodes_of(&entries)
        .into_iter()
        .filter(|id| matches!(graph.node(*id), Node::Symbol(_)))
        .zip(shares)
        .collect();
    let values = graph.substitute(&entries, |id| symbols.get(&id).copied());
    let row = |i: usize| [values[3 * i], values[3 * i + 1], values[3 * i + 2]];
    match graph.spectrum(&[row(0), row(1), row(2)])? {
        Spectrum::Symmetric(symmetry) => Some(unit(graph, &symmetry.axis)),
        _ => None,
    }
}

/// The unit vector along a nonzero vector of numbers.
fn known_direction(graph: &mut Graph, vector: &Components) -> Option<Components> {
    let number = |i: usize| graph.as_number(vector[i]).cloned();
    let components = [number(0)?, number(1)?, number(2)?];
    let is_zero = components.iter().all(Number::is_zero);
    (!is_zero).then(|| unit(graph, &components))
}
