//! Gradients: the slopes of one expression along all of its leaves, in one backward sweep.
//!
//! From a root to its operands, each node passes down the slope of the root along itself. Powers,
//! including roots, are treated as a whole, so that no square root is computed only to be divided
//! away. Every divisor is inverted once. A branch is differentiated where it is taken: its slopes
//! carry the condition of the branch, and meet those of the other branch only at the leaves.

use std::collections::HashMap;

use crate::symbolic::algebra::{self, takes_first};
use crate::symbolic::graph::{Graph, Id, Node};
use crate::symbolic::number::{Function, Number};

/// A base, and its exponent in halves. A value, its square root and the square of that root share
/// one base.
type Power = (Id, i32);

/// The index of the condition under which a slope counts; condition 0 always holds.
type Guard = usize;

/// Slopes passed down, by node and by guard.
struct Sweep {
    powers: Vec<Power>,
    /// Whether the node contains a leaf.
    matters: Vec<bool>,
    slopes: Vec<Vec<(Guard, Id)>>,
    /// Entry n describes the guards `2 n + 1` and `2 n + 2`: the guard that encloses them, and the
    /// condition that must hold for the first and fail for the second.
    branches: Vec<(Guard, Id)>,
}

impl Graph {
    /// The slopes of `sum of weight * root` along each leaf on which it depends, in the order of
    /// the leaves. Operands of leaves are not visited.
    pub fn gradient(
        &mut self,
        weighted: &[(Id, Id)],
        is_leaf: impl Fn(Id) -> bool,
    ) -> Vec<(Id, Id)> {
        let roots: Vec<Id> = weighted.iter().map(|(root, _)| *root).collect();
        let roots = self.invert_divisors(&roots, &is_leaf);
        let order = self.reachable(&roots, &|id| !is_leaf(id));
        let size = order.last().map_or(0, |last| last.index() + 1);
        let mut sweep = Sweep {
            powers: vec![(self.zero(), 0); size],
            matters: vec![false; size],
            slopes: vec![Vec::new(); size],
            branches: Vec::new(),
        };
        for &id in &order {
            // a vector may have zero components, which are not leaves
            let is_leaf = is_leaf(id) && !self.is_early(id);
            let mut operands = self.node(id).operands();
            sweep.matters[id.index()] =
                is_leaf || operands.any(|operand| sweep.matters[operand.index()]);
            sweep.powers[id.index()] = if is_leaf {
                (id, 2)
            } else {
                self.power(id, |operand| sweep.powers[operand.index()])
            };
        }
        for (root, (_, weight)) in roots.into_iter().zip(weighted) {
            self.hand_down(&mut sweep, root, 0, *weight);
        }
        let mut found = Vec::new();
        for id in order.into_iter().rev() {
            let slopes = core::mem::take(&mut sweep.slopes[id.index()]);
            if is_leaf(id) {
                let slope = self.gather(&sweep.branches, slopes);
                if !self.is_zero(slope) {
                    found.push((id, slope));
                }
            } else {
                for (guard, slope) in slopes {
                    self.pass(&mut sweep, id, guard, slope);
                }
            }
        }
        found.reverse();
        found
    }

    /// The base and exponent of a product of equal factors, or of a root.
    fn power(&self, id: Id, known: impl Fn(Id) -> Power) -> Power {
        let whole = (id, 2);
        match *self.node(id) {
            Node::Quantity(a) => match known(a) {
                (base, _) if base == a => whole,
                power => power,
            },
            Node::Unary(Function::Sqrt, a) if !self.is_early(a) => (a, 1),
            Node::Divide(a, b) if self.is_one(a) => {
                let (base, halves) = known(b);
                (base, -halves)
            }
            Node::Multiply(a, b) => match (known(a), known(b)) {
                ((base, m), (other, n)) if base == other => (base, m + n),
                _ => whole,
            },
            _ => whole,
        }
    }

