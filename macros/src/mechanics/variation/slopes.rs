//! Slopes: the change of an expression along any direction of the space of states.
//!
//! The backward chain rule gives all of them: it goes from the expression down to its leaves, which
//! are the symbols of the state and rotated vectors. A rotated vector counts as a vector, whatever
//! its rotation depends on. As the body rotates by phi,
//!
//! ```text
//! u = R v:      p . u' = R^T p . (v' + phi x v)          phi and v in body axes
//! u = R^T v:    p . u' = R p . v' - p . (phi x u)        phi and u in body axes
//! ```

use std::collections::{HashMap, HashSet};

use crate::model::{Attitude, Frame, Meaning, Turn, Variable, Workspace};
use crate::symbolic::{Components, Id};

use super::direction::Direction;
use super::leaves::Leaves;

/// The slopes of an expression.
pub struct Slopes {
    /// Expressions that count as variables.
    leaves: HashSet<Id>,
    by_leaf: HashMap<Id, Id>,
    by_turned: Vec<(Turn, Components)>,
}

impl Slopes {
    /// The slopes along everything that moves.
    pub fn of(work: &mut Workspace, value: Id) -> Self {
        let leaves = Leaves::of(work, &[value]);
        Self::of_leaves(work, value, leaves)
    }

    /// The slopes of a value along all of its leaves.
    pub fn of_leaves(work: &mut Workspace, value: Id, leaves: Leaves) -> Self {
        let Leaves { symbols, turns } = leaves;
        let turned = turns.iter().flat_map(|turn| turn.turned);
        let turned = turned.filter(|id| !work.graph.is_early(*id));
        let leaves = symbols.into_iter().chain(turned).collect();
        let mut slopes = Self::along_leaves(work, value, leaves);
        for turn in turns.iter().rev() {
            let slope = slopes.take(work, turn);
            slopes.by_turned.push((*turn, slope));
            slopes.pass_on(work, turn, slope);
        }
        slopes
    }

    /// The slopes along these leaves only. Those along rotated vectors are not passed on.
    pub fn along_leaves(work: &mut Workspace, value: Id, leaves: HashSet<Id>) -> Self {
        let mut slopes = Self {
            leaves,
            by_leaf: HashMap::new(),
            by_turned: Vec::new(),
        };
        let one = work.graph.one();
        slopes.descend(work, &[(value, one)]);
        slopes
    }

    /// Adds the slopes of a weighted sum.
    fn descend(&mut self, work: &mut Workspace, weighted: &[(Id, Id)]) {
        let graph = &mut work.graph;
        for (leaf, slope) in graph.gradient(weighted, |id| self.leaves.contains(&id)) {
            let sum = self.by_leaf.entry(leaf).or_insert_with(|| graph.zero());
            *sum = graph.add(*sum, slope);
        }
    }

    /// Takes the slope along a rotated vector, once those of all vectors that contain it are passed
    /// on.
    pub fn take(&mut self, work: &Workspace, turn: &Turn) -> Components {
        let mut slope = self.by(work, turn.turned);
        // equal components are one leaf, whose slope counts once
        for (place, part) in slope.iter_mut().enumerate() {
            if turn.turned[..place].contains(&turn.turned[place]) {
                *part = work.graph.zero();
            }
        }
        self.by_leaf.retain(|leaf, _| !turn.turned.contains(leaf));
        slope
    }

    /// Passes the slope along a rotated vector on to what its components are made of.
    pub fn pass_on(&mut self, work: &mut Workspace, turn: &Turn, slope: Components) {
        // a vector that was rotated earlier is a leaf, too
        let is_leaf = |id: &Id| self.leaves.contains(id);
        let reached = work.graph.reachable(&turn.vector, &|id| !is_leaf(&id));
        if reached.iter().any(is_leaf) {
            let back = work.turn(slope, turn.to, turn.from);
            let weighted: Vec<(Id, Id)> = turn.vector.into_iter().zip(back).collect();
            self.descend(work, &weighted);
        }
    }

    /// The slopes along the components of a vector.
    pub fn by(&self, work: &Workspace, vector: Components) -> Components {
        vector.map(|part| self.by_symbol(work, part))
    }

    /// The slope along one symbol.
    pub fn by_symbol(&self, work: &Workspace, symbol: Id) -> Id {
        let known = self.by_leaf.get(&symbol).copied();
        known.unwrap_or(work.graph.zero())
    }

    /// The slopes along the components of a variable of the state.
    pub fn by_variable(&self, work: &Workspace, body: Frame, variable: Variable) -> Components {
        let symbol = |i: usize| work.symbol_of(Meaning::Of(body, variable, i));
        let symbols = [0, 1, 2].map(|i| symbol(i).unwrap_or(work.graph.zero()));
        self.by(work, symbols)
    }

    /// The change in one direction.
    pub fn along(&self, work: &mut Workspace, direction: &Direction) -> Id {
        let mut terms = Vec::new();
        for (turn, slope) in &self.by_turned {
            let body = work.turned_frame(turn);
            if let Some(phi) = direction.turns.get(&body) {
                let phi = work.components(*phi, body);
                terms.push(along_turned(work, phi, turn, *slope));
            }
        }
        for (symbol, change) in direction.changes.iter().rev() {
            if let Some(slope) = self.by_leaf.get(symbol) {
                terms.push(work.graph.multiply(*slope, *change));
            }
        }
        work.graph.sum(&terms)
    }
}

/// The part of the change of a rotated vector that comes from the rotation of the body.
fn along_turned(work: &mut Workspace, phi: Components, turn: &Turn, slope: Components) -> Id {
    let is_outwards = work.turned_frame(turn) == turn.from;
    let (swept, by) = match (is_outwards, work.attitude(turn.from)) {
        // about an axis, phi has the same components in both axes, and the product exists already
        (true, Attitude::Axis { .. }) => (work.graph.cross(phi, turn.turned), slope),
        (true, _) => {
            let swept = work.graph.cross(phi, turn.vector);
            (swept, work.turn(slope, turn.to, turn.from))
        }
        (false, _) => {
            let swept = work.graph.cross(phi, turn.turned);
            (work.graph.negate_vector(swept), slope)
        }
    };
    work.graph.dot(by, swept)
}
