//! The mass matrix of a system, and what drives its freedoms.

use crate::mechanics::tree::{MassMatrix, Tree};
use crate::model::{System, Workspace};
use crate::symbolic::Id;

use super::equations::SystemEquations;

/// `M q'' = f`, in the order in which the state has its rates.
pub struct Inertias {
    pub rows: Vec<Vec<Id>>,
    /// What drives each freedom, less what its motion takes without acceleration.
    pub driving: Vec<Id>,
}

/// The mass matrix, and what it is multiplied with the accelerations for.
pub fn derive_inertias(
    system: &System,
    work: &mut Workspace,
    equations: &SystemEquations,
) -> Inertias {
    let mut tree: Tree = equations.built.tree.clone();
    for link in tree.links.iter_mut().filter(|link| link.is_free) {
        // accelerations of G along world axes
        link.is_free = false;
        for freedom in &mut link.freedoms {
            freedom.twist.linear = link.turning.to_link(&mut work.graph, freedom.twist.linear);
        }
    }
    let found = MassMatrix::derive(&mut work.graph, &mut work.labels, &tree);
    let firsts = tree.links.iter().scan(0, |next, link| {
        let first = *next;
        *next += link.open().count();
        Some(first..*next)
    });
    let firsts: Vec<_> = firsts.collect();
    let written = system.written.iter();
    let links = written.flat_map(|joint| equations.built.links[*joint].clone());
    let order: Vec<usize> = links.flat_map(|link| firsts[link].clone()).collect();
    let mut result = |id: Id| work.graph.result(id);
    Inertias {
        rows: order
            .iter()
            .map(|row| {
                order
                    .iter()
                    .map(|column| result(found.rows[*row][*column]))
                    .collect()
            })
            .collect(),
        driving: order
            .iter()
            .map(|row| result(found.driving[*row]))
            .collect(),
    }
}
