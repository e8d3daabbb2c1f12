//! The rules of [`super::recurrence`], operation by operation.

use crate::symbolic::graph::{Graph, Id, Node, Stage};
use crate::symbolic::number::Function;

use super::convolution::{Factor, Product, Readers};
use super::recurrences::{Polynomial, Recurrences};

/// Recurrences that are being written.
pub(in crate::symbolic) struct Expansion<'g> {
    pub(in crate::symbolic) graph: &'g mut Graph,
    pub(in crate::symbolic) number: Id,
    pub(in crate::symbolic) inverse: Id,
    /// The n-th coefficient of each expression, its level, and whether it moves, by index.
    pub(in crate::symbolic) next: Vec<Id>,
    pub(in crate::symbolic) levels: Vec<usize>,
    pub(in crate::symbolic) moves: Vec<bool>,
    pub(in crate::symbolic) results: Vec<(Id, Id)>,
    pub(in crate::symbolic) products: Vec<Product>,
    /// Factors that were not known when their products were written.
    pub(in crate::symbolic) pending: Vec<(usize, usize, Series)>,
}

/// A series made from that of an expression.
#[derive(Clone, Copy)]
pub(in crate::symbolic) enum Series {
    Plain(Id),
    /// The series without its start.
    Tail(Id),
    /// The series with each coefficient multiplied by its order n.
    Rate(Id),
}

impl Series {
    fn of(self) -> Id {
        let (Self::Plain(id) | Self::Tail(id) | Self::Rate(id)) = self;
        id
    }
}