    /// `base ^ (halves / 2)`, by the inverse of the root if that is computed anyway.
    fn half_power(&mut self, base: Id, halves: i32) -> Id {
        let root = Node::Unary(Function::Sqrt, base);
        let inverse_root = self.find(&root).and_then(|root| self.find_inverse(root));
        match inverse_root {
            Some(inverse) if halves < 0 => self.powi(inverse, -halves),
            _ if halves % 2 == 0 => self.signed_power(base, halves / 2),
            _ => {
                let root = self.apply(Function::Sqrt, &[base]);
                self.signed_power(root, halves)
            }
        }
    }

    fn signed_power(&mut self, base: Id, exponent: i32) -> Id {
        if exponent >= 0 {
            return self.powi(base, exponent);
        }
        let one = self.one();
        let inverse = self.divide(one, base);
        let inverse = self.quantity(inverse);
        self.powi(inverse, -exponent)
    }

    /// The statement `1 / a`, if there is one.
    fn find_inverse(&self, a: Id) -> Option<Id> {
        let one = self.find(&Node::Number(Number::one()))?;
        self.find(&Node::Quantity(self.find(&Node::Divide(one, a))?))
    }

    /// `a / b` as `a` times an inverse power, with the inverse as a statement.
    fn invert_divisors(&mut self, roots: &[Id], is_leaf: impl Fn(Id) -> bool) -> Vec<Id> {
        self.rebuild(roots, |graph, id, image| match *graph.node(id) {
            _ if is_leaf(id) => id,
            Node::Divide(a, b) if !graph.is_early(b) => {
                let (a, b) = (image(a), image(b));
                let (base, halves) = graph.whole_power(b);
                let inverse = graph.half_power(base, -halves);
                graph.multiply(a, inverse)
            }
            _ => graph.remake(id, image),
        })
    }

    /// The base and exponent of a divisor.
    fn whole_power(&self, id: Id) -> Power {
        let is_factor = |id: Id| {
            matches!(
                self.node(id),
                Node::Quantity(_) | Node::Multiply(..) | Node::Divide(..)
            )
        };
        let order = self.reachable(&[id], &is_factor);
        let mut powers: HashMap<Id, Power> = HashMap::new();
        for id in order {
            let power = self.power(id, |operand| powers[&operand]);
            powers.insert(id, power);
        }
        powers[&id]
    }

    /// The slope that all terms of a sum of squares will use. Since each square contributes a
    /// factor of two, twice the slope is the statement, and the result is half of it.
    fn shared(&mut self, base: Id, slope: Id) -> Id {
        if self.is_early(slope) || !self.is_sum_of_squares(base) {
            return slope;
        }
        let two = self.integer(2);
        let double = self.multiply(two, slope);
        let double = self.quantity(double);
        let half = self.number(Number::ratio(1, 2));
        self.multiply(half, double)
    }

    fn is_sum_of_squares(&self, id: Id) -> bool {
        let mut pending = vec![id];
        let mut terms = 0;
        while let Some(id) = pending.pop() {
            match *self.node(id) {
                Node::Quantity(a) => pending.push(a),
                Node::Add(a, b) | Node::Subtract(a, b) => pending.extend([a, b]),
                Node::Multiply(a, b) if self.is_early(a) => pending.push(b),
                Node::Multiply(a, b) if a == b => terms += 1,
                _ => {}
            }
        }
        terms > 1
    }

    /// Adds to the slope of a node.
    fn hand_down(&mut self, sweep: &mut Sweep, to: Id, guard: Guard, slope: Id) {
        if !sweep.matters[to.index()] || self.is_zero(slope) {
            return;
        }
        let slopes = &mut sweep.slopes[to.index()];
        match slopes.iter_mut().find(|(known, _)| *known == guard) {
            Some((_, sum)) => *sum = self.add(*sum, slope),
            None => slopes.push((guard, slope)),
        }
    }

