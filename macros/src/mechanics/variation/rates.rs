//! Rates: how an expression changes as the body moves.
//!
//! ```text
//! de/dt = rate + linear . a + angular . w'
//! ```
//!
//! One sweep of the chain rule backwards gives all of it: the weight with which each part of `e`
//! enters, from `e` down to the state. A vector that was turned from one axes to the others is
//! taken as a vector, whatever its rotation is made of:
//!
//! ```text
//! u = R v:      p . u' = R^T p . (v' + w x v)          v in body axes
//! u = R^T v:    p . u' = R p . v' - p . (w x u)        u in body axes
//! ```

use std::collections::HashMap;

use crate::model::{Attitude, Axis, Frame, Meaning, Model, Turn, Variable, Workspace};
use crate::symbolic::{Components, Id, Number};

/// The derivative of an expression in time; inputs are held, unless they move.
pub struct Rates {
    /// What does not depend on the accelerations.
    pub rate: Id,
    /// Factors of the acceleration of G, world axes.
    pub linear: Components,
    /// Factors of the angular acceleration, body axes; of a rod, of that without spin, world axes.
    pub angular: Components,
}

/// The weights of a sweep, by expression.
struct Sweep<'m> {
    model: &'m Model,
    work: &'m mut Workspace,
    weights: HashMap<Id, Id>,
    rates: Vec<Id>,
    linear: Components,
    angular: Components,
    /// Factors of u'', of a rod.
    axis: Components,
}

pub fn rates(model: &Model, work: &mut Workspace, value: Id) -> Rates {
    let (order, turns) = late_parts(work, value);
    let graph = &mut work.graph;
    let (one, zeros) = (graph.one(), graph.zeros());
    let mut sweep = Sweep {
        model,
        work,
        weights: HashMap::from([(value, one)]),
        rates: Vec::new(),
        linear: zeros,
        angular: zeros,
        axis: zeros,
    };
    for &id in order.iter().rev() {
        match turns.get(&id) {
            Some((turn, last)) if *last == id => sweep.turned(turn, &turns),
            Some(_) => {}
            None => sweep.step(id),
        }
    }
    sweep.axis_by_turning();
    let (rates, linear, angular) = (sweep.rates, sweep.linear, sweep.angular);
    Rates {
        rate: sweep.work.graph.sum(&rates),
        linear,
        angular,
    }
}

/// What `value` is made of and what the vectors are made of that were turned in it, children first;
/// and these vectors.
fn late_parts(work: &Workspace, value: Id) -> (Vec<Id>, HashMap<Id, (Turn, Id)>) {
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
fn turns_within(work: &Workspace, order: &[Id]) -> HashMap<Id, (Turn, Id)> {
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

impl Sweep<'_> {
    fn add_weight(&mut self, id: Id, weight: Id) {
        let graph = &mut self.work.graph;
        if graph.is_early(id) || graph.is_zero(weight) {
            return;
        }
        let sum = match self.weights.get(&id) {
            Some(known) => graph.add(*known, weight),
            None => weight,
        };
        self.weights.insert(id, sum);
    }

    fn step(&mut self, id: Id) {
        let Some(weight) = self.weights.get(&id).copied() else {
            return;
        };
        if let Some(meaning) = self.work.meaning(id) {
            self.symbol(meaning, weight);
            return;
        }
        for (operand, part) in self.work.graph.pull_back(id, weight) {
            self.add_weight(operand, part);
        }
    }

    /// A part of the state, at last.
    fn symbol(&mut self, meaning: Meaning, weight: Id) {
        let state = &self.model.state;
        let rate = match meaning {
            Meaning::Of(_, Variable::Velocity, axis) => {
                self.linear[axis] = weight;
                return;
            }
            Meaning::Of(_, Variable::AngularVelocity, axis) => {
                self.angular[axis] = weight;
                return;
            }
            Meaning::Of(_, Variable::AxisRate, axis) => {
                self.axis[axis] = weight;
                return;
            }
            Meaning::Time => self.work.graph.one(),
            Meaning::Of(_, Variable::Position, axis) => {
                self.work.part(state.velocity, Frame::WORLD)[axis]
            }
            Meaning::Of(body, Variable::Angle, _) => {
                let rate = Meaning::Of(body, Variable::AngularVelocity, 2);
                match self.work.meanings.symbol_of(rate) {
                    Some(symbol) => self.work.graph.symbol_id(symbol),
                    None => return,
                }
            }
            Meaning::Of(_, Variable::Axis, part) => match state.axis {
                Some(axis) => axis.rate[part],
                None => return,
            },
            Meaning::Of(_, Variable::Quaternion, part) => self.quaternion_rate(part),
            Meaning::Input(input, part) => match self.model.input_rate(self.work, input, part) {
                Some(rate) => rate,
                None => return,
            },
            _ => return,
        };
        let rate = self.work.graph.multiply(weight, rate);
        self.rates.push(rate);
    }

    /// `u'' = w' x u - u'^2 u`: a weight g of u'' is one of w', `u x g`, and a rate, `-u'^2 u . g`.
    fn axis_by_turning(&mut self) {
        let Some(Axis { unit, rate }) = self.model.state.axis else {
            return;
        };
        let graph = &mut self.work.graph;
        self.angular = graph.cross(unit, self.axis);
        let along = graph.dot(unit, self.axis);
        let square = graph.norm_squared(rate);
        let held = graph.multiply(square, along);
        self.rates.push(graph.negate(held));
    }

    /// A part of `q' = q (0, w) / 2`.
    fn quaternion_rate(&mut self, part: usize) -> Id {
        let w = self.model.state.angular_velocity;
        let attitude = self.work.attitude(Frame::BODY);
        let graph = &mut self.work.graph;
        let Attitude::Quaternion { scalar, vector } = attitude else {
            return graph.zero();
        };
        let twice = if part == 0 {
            let along = graph.dot(vector, w);
            graph.negate(along)
        } else {
            let (swept, along) = (graph.cross(vector, w), graph.scale_vector(scalar, w));
            graph.add(along[part - 1], swept[part - 1])
        };
        let half = graph.number(Number::ratio(1, 2));
        graph.multiply(half, twice)
    }

    /// All components of a vector that was turned.
    fn turned(&mut self, turn: &Turn, turns: &HashMap<Id, (Turn, Id)>) {
        let zero = self.work.graph.zero();
        let weights = turn.turned.map(|id| {
            let is_own = turns
                .get(&id)
                .is_some_and(|(owner, _)| owner.turned == turn.turned && owner.to == turn.to);
            let weight = self.weights.get(&id).copied();
            weight.filter(|_| is_own).unwrap_or(zero)
        });
        let (w, plane) = (
            self.model.state.angular_velocity,
            matches!(self.work.attitude(Frame::BODY), Attitude::Axis { .. }),
        );
        let work = &mut *self.work;
        let moves = turn.vector.iter().any(|id| !work.graph.is_early(*id));
        // about an axis, w has the same components in both axes, and the result is there already
        let (swept, by) = match turn.to {
            Frame::WORLD if plane => (work.graph.cross(w, turn.turned), weights),
            Frame::WORLD => (
                work.graph.cross(w, turn.vector),
                work.turn(weights, turn.to, turn.from),
            ),
            _ => {
                let swept = work.graph.cross(w, turn.turned);
                (work.graph.negate_vector(swept), weights)
            }
        };
        let rate = work.graph.dot(by, swept);
        self.rates.push(rate);
        if moves {
            let parts = self.work.turn(weights, turn.to, turn.from);
            for (id, part) in turn.vector.into_iter().zip(parts) {
                self.add_weight(id, part);
            }
        }
    }
}
