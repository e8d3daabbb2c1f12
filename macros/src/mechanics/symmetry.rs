//! Turns of the world, and of the axes of a body, that leave an acceleration as it is.
//!
//! Turning by a small angle about e changes a state along
//!
//! ```text
//! the world    x' = e x x    v' = e x v    q' = (0, e) q / 2
//! the body     w' = e x w    q' = -q (0, e) / 2
//! ```
//!
//! and an acceleration is symmetric about e if it changes as the axes do in which it is written. That is
//! linear in e: what is left of all directions after a few states, where all numbers are exact, is left
//! after all of them. Nothing of this is emitted but the answer.

use std::collections::HashMap;

use crate::model::{Attitude, Model, Motion};
use crate::symbolic::{
    Algebra, Components, Doubles, Exact, Function, Graph, Id, Node, Number, Residue, Residues, Tape,
};

use super::samples::{Range, SIGNS, at_state};

/// Directions about which a turn changes nothing; a group of turns has no other sets of them.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Symmetry {
    None,
    About([f64; 3]),
    Every,
}

/// Directions, spanned by vectors that are independent.
pub struct Space<V = Number> {
    pub basis: Vec<[V; 3]>,
}

impl<V: Clone> Space<V> {
    fn spanned_by<A: Algebra<Value = V>>(algebra: &mut A, axes: &[usize]) -> Self {
        let (zero, one) = (algebra.zero(), algebra.one());
        let unit = |axis: usize| [0, 1, 2].map(|i| if i == axis { &one } else { &zero }.clone());
        Self {
            basis: axes.iter().map(|axis| unit(*axis)).collect(),
        }
    }

    /// Leaves the directions that are perpendicular to `normal`; whether these are fewer for certain.
    fn cut<A: Algebra<Value = V>>(&mut self, algebra: &mut A, normal: &[V; 3]) -> bool {
        let mut dot = |vector: &[V; 3]| {
            let [x, y, z] = [0, 1, 2].map(|i| algebra.multiply(&vector[i], &normal[i]));
            let sum = algebra.add(&x, &y);
            algebra.add(&sum, &z)
        };
        let mut values: Vec<V> = self.basis.iter().map(&mut dot).collect();
        let Some(pivot) = values.iter().position(|value| algebra.is_not_zero(value)) else {
            return false;
        };
        let (removed, divisor) = (self.basis.remove(pivot), values.remove(pivot));
        for (vector, value) in self.basis.iter_mut().zip(&values) {
            let factor = algebra.divide(value, &divisor);
            for (part, of_removed) in vector.iter_mut().zip(&removed) {
                let along = algebra.multiply(&factor, of_removed);
                *part = algebra.subtract(part, &along);
            }
        }
        true
    }
}

impl Space<Option<Number>> {
    fn numbers(self) -> Space {
        let known = |part: Option<Number>| part.unwrap_or_else(Number::zero);
        let basis = self.basis.into_iter();
        Space {
            basis: basis.map(|vector| vector.map(known)).collect(),
        }
    }
}

impl Space {
    pub fn symmetry(&self) -> Symmetry {
        match self.basis.as_slice() {
            [_, _, _] => Symmetry::Every,
            _ => self.axis().map_or(Symmetry::None, |axis| {
                Symmetry::About(axis.map(|part| part.to_f64()))
            }),
        }
    }

    /// The unit vector along the only direction, its first component that is not zero positive.
    pub fn axis(&self) -> Option<[Number; 3]> {
        match self.basis.as_slice() {
            [direction] => unit(direction),
            _ => None,
        }
    }
}

fn unit(direction: &[Number; 3]) -> Option<[Number; 3]> {
    let square = direction.iter().fold(Number::zero(), |sum, part| {
        sum + part.clone() * part.clone()
    });
    let length = Number::apply(Function::Sqrt, &[square])?;
    let leads_with_minus = direction.iter().find(|part| !part.is_zero())?.is_negative();
    let length = if leads_with_minus { -length } else { length };
    let [x, y, z] = direction
        .each_ref()
        .map(|part| part.clone().checked_div(&length));
    Some([x?, y?, z?])
}

