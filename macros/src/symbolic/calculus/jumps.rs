//! Jumps of functions of time at times that are numbers: at conditions on time, steps, and the knots
//! of tables.

use std::cmp::Ordering;
use std::collections::BTreeMap;

use crate::symbolic::graph::{Graph, Id, Node};
use crate::symbolic::number::{Function, Number};

/// A time at which functions jump, and the values of each before and after.
pub struct Jump {
    pub at: Number,
    pub sides: Vec<[Id; 2]>,
}

/// One side of a time.
struct Side<'a> {
    time: Id,
    at: &'a Number,
    is_after: bool,
    /// The values of nodes there; `None` if they are not known.
    known: BTreeMap<Id, Option<Id>>,
}

impl Graph {
    /// The values of `roots` on both sides of each time at which a part of them may jump, if these
    /// are known. Only parts that depend on time linearly, by a number, give such times, and the
    /// ends of tables that hold their last values give none: motions may end there.
    pub fn jumps(&mut self, roots: &[Id], time: Id) -> Vec<Jump> {
        let mut times: Vec<Number> = Vec::new();
        for id in self.nodes_of(roots) {
            for at in self.times(id, time) {
                if at.is_positive() && !at.is_undecided() && !times.contains(&at) {
                    times.push(at);
                }
            }
        }
        let jumps = times.into_iter().filter_map(|at| {
            let both = [false, true].map(|is_after| {
                let mut side = Side {
                    time,
                    at: &at,
                    is_after,
                    known: BTreeMap::new(),
                };
                let values = roots.iter().map(|root| side.value(self, *root));
                values.collect::<Option<Vec<Id>>>()
            });
            let [before, after] = both;
            let sides = before?.into_iter().zip(after?);
            let sides = sides.map(|(before, after)| [before, after]).collect();
            Some(Jump { at, sides })
        });
        jumps.collect()
    }

    /// Whether an expression is a product of numbers and symbols.
    pub fn is_product(&self, id: Id) -> bool {
        let mut parts = self.nodes_of(&[id]).into_iter();
        parts.all(|part| match *self.node(part) {
            Node::Number(ref number) => !number.is_zero() && !number.is_undecided(),
            Node::Symbol(_)
            | Node::Multiply(..)
            | Node::Divide(..)
            | Node::Negate(_)
            | Node::Quantity(_) => true,
            _ => false,
        })
    }

    /// The times at which a node by itself may jump.
    fn times(&mut self, id: Id, time: Id) -> Vec<Number> {
        let (argument, values) = match *self.node(id) {
            Node::Compare(_, a, b) => (self.subtract(a, b), vec![Number::zero()]),
            Node::Unary(Function::Signum, a) => (a, vec![Number::zero()]),
            // they jump alike at all integers
            Node::Unary(Function::Floor | Function::Ceil, a) => {
                (a, [-1, 0, 1].map(Number::integer).to_vec())
            }
            Node::Binary(Function::Table, a, table) => {
                let pieces = self.table(table).map_or(Vec::new(), |table| table.pieces);
                let inner = pieces.windows(2).filter(|pair| {
                    let mut pieces = pair.iter();
                    let [below, above] = [0, 1].map(|side| pair[side].value(&pair[1].start));
                    // a piece that holds a value has no coefficients in the derivative
                    pieces.all(|piece| !piece.coefficients.is_empty()) && below != above
                });
                (a, inner.map(|pair| pair[1].start.clone()).collect())
            }
            _ => return Vec::new(),
        };
        let slope = self.derivative(&[argument], time)[0];
        let zero = self.zero();
        let start = self.substitute(&[argument], |id| (id == time).then_some(zero))[0];
        let (Some(slope), Some(start)) = (self.as_number(slope), self.as_number(start)) else {
            return Vec::new();
        };
        let (slope, start) = (slope.clone(), start.clone());
        let times = values.into_iter();
        let times = times.filter_map(|value| (value - start.clone()).checked_div(&slope));
        times.collect()
    }
}

impl Side<'_> {
    /// The value of an expression on this side.
    fn value(&mut self, graph: &mut Graph, root: Id) -> Option<Id> {
        for id in graph.nodes_of(&[root]) {
            if !self.known.contains_key(&id) {
                let value = self.of_node(graph, id);
                self.known.insert(id, value);
            }
        }
        self.known[&root]
    }

    fn of_node(&mut self, graph: &mut Graph, id: Id) -> Option<Id> {
        if id == self.time {
            return Some(graph.number(self.at.clone()));
        }
        let node = graph.node(id).clone();
        if !node
            .operands()
            .all(|operand| self.known[&operand].is_some())
        {
            return None;
        }
        match node {
            Node::Compare(comparison, a, b) => {
                let difference = graph.subtract(a, b);
                match self.order(graph, difference, &Number::zero())? {
                    Some(order) => Some(graph.truth(comparison.holds(order))),
                    None => Some(self.remade(graph, id)),
                }
            }
            Node::Unary(Function::Signum, a) => match self.order(graph, a, &Number::zero())? {
                Some(order) => Some(graph.integer(if order.is_lt() { -1 } else { 1 })),
                None => Some(self.remade(graph, id)),
            },
            Node::Unary(function @ (Function::Floor | Function::Ceil), a) => {
                let value = self.number(graph, a)?;
                let Some(whole) = value.to_integer() else {
                    return Some(self.remade(graph, id));
                };
                let is_above = self.order(graph, a, &value)??.is_gt();
                let lower = whole - i64::from(function == Function::Floor);
                Some(graph.integer(lower + i64::from(is_above)))
            }
            Node::Binary(Function::Table, a, table) => {
                let value = self.number(graph, a)?;
                let pieces = graph.table(table)?.pieces;
                let Some(knot) = pieces.iter().skip(1).position(|piece| piece.start == value)
                else {
                    return Some(self.remade(graph, id));
                };
                let is_above = self.order(graph, a, &value)??.is_gt();
                let piece = &pieces[knot + usize::from(is_above)];
                Some(graph.number(piece.value(&value)))
            }
            _ => Some(self.remade(graph, id)),
        }
    }

    fn remade(&self, graph: &mut Graph, id: Id) -> Id {
        graph.remake(id, &|operand| self.known[&operand].unwrap_or(operand))
    }

    fn number(&self, graph: &Graph, a: Id) -> Option<Number> {
        let number = graph.as_number(self.known[&a]?)?;
        (!number.is_undecided()).then(|| number.clone())
    }

    /// How an expression compares with a value on this side, if it has this value at the time.
    /// The outer `None` means that this is not known.
    #[allow(
        clippy::option_option,
        reason = "outer: not known; inner: it has another value"
    )]
    fn order(&mut self, graph: &mut Graph, a: Id, value: &Number) -> Option<Option<Ordering>> {
        let there = self.value(graph, a)?;
        let there = graph.as_number(there)?.clone();
        if there.is_undecided() {
            return None;
        }
        if there != *value {
            return Some(None);
        }
        let slope = graph.derivative(&[a], self.time)[0];
        let slope = self.value(graph, slope)?;
        let slope = graph.as_number(slope)?;
        if slope.is_zero() || slope.is_undecided() {
            return None;
        }
        let is_above = slope.is_positive() == self.is_after;
        Some(Some(if is_above {
            Ordering::Greater
        } else {
            Ordering::Less
        }))
    }
}
