//! Axes about which the inertia of a body is symmetric.

use crate::mechanics::proofs::all_vanish;
use crate::model::Workspace;
use crate::symbolic::{Components, Graph, Id, Number, Spectrum};

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

/// The unit vector along a nonzero vector of numbers.
fn known_direction(graph: &mut Graph, vector: &Components) -> Option<Components> {
    let number = |i: usize| graph.as_number(vector[i]).cloned();
    let components = [number(0)?, number(1)?, number(2)?];
    let is_zero = components.iter().all(Number::is_zero);
    (!is_zero).then(|| unit(graph, &components))
}