/// The directions about which the world, and the axes of the body, may be turned: of the linear
/// acceleration, and of the angular one.
pub fn symmetries(model: &mut Model, linear: &Components, angular: &Components) -> [[Space; 2]; 2] {
    let is_rod = model.motion == Motion::Rod;
    let axes: &[usize] = match model.motion {
        Motion::Pivot | Motion::FixedAxis => &[],
        Motion::Planar | Motion::PlanarTranslation => &[2],
        _ => &[0, 1, 2],
    };
    let of_body = if is_rod { &[] } else { axes };
    let world = [0, 1, 2].map(|axis| turn_of_world(model, axis));
    let body = [0, 1, 2].map(|axis| turn_of_body(model, axis));
    // the linear acceleration, and that of the axis of a rod, are written in world axes
    [(linear, true), (angular, is_rod)].map(|(vector, is_in_world)| {
        let roots = roots(&mut model.frames.graph, vector);
        [(&world, is_in_world, axes), (&body, !is_in_world, of_body)].map(|(rates, turns, axes)| {
            let case = Case {
                model,
                roots: &roots,
                rates,
                turns,
                axes,
            };
            case.space()
        })
    })
}

/// What decides between branches, and the arguments of functions that are made of pieces: where these
/// stay as they are, so does the branch.
fn guards(graph: &mut Graph, roots: &[Id]) -> Vec<Id> {
    let mut guards = Vec::new();
    for id in graph.reachable(roots, |_| true) {
        match *graph.node(id) {
            Node::Compare(_, a, b) => guards.push(graph.subtract(a, b)),
            Node::Unary(function, a) if function.is_piecewise() => guards.push(a),
            Node::Binary(function, a, b) if function.is_piecewise() => guards.extend([a, b]),
            _ => {}
        }
    }
    guards
}

/// The components of a vector, and what decides between its branches, without them.
fn roots(graph: &mut Graph, vector: &Components) -> Vec<Id> {
    let guards = guards(graph, vector);
    let roots: Vec<Id> = vector.iter().copied().chain(guards).collect();
    graph.unbranched(&roots)
}

/// How symbols change.
type Rates = HashMap<Id, Id>;

/// Whether turns about the three axes change a vector, and what decides between its branches.
struct Case<'a> {
    model: &'a Model,
    /// The vector first.
    roots: &'a [Id],
    rates: &'a [Rates; 3],
    /// Whether the axes are turned in which the vector is written.
    turns: bool,
    /// Those about which there may be turns.
    axes: &'a [usize],
}

impl Case<'_> {
    /// What residues leave is left, and what doubles cut is not; where they disagree, exact numbers
    /// decide.
    fn space(&self) -> Space {
        if self.axes.is_empty() {
            return Space { basis: Vec::new() };
        }
        let rates = self.rates.iter().flat_map(|rates| rates.values().copied());
        let all: Vec<Id> = self.roots.iter().copied().chain(rates).collect();
        let tape = self.model.frames.graph.tape(&all);
        let mut residues = Residues::default();
        let formal = Space::spanned_by(&mut residues, self.axes);
        let (formal, is_known) = self.settled(&tape, &mut residues, Range::Integers, formal);
        let is_left = |formal: &Space<_>, has_signs: bool| {
            let possible = Space::spanned_by(&mut Doubles, self.axes);
            let (mut possible, _) = self.settled(&tape, &mut Doubles, Range::Positive, possible);
            // residues do not know the sign of a root
            if has_signs {
                (possible, _) = self.settled(&tape, &mut Doubles, Range::Mixed, possible);
            }
            possible.basis.len() == formal.basis.len()
        };
        if is_known
            && let Some(space) = rational(&formal, &mut residues)
            && is_left(&formal, !residues.is_final())
        {
            return space;
        }
        let space = Space::spanned_by(&mut Exact, self.axes);
        let (space, is_known) = self.settled(&tape, &mut Exact, Range::Positive, space);
        // what has no value is not known to be symmetric
        if !is_known {
            return Space { basis: Vec::new() };
        }
        // what may be so for numbers of one sign alone; a root of what is negative says nothing
        let (space, _) = self.settled(&tape, &mut Exact, Range::Mixed, space);
        space.numbers()
    }

    /// What the changes at one state after the other leave, until one leaves all; whether they all have values.
    fn settled<A: Algebra>(
        &self,
        tape: &Tape<'_>,
        algebra: &mut A,
        range: Range,
        mut space: Space<A::Value>,
    ) -> (Space<A::Value>, bool) {
        let mut is_known = true;
        let least = if range == Range::Mixed { SIGNS } else { 1 };
        for seed in 1.. {
            let mut is_less = false;
            for normal in self.changes(tape, algebra, range, seed) {
                is_known &= normal
                    .iter()
                    .all(|part| algebra.is_zero(part) || algebra.is_not_zero(part));
                is_less |= space.cut(algebra, &normal);
            }
            if (!is_less && seed >= least) || space.basis.is_empty() {
                break;
            }
        }
        (space, is_known)
    }

    /// What of each root changes but does not turn, for each axis.
    fn changes<A: Algebra>(
        &self,
        tape: &Tape<'_>,
        algebra: &mut A,
        range: Range,
        seed: u64,
    ) -> Vec<[A::Value; 3]> {
        let values = at_state(self.model, tape, algebra, range, seed);
        let zero = algebra.zero();
        let turned = [0, 1, 2].map(|axis| {
            let rate = |symbol: Id| {
                let rate = self.rates[axis].get(&symbol)?;
                Some(tape.of(&values, *rate).clone())
            };
            tape.changes(algebra, &values, rate)
        });
        let change = |root: &Id| {
            let changes = turned.each_ref().map(|changes| tape.of(changes, *root));
            changes.map(|change| change.clone().unwrap_or_else(|| zero.clone()))
        };
        let mut changes: Vec<[A::Value; 3]> = self.roots.iter().map(change).collect();
        if self.turns {
            // less e x a
            for (i, j, k) in [(0, 1, 2), (1, 2, 0), (2, 0, 1)] {
                let part = |i: usize| tape.of(&values, self.roots[i]);
                changes[j][i] = algebra.add(&changes[j][i], part(k));
                changes[k][i] = algebra.subtract(&changes[k][i], part(j));
            }
        }
        changes
    }
}

