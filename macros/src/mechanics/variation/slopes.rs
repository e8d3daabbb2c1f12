//! Slopes: by how much an expression changes in any direction of the space of states.
//!
//! One sweep of the chain rule backwards gives all of them: the weight with which each part enters,
//! from the expression down to the symbols of the state. A vector that was turned from one axes to
//! the others is taken as a vector, whatever its rotation is made of; as the body turns by phi,
//!
//! ```text
//! u = R v:      p . u' = R^T p . (v' + phi x v)          phi and v in body axes
//! u = R^T v:    p . u' = R p . v' - p . (phi x u)        phi and u in body axes
//! ```

use std::collections::HashMap;

use crate::model::{Attitude, Frame, Meaning, Turn, Workspace};
use crate::symbolic::{Components, Id};

use super::direction::Direction;

/// The slopes of an expression.
#[derive(Default)]
pub struct Slopes {
    /// Along each of its parts, symbols among them.
    by_part: HashMap<Id, Id>,
    /// Along vectors that were turned.
    by_turned: Vec<(Turn, Components)>,
}

impl Slopes {
    pub fn of(work: &mut Workspace, value: Id) -> Self {
        let (order, turns) = late_parts(work, value);
        let mut slopes = Self::default();
        let one = work.graph.one();
        slopes.add(work, value, one);
        for &id in order.iter().rev() {
            match turns.get(&id) {
                Some((turn, last)) if *last == id => slopes.pass_turned(work, turn, &turns),
                Some(_) => {}
                None => slopes.pass(work, id),
            }
        }
        slopes
    }

    pub fn add(&mut self, work: &mut Workspace, id: Id, slope: Id) {
        let graph = &mut work.graph;
        if graph.is_early(id) || graph.is_zero(slope) {
            return;
        }
        let sum = self.by_part.entry(id).or_insert_with(|| graph.zero());
        *sum = graph.add(*sum, slope);
    }

    /// Along the components of a vector.
    pub fn by(&self, work: &Workspace, vector: Components) -> Components {
        let zero = work.graph.zero();
        vector.map(|part| self.by_part.get(&part).copied().unwrap_or(zero))
    }

    /// Along what the parts of a vector of the state are.
    pub fn by_meaning(&self, work: &Workspace, meaning: fn(usize) -> Meaning) -> Components {
        let (graph, zero) = (&work.graph, work.graph.zero());
        let symbol = |i: usize| work.meanings.symbol_of(meaning(i));
        let symbols = [0, 1, 2].map(|i| symbol(i).map_or(zero, |known| graph.symbol_id(known)));
        self.by(work, symbols)
    }

    /// The change in one direction.
    pub fn along(&self, work: &mut Workspace, direction: &Direction) -> Id {
        let world = work.turn(direction.turning.world, Frame::Body);
        let phi = work.graph.add_vectors(direction.turning.body, world);
        let mut terms = Vec::new();
        for (turn, slope) in &self.by_turned {
            terms.push(along_turned(work, phi, turn, *slope));
        }
        for (symbol, change) in direction.changes.iter().rev() {
            if let Some(slope) = self.by_part.get(symbol) {
                terms.push(work.graph.multiply(*slope, *change));
            }
        }
        work.graph.sum(&terms)
    }

    fn pass(&mut self, work: &mut Workspace, id: Id) {
        if let Some(slope) = self.by_part.get(&id).copied() {
            for (operand, part) in work.graph.pull_back(id, slope) {
                self.add(work, operand, part);
            }
        }
    }

    /// All components of a vector that was turned.
    fn pass_turned(&mut self, work: &mut Workspace, turn: &Turn, turns: &Turned) {
        let is_own = |id: &Id| turns.get(id).is_some_and(|(owner, _)| owner == turn);
        let zero = work.graph.zero();
        let slope = turn.turned.map(|id| {
            let slope = self.by_part.get(&id).filter(|_| is_own(&id));
            slope.copied().unwrap_or(zero)
        });
        self.by_turned.push((*turn, slope));
        if turn.vector.iter().any(|id| !work.graph.is_early(*id)) {
            let back = work.turn(slope, turn.to.other());
            for (id, part) in turn.vector.into_iter().zip(back) {
                self.add(work, id, part);
            }
        }
    }
}

/// What of the change of a turned vector is due to the turn of the body.
fn along_turned(work: &mut Workspace, phi: Components, turn: &Turn, slope: Components) -> Id {
    let (swept, by) = match (turn.to, work.attitude) {
        // about an axis, phi has the same components in both axes, and the result is there already
        (Frame::World, Attitude::Axis { .. }) => (work.graph.cross(phi, turn.turned), slope),
        (Frame::World, _) => {
            let swept = work.graph.cross(phi, turn.vector);
            (swept, work.turn(slope, Frame::Body))
        }
        (Frame::Body, _) => {
            let swept = work.graph.cross(phi, turn.turned);
            (work.graph.negate_vector(swept), slope)
        }
    };
    work.graph.dot(by, swept)
}

/// For each component of a vector that was turned its turn, and the component that was made first,
/// at which all slopes along the vector are known.
type Turned = HashMap<Id, (Turn, Id)>;

/// What `value` is made of and what the vectors are made of that were turned in it, children first;
/// and these vectors.
fn late_parts(work: &Workspace, value: Id) -> (Vec<Id>, Turned) {
    let graph = &work.graph;
    let is_late = |id: Id| !graph.is_early(id);
    let mut roots = vec![value];
    loop {
        let mut order = graph.reachable(&roots, is_late);
        order.retain(|id| is_late(*id));
        let turns = turns_within(work, &order);
        let vectors = turns.values().flat_map(|(turn, _)| turn.vector);
        let is_new = |id: &Id| is_late(*id) && order.binary_search(id).is_err();
        let known = roots.len();
        roots.extend(vectors.filter(is_new));
        if roots.len() == known {
            return (order, turns);
        }
    }
}

/// The vectors among `order` that were turned: for each component of a result its turn, and the
/// component that was made first, at which all weights of the result are known.
fn turns_within(work: &Workspace, order: &[Id]) -> Turned {
    let graph = &work.graph;
    let mut found = HashMap::new();
    for turn in &work.turned {
        let is_there = |id: &&Id| order.binary_search(id).is_ok() && !found.contains_key(*id);
        let there: Vec<Id> = turn.turned.iter().filter(is_there).copied().collect();
        let late_parts = turn.vector.iter().filter(|id| !graph.is_early(**id)).max();
        let Some(first) = there.iter().min().copied() else {
            continue;
        };
        // what is turned was made before, or the components do not say that they were turned
        if late_parts.is_none_or(|part| *part < first) {
            found.extend(there.into_iter().map(|id| (id, (*turn, first))));
        }
    }
    found
}
