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
use crate::symbolic::{Components, Function, Graph, Id, Node, Number};

use super::samples::{MIXED, at_state};

/// Directions about which a turn changes nothing; a group of turns has no other sets of them.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Symmetry {
    None,
    About([f64; 3]),
    Every,
}

/// Directions, spanned by vectors that are independent.
pub struct Space {
    pub basis: Vec<[Number; 3]>,
}

impl Space {
    fn spanned_by(axes: &[usize]) -> Self {
        let unit = |axis: usize| [0, 1, 2].map(|i| Number::integer(i64::from(i == axis)));
        Self {
            basis: axes.iter().map(|axis| unit(*axis)).collect(),
        }
    }

    /// Leaves the directions that are perpendicular to `normal`; whether these are fewer.
    fn cut(&mut self, normal: &[Number; 3]) -> bool {
        let dot = |vector: &[Number; 3]| {
            let products = vector.iter().zip(normal);
            products.fold(Number::zero(), |sum, (a, b)| sum + a.clone() * b.clone())
        };
        let values: Vec<Number> = self.basis.iter().map(dot).collect();
        let Some(pivot) = values.iter().position(|value| !value.is_zero()) else {
            return false;
        };
        let removed = self.basis.remove(pivot);
        let kept = values
            .iter()
            .enumerate()
            .filter(|(index, _)| *index != pivot);
        for (vector, (_, value)) in self.basis.iter_mut().zip(kept) {
            let factor = value
                .checked_div(&values[pivot])
                .unwrap_or_else(Number::zero);
            for (part, of_removed) in vector.iter_mut().zip(&removed) {
                *part = part.clone() - factor.clone() * of_removed.clone();
            }
        }
        true
    }

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
    let mut cases = [
        Case::new(model, linear, &world, true, axes),
        Case::new(model, linear, &body, false, of_body),
        Case::new(model, angular, &world, is_rod, axes),
        Case::new(model, angular, &body, !is_rod, of_body),
    ];
    settle(model, &mut cases, 1);
    // what may also be so for numbers of one sign alone
    for case in &mut cases {
        case.is_settled = case.space.basis.is_empty();
    }
    settle(model, &mut cases, MIXED + 1);
    let [first, second, third, fourth] = cases.map(|case| case.space);
    [[first, second], [third, fourth]]
}

/// Cuts what is not settled, by the changes at states from the one of this number on.
fn settle(model: &mut Model, cases: &mut [Case], first: i64) {
    for seed in first.. {
        if cases.iter().all(|case| case.is_settled) {
            return;
        }
        cut(model, cases, seed);
    }
}

fn cut(model: &mut Model, cases: &mut [Case], seed: i64) {
    let open = cases.iter_mut().filter(|case| !case.is_settled);
    let open: Vec<&mut Case> = open.collect();
    let changes: Vec<Id> = open.iter().flat_map(|case| case.changes.concat()).collect();
    let mut values = at_state(model, &changes, seed).into_iter();
    for case in open {
        let mut changes = case.changes.each_ref().map(|changes| {
            let values = values.by_ref().take(changes.len());
            values.collect::<Vec<_>>().into_iter()
        });
        let mut is_less = false;
        while let [Some(x), Some(y), Some(z)] = changes.each_mut().map(Iterator::next) {
            match (x, y, z) {
                (Some(x), Some(y), Some(z)) => is_less |= case.space.cut(&[x, y, z]),
                // a root of what is negative there says nothing
                _ if seed > MIXED => {}
                // what has no value is not known to be symmetric
                _ => case.space.basis.clear(),
            }
        }
        case.is_settled = !is_less || case.space.basis.is_empty();
    }
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

/// How symbols change.
type Rates = HashMap<Id, Id>;

/// Whether turns about the three axes change a vector, and what decides between its branches.
struct Case {
    /// What changes but does not turn, for each axis.
    changes: [Vec<Id>; 3],
    /// What is left of the directions.
    space: Space,
    /// A state has left all of it.
    is_settled: bool,
}

impl Case {
    /// `turns`: whether the axes are turned in which the vector is written.
    fn new(
        model: &mut Model,
        vector: &Components,
        rates: &[Rates; 3],
        turns: bool,
        axes: &[usize],
    ) -> Self {
        let space = Space::spanned_by(axes);
        let graph = &mut model.frames.graph;
        if axes.is_empty() {
            return Self {
                changes: [const { Vec::new() }; 3],
                space,
                is_settled: true,
            };
        }
        let guards = guards(graph, vector);
        let roots: Vec<Id> = vector.iter().copied().chain(guards).collect();
        let roots = graph.unbranched(&roots);
        let vector = [roots[0], roots[1], roots[2]];
        let changes = [0, 1, 2].map(|axis| {
            let mut changes = graph.change(&roots, |symbol| rates[axis].get(&symbol).copied());
            if turns {
                let e = unit_vector(graph, axis);
                let swept = graph.cross(e, vector);
                for (change, swept) in changes.iter_mut().zip(swept) {
                    *change = graph.subtract(*change, swept);
                }
            }
            changes
        });
        Self {
            changes,
            space,
            is_settled: false,
        }
    }
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