    /// The chain rule: passes the slope of a node on to its operands.
    fn pass(&mut self, sweep: &mut Sweep, id: Id, guard: Guard, slope: Id) {
        let (base, halves) = sweep.powers[id.index()];
        if base != id {
            let rest = self.half_power(base, halves - 2);
            let exponent = self.number(Number::ratio(i64::from(halves), 2));
            let slope = self.multiply(exponent, slope);
            let slope = self.multiply(slope, rest);
            let slope = self.shared(base, slope);
            self.hand_down(sweep, base, guard, slope);
            return;
        }
        match *self.node(id) {
            Node::Binary(function @ (Function::Min | Function::Max), a, b) => {
                let condition = takes_first(self, function, &a, &b);
                self.branch(sweep, (condition, a, b), guard, slope);
            }
            Node::Select(condition, a, b) => {
                self.branch(sweep, (condition, a, b), guard, slope);
            }
            _ => {
                for (operand, part) in self.pull_back(id, slope) {
                    self.hand_down(sweep, operand, guard, part);
                }
            }
        }
    }

    /// The slopes of the operands of a node that is neither a power nor a choice.
    fn pull_back(&mut self, id: Id, slope: Id) -> Vec<(Id, Id)> {
        match *self.node(id) {
            Node::Quantity(a) | Node::Positive(a) => vec![(a, slope)],
            Node::Negate(a) => vec![(a, self.negate(slope))],
            Node::Add(a, b) => vec![(a, slope), (b, slope)],
            Node::Subtract(a, b) => vec![(a, slope), (b, self.negate(slope))],
            Node::Multiply(a, b) => {
                vec![(a, self.multiply(slope, b)), (b, self.multiply(slope, a))]
            }
            // only divisors known early are left: all others were turned into powers
            Node::Divide(a, b) => vec![(a, self.divide(slope, b))],
            Node::Pivot(a, _) => {
                // (1 / a)' = -(1 / a)^2 a'
                let square = self.square(id);
                let slope = self.multiply(square, slope);
                vec![(a, self.negate(slope))]
            }
            Node::Unary(function, a) => {
                let by_a = algebra::slope(self, function, &a, &id);
                vec![(a, self.multiply(by_a, slope))]
            }
            Node::Binary(function, a, b) => {
                let (by_a, by_b) = algebra::slopes(self, function, &a, &b, &id);
                vec![
                    (a, self.multiply(by_a, slope)),
                    (b, self.multiply(by_b, slope)),
                ]
            }
            Node::Foreign(function, arguments) => {
                let by_each = arguments.into_iter().enumerate().map(|(place, argument)| {
                    let by_one = self.foreign(function.by(place), arguments);
                    (argument, self.multiply(by_one, slope))
                });
                by_each.collect()
            }
            _ => Vec::new(),
        }
    }

    fn branch(
        &mut self,
        sweep: &mut Sweep,
        (condition, first, second): (Id, Id, Id),
        guard: Guard,
        slope: Id,
    ) {
        let known = sweep
            .branches
            .iter()
            .position(|branch| *branch == (guard, condition));
        let branch = known.unwrap_or(sweep.branches.len());
        if known.is_none() {
            sweep.branches.push((guard, condition));
        }
        self.hand_down(sweep, first, 2 * branch + 1, slope);
        self.hand_down(sweep, second, 2 * branch + 2, slope);
    }

    /// The slopes of all branches as one expression that selects by their conditions.
    fn gather(&mut self, branches: &[(Guard, Id)], slopes: Vec<(Guard, Id)>) -> Id {
        let mut by_guard = vec![self.zero(); 2 * branches.len() + 1];
        for (guard, slope) in slopes {
            by_guard[guard] = slope;
        }
        // inner branches come after the enclosing ones
        for (branch, (around, condition)) in branches.iter().enumerate().rev() {
            let (first, second) = (by_guard[2 * branch + 1], by_guard[2 * branch + 2]);
            let chosen = self.select(*condition, first, second);
            by_guard[*around] = self.add(by_guard[*around], chosen);
        }
        by_guard[0]
    }
}
