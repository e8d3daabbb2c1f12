//! The leaves of expressions, without descending into rotations.

use std::collections::{HashMap, HashSet};

use crate::model::{Turn, Workspace};
use crate::symbolic::{Components, Id, Node};

/// The late symbols on which expressions depend, and the rotated vectors in them, each after those
/// in it.
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
            // the original precedes its rotated components; otherwise these do not show the
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
}