/// The same directions in numbers, if these are short.
fn rational(formal: &Space<Option<Residue>>, residues: &mut Residues) -> Option<Space> {
    let mut basis = Vec::new();
    for direction in &formal.basis {
        let lead = direction.iter().find(|part| residues.is_not_zero(part))?;
        let ratios = direction.each_ref().map(|part| residues.divide(part, lead));
        let [x, y, z] = ratios.map(|ratio| ratio?.to_number());
        basis.push([x?, y?, z?]);
    }
    Some(Space { basis })
}

/// How the state changes as the world is turned about an axis.
fn turn_of_world(model: &mut Model, axis: usize) -> Rates {
    let (graph, state) = (&mut model.frames.graph, &model.state);
    let e = unit_vector(graph, axis);
    let mut rates = Rates::new();
    let vectors = if model.motion.translates() {
        vec![state.position.world, state.velocity.world]
    } else {
        Vec::new()
    };
    let of_axis = state.axis.map(|axis| [axis.unit, axis.rate]);
    for vector in vectors.into_iter().chain(of_axis.into_iter().flatten()) {
        rates.extend(vector.into_iter().zip(graph.cross(e, vector)));
    }
    match model.frames.attitude {
        Attitude::Axis { angle, .. } => {
            rates.insert(angle, e[2]);
        }
        Attitude::Quaternion { scalar, vector } => {
            let half = graph.number(Number::ratio(1, 2));
            let e = graph.scale_vector(half, e);
            let along = graph.dot(e, vector);
            rates.insert(scalar, graph.negate(along));
            let (kept, swept) = (graph.scale_vector(scalar, e), graph.cross(e, vector));
            rates.extend(vector.into_iter().zip(graph.add_vectors(kept, swept)));
        }
        Attitude::Fixed | Attitude::Line { .. } => {}
    }
    of_symbols(graph, rates)
}

/// How the state changes as the axes of the body are turned back about one of them.
fn turn_of_body(model: &mut Model, axis: usize) -> Rates {
    let (graph, state) = (&mut model.frames.graph, &model.state);
    let e = unit_vector(graph, axis);
    let w = state.angular_velocity;
    let mut rates: Rates = w.into_iter().zip(graph.cross(e, w)).collect();
    match model.frames.attitude {
        Attitude::Axis { angle, .. } => {
            rates.insert(angle, graph.negate(e[2]));
        }
        Attitude::Quaternion { scalar, vector } => {
            let half = graph.number(Number::ratio(1, 2));
            let e = graph.scale_vector(half, e);
            rates.insert(scalar, graph.dot(vector, e));
            let (kept, swept) = (graph.scale_vector(scalar, e), graph.cross(e, vector));
            rates.extend(vector.into_iter().zip(graph.subtract_vectors(swept, kept)));
        }
        Attitude::Fixed | Attitude::Line { .. } => {}
    }
    of_symbols(graph, rates)
}

fn unit_vector(graph: &mut Graph, axis: usize) -> Components {
    [0, 1, 2].map(|i| graph.integer(i64::from(i == axis)))
}

/// What a motion does not have is zero and stays so.
fn of_symbols(graph: &Graph, mut rates: Rates) -> Rates {
    rates.retain(|id, _| matches!(graph.node(*id), Node::Symbol(_)));
    rates
}
