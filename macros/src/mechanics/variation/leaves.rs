//! The leaves of expressions; rotations are not taken apart.

use std::collections::{HashMap, HashSet};

use crate::model::{Turn, Workspace};
use crate::symbolic::{Components, Id, Node};

/// The late symbols that expressions depend on, and the rotated vectors in them. Each rotated
/// vector comes after those that it contains.
pub struct Leaves {
    pub symbols: HashSet<Id>,
    pub turns: Vec<Turn>,
}

impl Leaves {
    pub fn of(work: &Workspace, roots: &[Id]) -> Self {
        let graph = &work.graph;
        let late = |parts: Components| parts.into_iter().filter(|id| !graph.is_early(*id));
        let first = |turn: &Turn| late(turn.turned).min();
        let mut turned: HashMap<Id, &Turn> = HashMap::new();
        for turn in &work.turned {
            // the original must precede its rotated components, otherwise these do not contain the
            // rotation
            if late(turn.vector).max() < first(turn) {
                for part in late(turn.turned) {
                    turned.entry(part).or_insert(turn);
                }
            }
        }
        let (mut symbols, mut turns) = (HashSet::new(), Vec::new());
        let (mut pending, mut seen) = (roots.to_vec(), HashSet::new());
        while let Some(id) = pending.pop() {
            if graph.is_early(id) || !seen.insert(id) {
                continue;
            }
            if let Some(turn) = turned.get(&id) {
                turns.push(**turn);
                pending.extend(turn.vector);
            } else if let Node::Symbol(_) = graph.node(id) {
                symbols.insert(id);
            } else {
                pending.extend(graph.node(id).operands());
            }
        }
        turns.sort_by_key(first);
        turns.dedup();
        Self { symbols, turns }
    }

    /// The same leaves, and the roots rewritten so that the slopes of norms are zero where the
    /// norms are.
    pub fn with_level_norms(work: &mut Workspace, roots: &[Id]) -> (Self, Vec<Id>) {
        let Self { symbols, mut turns } = Self::of(work, roots);
        let turned = turns.iter().flat_map(|turn| turn.turned);
        let unseen: HashSet<Id> = symbols.iter().copied().chain(turned).collect();
        let mut level = |roots: &[Id]| work.graph.level_norms(roots, |id| unseen.contains(&id));
        for turn in &mut turns {
            let vector = level(&turn.vector);
            turn.vector = [vector[0], vector[1], vector[2]];
        }
        let roots = level(roots);
        (Self { symbols, turns }, roots)
    }
}
