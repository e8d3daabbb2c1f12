//! Jumps of functions of time, at conditions on time and at the knots of tables.

use std::cmp::Ordering;

use crate::symbolic::graph::{Graph, Id, Node};
use crate::symbolic::number::{Function, Number};

/// A time at which functions may jump, and the change of each.
pub struct Jump {
    pub at: Id,
    pub by: Vec<Id>,
}

/// A node, with its values before and after a time.
type Sides = (Id, [Id; 2]);

impl Graph {
    /// The jumps of `roots` where a condition, a sign or a table depends on `time` linearly, by a
    /// number, and where that time is known early. Others are left out. The ends of a table that
    /// holds its last value are none: a motion may end there.
    pub fn jumps(&mut self, roots: &[Id], time: Id) -> Vec<Jump> {
        let mut places: Vec<(Id, Vec<Sides>)> = Vec::new();
        for id in self.reachable(roots, |_| true) {
            for (at, sides) in self.around(id, time) {
                match places.iter_mut().find(|(known, _)| *known == at) {
                    Some((_, all)) => all.push((id, sides)),
                    None => places.push((at, vec![(id, sides)])),
                }
            }
        }
        let jumps = places.into_iter().map(|(at, nodes)| {
            let [before, after] = [0, 1].map(|side| {
                self.rebuild(roots, |graph, id, image| {
                    let known = nodes.iter().find(|(node, _)| *node == id);
                    match known {
                        Some((_, sides)) => sides[side],
                        None if id == time => at,
                        None => graph.remake(id, image),
                    }
                })
            });
            let sides = after.into_iter().zip(before);
            let by = sides.map(|(after, before)| self.subtract(after, before));
            Jump {
                at,
                by: by.collect(),
            }
        });
        jumps.collect()
    }

    /// The times at which a node by itself may jump, each with its values before and after.
    fn around(&mut self, id: Id, time: Id) -> Vec<(Id, [Id; 2])> {
        match *self.node(id) {
            Node::Compare(comparison, a, b) => {
                let difference = self.subtract(a, b);
                let zero = Number::zero();
                let crossing = self.crossing(difference, &zero, time);
                let both = crossing.map(|(at, orders)| {
                    let truths = orders.map(|order| comparison.holds(order));
                    (at, truths.map(|truth| self.truth(truth)))
                });
                both.into_iter().collect()
            }
            Node::Unary(Function::Signum, a) => {
                let crossing = self.crossing(a, &Number::zero(), time);
                let both = crossing.map(|(at, orders)| {
                    (
                        at,
                        orders.map(|order| self.integer(if order.is_lt() { -1 } else { 1 })),
                    )
                });
                both.into_iter().collect()
            }
            Node::Unary(function @ (Function::Floor | Function::Ceil), a) => {
                // they jump alike at all integers
                let integers = [-1, 0, 1].into_iter();
                let all = integers.filter_map(|integer| {
                    let number = Number::integer(integer);
                    let (at, orders) = self.crossing(a, &number, time)?;
                    let lower = integer - i64::from(function == Function::Floor);
                    let value = |order: Ordering| lower + i64::from(order.is_gt());
                    Some((at, orders.map(|order| self.integer(value(order)))))
                });
                all.collect()
            }
            Node::Binary(Function::Table, a, table) => self.around_knots(a, table, time),
            _ => Vec::new(),
        }
    }

    /// The times at which the argument of a table passes a knot where its pieces differ.
    fn around_knots(&mut self, argument: Id, table: Id, time: Id) -> Vec<(Id, [Id; 2])> {
        let pieces = self.table(table).map_or(Vec::new(), |table| table.pieces);
        let last = pieces.len().saturating_sub(2);
        let mut all = Vec::new();
        for (place, pair) in pieces.windows(2).enumerate() {
            let [below, above] = pair else { continue };
            let values = [below, above].map(|piece| piece.value(&above.start));
            let is_end = place == 0 && below.is_zero() || place == last && above.is_zero();
            if is_end || values[0] == values[1] {
                continue;
            }
            if let Some((at, orders)) = self.crossing(argument, &above.start, time) {
                let value = |order: Ordering| &values[usize::from(order.is_gt())];
                all.push((at, orders.map(|order| self.number(value(order).clone()))));
            }
        }
        all
    }

    /// When an expression passes a value, and how they compare before and after.
    fn crossing(&mut self, a: Id, value: &Number, time: Id) -> Option<(Id, [Ordering; 2])> {
        let [slope] = self.derivative(&[a], time)[..] else {
            return None;
        };
        let number = self.as_number(slope).filter(|slope| !slope.is_zero())?;
        let mut orders = [Ordering::Less, Ordering::Greater];
        if number.is_negative() {
            orders.reverse();
        }
        let zero = self.zero();
        let [start] = self.substitute(&[a], |id| (id == time).then_some(zero))[..] else {
            return None;
        };
        let value = self.number(value.clone());
        let rest = self.subtract(value, start);
        let at = self.divide(rest, slope);
        // steps such as `floor` have the slope zero
        let there = self.substitute(&[a], |id| (id == time).then_some(at))[0];
        let left = self.subtract(there, value);
        (self.is_early(at) && self.vanishes(left)).then_some((at, orders))
    }
}