impl Expansion<'_> {
    pub(in crate::symbolic) fn expand(&mut self, id: Id) {
        if !self.moves[id.index()] {
            return;
        }
        let (next, level) = self.coefficient(id);
        self.next[id.index()] = next;
        self.levels[id.index()] = level;
        let node = self.graph.node(id);
        if matches!(node, Node::Divide(..) | Node::Unary(..) | Node::Binary(..)) {
            self.results.push((id, next));
        }
    }

    /// The n-th coefficient of an expression that moves, and its level.
    fn coefficient(&mut self, id: Id) -> (Id, usize) {
        let node = self.graph.node(id).clone();
        let levels = node.operands().map(|operand| self.levels[operand.index()]);
        let level = levels.max().unwrap_or(0);
        let coefficients: Vec<Id> = node
            .operands()
            .map(|operand| self.next[operand.index()])
            .collect();
        let next = match (&node, &coefficients[..]) {
            (Node::Quantity(_) | Node::Positive(_), &[a]) => a,
            (Node::Negate(_), &[a]) => self.graph.negate(a),
            (Node::Add(..), &[a, b]) => self.graph.add(a, b),
            (Node::Subtract(..), &[a, b]) => self.graph.subtract(a, b),
            (Node::Select(condition, ..), &[_, a, b]) => self.graph.select(*condition, a, b),
            (Node::Multiply(a, b), &[next_a, next_b]) => {
                match (self.moves[a.index()], self.moves[b.index()]) {
                    (true, true) => return self.multiplied(id, *a, *b, level),
                    (true, false) => self.scaled(*b, next_a),
                    _ => self.scaled(*a, next_b),
                }
            }
            (Node::Divide(a, b), &[above, _]) if self.moves[b.index()] => {
                return self.quotient(id, *a, *b, above);
            }
            (Node::Divide(_, b), &[above, _]) => {
                let reciprocal = self.reciprocal(*b);
                self.graph.multiply(reciprocal, above)
            }
            (Node::Pivot(divisor, _), _) => {
                let one = self.graph.one();
                let zero = self.graph.zero();
                return self.quotient(id, one, *divisor, zero);
            }
            (Node::Unary(Function::Sqrt, _), &[above]) => return self.root(id, above, level),
            (Node::Unary(function, a), _) => return self.function(id, *function, *a, level),
            (Node::Binary(Function::Powf, a, _), _) => {
                return (self.driven(id, *a, level), level + 1);
            }
            (Node::Binary(Function::Atan2, y, x), _) => return self.angle(id, *y, *x, level),
            // a coordinate
            _ => self.next[id.index()],
        };
        (next, level)
    }

    /// `z[n] = a * b`
    fn multiplied(&mut self, id: Id, a: Id, b: Id, level: usize) -> (Id, usize) {
        let sum = self.product(id, level, Series::Plain(a), Series::Plain(b));
        (sum, level + 1)
    }

    /// A held factor is constant along the step, and so is the product of two of them.
    fn scaled(&mut self, held: Id, coefficient: Id) -> Id {
        let (held, coefficient) = match *self.graph.node(coefficient) {
            Node::Multiply(a, b) if self.is_held(a) => (self.graph.multiply(held, a), b),
            Node::Multiply(a, b) if self.is_held(b) => (self.graph.multiply(held, b), a),
            _ => (held, coefficient),
        };
        let held = if self.graph.is_early(held) {
            held
        } else {
            self.graph.quantity(held)
        };
        self.graph.multiply(held, coefficient)
    }

    /// Whether a factor of a coefficient is the same for all orders.
    fn is_held(&self, factor: Id) -> bool {
        let stands = matches!(self.graph.node(factor), Node::Quantity(_));
        stands || self.moves.get(factor.index()) == Some(&false)
    }

    /// `z[n] = (a[n] - b* * z) / b[0]`
    fn quotient(&mut self, id: Id, a: Id, b: Id, above: Id) -> (Id, usize) {
        let level = self.levels[b.index()];
        let sum = self.product(id, level, Series::Tail(b), Series::Plain(id));
        let rest = self.graph.subtract(above, sum);
        let reciprocal = if self.graph.is_one(a) {
            self.graph.quantity(id)
        } else {
            self.reciprocal(b)
        };
        let level = self
            .levels
            .get(a.index())
            .map_or(0, |level| *level)
            .max(level + 1);
        (self.graph.multiply(reciprocal, rest), level)
    }

    /// `z[n] = (a[n] - z* * z*) / 2 z[0]`
    fn root(&mut self, id: Id, above: Id, level: usize) -> (Id, usize) {
        let level = level.max(1);
        let sum = self.product(id, level - 1, Series::Tail(id), Series::Tail(id));
        let rest = self.graph.subtract(above, sum);
        let twice = self.graph.add(id, id);
        let reciprocal = self.reciprocal(twice);
        (self.graph.multiply(reciprocal, rest), level)
    }

    /// `z' = w a'` or `w z' = a'`.
    fn function(&mut self, id: Id, function: Function, a: Id, level: usize) -> (Id, usize) {
        match function {
            Function::Sin
            | Function::Exp
            | Function::Tan
            | Function::Tanh
            | Function::Sinh
            | Function::Cosh => (self.driven(id, a, level), level + 1),
            Function::Cos => {
                let opposite = self.driven(id, a, level);
                (self.graph.negate(opposite), level + 1)
            }
            Function::Ln | Function::Atan | Function::Asin | Function::Cbrt => {
                let above = self.next[a.index()];
                (self.divided(id, above, level.max(1), false), level.max(1))
            }
            Function::Acos => {
                let above = self.graph.negate(self.next[a.index()]);
                (self.divided(id, above, level.max(1), false), level.max(1))
            }
            _ => (self.graph.zero(), level),
        }
    }

    /// `(a' * w) / n`
    fn driven(&mut self, id: Id, a: Id, level: usize) -> Id {
        let Some(companion) = self.graph.companion(id) else {
            return self.graph.zero();
        };
        let sum = self.product(id, level, Series::Rate(a), Series::Plain(companion));
        self.graph.multiply(self.inverse, sum)
    }

    /// `(a[n] - (z' * w) / n) / w[0]`, where `above` is `a[n]`, or `n a[n]` if it is a rate.
    fn divided(&mut self, id: Id, above: Id, level: usize, is_rate: bool) -> Id {
        let Some(companion) = self.graph.companion(id) else {
            return self.graph.zero();
        };
        let sum = self.product(id, level - 1, Series::Rate(id), Series::Plain(companion));
        let rest = if is_rate {
            let rest = self.graph.subtract(above, sum);
            self.graph.multiply(self.inverse, rest)
        } else {
            let part = self.graph.multiply(self.inverse, sum);
            self.graph.subtract(above, part)
        };
        let reciprocal = self.reciprocal(companion);
        self.graph.multiply(reciprocal, rest)
    }

    /// `(x^2 + y^2) z' = x y' - y x'`
    fn angle(&mut self, id: Id, y: Id, x: Id, level: usize) -> (Id, usize) {
        let [forth, back] = [(y, x), (x, y)].map(|(a, factor)| {
            if self.moves[a.index()] {
                self.product(id, level, Series::Rate(a), Series::Plain(factor))
            } else {
                self.graph.zero()
            }
        });
        let above = self.graph.subtract(forth, back);
        (self.divided(id, above, level + 1, true), level + 1)
    }

    /// `1 / a` at the start.
    fn reciprocal(&mut self, a: Id) -> Id {
        let one = self.graph.one();
        let reciprocal = self.graph.divide(one, a);
        self.graph.quantity(reciprocal)
    }

    /// The n-th term of the product of two series.
    fn product(&mut self, of: Id, level: usize, left: Series, right: Series) -> Id {
        let sum = self.graph.symbol(Stage::State);
        let zero = self.graph.zero();
        let index = self.products.len();
        let factor = |series: Series| Factor {
            start: match series {
                Series::Plain(id) => id,
                Series::Tail(_) | Series::Rate(_) => zero,
            },
            next: zero,
        };
        self.products.push(Product {
            of,
            level,
            value: sum,
            factors: [left, right].map(factor),
        });
        self.pending.extend([(index, 0, left), (index, 1, right)]);
        sum
    }

    /// The factors, now that all coefficients are known, and the result.
    pub(in crate::symbolic) fn finish(
        self,
        coefficients: Vec<Id>,
        polynomials: Vec<(Polynomial, Id)>,
        start: Vec<Id>,
    ) -> Recurrences {
        let Self {
            graph,
            number,
            inverse,
            next,
            mut results,
            mut products,
            pending,
            ..
        } = self;
        for (index, side, series) in pending {
            let coefficient = next[series.of().index()];
            products[index].factors[side].next = match series {
                Series::Rate(_) => graph.multiply(number, coefficient),
                Series::Plain(_) | Series::Tail(_) => coefficient,
            };
        }
        let mut rates = start.iter().map(|rate| next[rate.index()]).collect();
        let symbols = coefficients.iter().copied();
        let symbols = symbols.chain(polynomials.iter().map(|(_, next)| *next));
        let readers = Readers {
            rates: &mut rates,
            results: &mut results,
            symbols: symbols.chain([number, inverse]).collect(),
        };
        let sums = graph.gathered(&products, readers);
        Recurrences {
            coefficients,
            polynomials,
            order: number,
            inverse,
            results,
            sums,
            start,
            rates,
        }
    }
}
