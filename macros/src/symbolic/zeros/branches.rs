//! The branches of an expression: both signs of every root, both outcomes of every condition.

use std::collections::HashMap;
use std::ops::ControlFlow;

use crate::symbolic::algebra::takes_first;
use crate::symbolic::graph::Comparison::{Equal, Less};
use crate::symbolic::graph::{Graph, Id, Node};
use crate::symbolic::number::{Function, Number, Piece};

use super::identity::{Residues, Side};

/// The most choices for which all branches are tried one by one. If there are more, a last branch is
/// tried on which the choices are symbols. What holds there holds for either sign of a root and for
/// any mixture of two sides, so it holds on all branches.
pub const MOST_CHOICES: usize = 6;

/// The choices of a branch, in the order in which they are met.
#[derive(Default)]
struct Branch {
    choices: Vec<bool>,
}

impl Branch {
    fn evaluate<T>(&mut self, mut evaluate: impl FnMut(&mut Residues<'_>) -> T) -> T {
        let mut met: HashMap<Side, bool> = HashMap::new();
        let mut side = |side: Side| {
            let place = met.len();
            let choice = met.entry(side).or_insert_with(|| {
                if place == self.choices.len() {
                    self.choices.push(false);
                }
                self.choices[place]
            });
            Some(*choice)
        };
        evaluate(&mut Residues::new(&mut side))
    }

    /// Goes on to the next branch, if there is one.
    fn advance(&mut self) -> bool {
        while self.choices.last() == Some(&true) {
            self.choices.pop();
        }
        let last = self.choices.last_mut();
        last.map(|choice| *choice = true).is_some()
    }
}

/// The result of `evaluate` on each branch. There are more than can be tried if there is one more than
/// `MOST_CHOICES` have.
pub fn on_branches<T>(mut evaluate: impl FnMut(&mut Residues<'_>) -> T) -> Vec<T> {
    let mut branch = Branch::default();
    let mut values = vec![branch.evaluate(&mut evaluate)];
    while branch.advance() {
        if values.len() == 1 << MOST_CHOICES {
            values.push(evaluate(&mut Residues::new(&mut |_| None)));
            break;
        }
        values.push(branch.evaluate(&mut evaluate));
    }
    values
}

/// Evaluates on one branch after the other, until `evaluate` breaks off. Where not all can be tried,
/// the one on which choices are symbols stands for all that follow.
pub fn until_decided(mut evaluate: impl FnMut(&mut Residues<'_>) -> ControlFlow<()>) {
    let mut branch = Branch::default();
    while branch.evaluate(&mut evaluate).is_continue() {
        if branch.choices.len() > MOST_CHOICES {
            let _ = evaluate(&mut Residues::new(&mut |_| None));
            return;
        }
        if !branch.advance() {
            return;
        }
    }
}

impl Graph {
    /// A condition that decides between two sides of `roots`, and is inside of no other side.
    pub fn outermost_condition(&mut self, roots: &[Id]) -> Option<Id> {
        let mut nodes = self.nodes_of(roots).into_iter().rev();
        nodes.find_map(|id| Some(self.sides(id)?.0))
    }

    /// `roots` where a condition holds, or where it does not.
    pub fn on_side(&mut self, roots: &[Id], decided: Id, holds: bool) -> Vec<Id> {
        self.rebuild(roots, |graph, id, image| match graph.sides(id) {
            Some((condition, first, second)) if condition == decided => {
                image(if holds { first } else { second })
            }
            _ => graph.remake(id, image),
        })
    }

    /// Expressions with the pieces of their functions as sides of conditions, where a piece is
    /// simpler than the function: of `abs`, `signum` and tables; `floor` and `ceil` where they are zero,
    /// or equal to a number that is next to them.
    pub fn in_pieces(&mut self, roots: &[Id]) -> Vec<Id> {
        let steps = self.steps(roots);
        self.rebuild(roots, |graph, id, image| {
            // conditions stay as they are, and so does what they read
            if matches!(graph.node(id), Node::Compare(..)) {
                return id;
            }
            let whole = graph.remake(id, image);
            let zero = graph.zero();
            match *graph.node(whole) {
                // by the sign, in which zero has that of its bit
                Node::Unary(function @ (Function::Abs | Function::Signum), a) => {
                    let sign = graph.apply(Function::Signum, &[a]);
                    let is_negative = graph.compare(Less, sign, zero);
                    let [negative, positive] = match function {
                        Function::Abs => [graph.negate(a), a],
                        _ => [-1, 1].map(|sign| graph.integer(sign)),
                    };
                    graph.select(is_negative, negative, positive)
                }
                Node::Unary(Function::Floor | Function::Ceil, _) => {
                    let own = steps.iter().filter(|(step, _)| *step == id);
                    let values = own.map(|(_, value)| *value);
                    [zero].into_iter().chain(values).fold(whole, |rest, value| {
                        let is_there = graph.compare(Equal, whole, value);
                        graph.select(is_there, value, rest)
                    })
                }
                Node::Binary(Function::Table, x, table) => graph.with_flat_pieces(whole, x, table),
                _ => whole,
            }
        })
    }

    /// Each `floor` and `ceil` in `roots`, with the numbers whose difference or sum with a multiple of it
    /// is zero on one step.
    fn steps(&mut self, roots: &[Id]) -> Vec<(Id, Id)> {
        let mut steps = Vec::new();
        for id in self.nodes_of(roots) {
            let (a, b, sign) = match *self.node(id) {
                Node::Add(a, b) => (a, b, -1),
                Node::Subtract(a, b) | Node::Compare(_, a, b) => (a, b, 1),
                _ => continue,
            };
            for (multiple, number) in [(a, b), (b, a)] {
                let number = self.as_number(number).cloned();
                if let (Some((step, factor)), Some(number)) = (self.step(multiple), number) {
                    let value = (Number::integer(sign) * number).checked_div(&factor);
                    let value = value.and_then(|value| value.to_integer());
                    steps.extend(value.map(|value| (step, self.integer(value))));
                }
            }
        }
        steps
    }

    /// A `floor` or `ceil`, and the number by which it is multiplied.
    fn step(&self, multiple: Id) -> Option<(Id, Number)> {
        match *self.node(multiple) {
            Node::Unary(Function::Floor | Function::Ceil, _) => Some((multiple, Number::one())),
            Node::Quantity(a) => self.step(a),
            Node::Negate(a) => self.step(a).map(|(step, factor)| (step, -factor)),
            Node::Multiply(a, b) => {
                let (number, other) = match self.as_number(a) {
                    Some(number) => (number, b),
                    None => (self.as_number(b)?, a),
                };
                let (step, factor) = self.step(other)?;
                Some((step, factor * number.clone()))
            }
            _ => None,
        }
    }

    /// Whether some functions in `roots` are made of pieces.
    pub fn has_pieces(&self, roots: &[Id]) -> bool {
        self.nodes_of(roots).into_iter().any(|id| {
            matches!(
                self.node(id),
                Node::Select(..)
                    | Node::Unary(Function::Floor | Function::Ceil, _)
                    | Node::Binary(Function::Min | Function::Max | Function::Table, ..)
                    | Node::Foreign(..)
            )
        })
    }

    /// The value of a table at `x`, piece by piece, with its constants.
    fn with_flat_pieces(&mut self, whole: Id, x: Id, table: Id) -> Id {
        let pieces = self.table(table).map_or(Vec::new(), |table| table.pieces);
        let mut value = None;
        let mut end = None;
        for Piece {
            start,
            coefficients,
        } in pieces.into_iter().rev()
        {
            let is_flat = coefficients.iter().skip(1).all(Number::is_zero);
            let constant = coefficients.into_iter().next();
            let piece = if is_flat {
                self.number(constant.unwrap_or_else(Number::zero))
            } else {
                whole
            };
            value = Some(match (value, end) {
                (Some(beyond), Some(end)) => {
                    let is_below = self.compare(Less, x, end);
                    self.select(is_below, piece, beyond)
                }
                _ => piece,
            });
            end = Some(self.number(start));
        }
        value.unwrap_or(whole)
    }

    /// A condition, the expression where it holds, and the expression where it does not.
    fn sides(&mut self, id: Id) -> Option<(Id, Id, Id)> {
        match *self.node(id) {
            Node::Select(condition, first, second) => Some((condition, first, second)),
            Node::Binary(function @ (Function::Min | Function::Max), a, b) => {
                Some((takes_first(self, function, &a, &b), a, b))
            }
            _ => None,
        }
    }
}
