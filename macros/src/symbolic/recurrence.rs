//! Taylor series of a motion: the n-th coefficients of expressions, from those before.
//!
//! A motion is a list of coordinates with their rates. What is linear in series has coefficients of the
//! same combination; everything else has a recurrence in convolutions `sum_j a[j] b[n - j]`, by
//! its differential equation:
//!
//! ```text
//! z = a b:     z[n] = a * b
//! z = a / b:   z[n] = (a[n] - b* * z) / b[0]
//! z^2 = a:     z[n] = (a[n] - z* * z*) / 2 z[0]
//! z' = w a':   z[n] = (a' * w) / n
//! w z' = a':   z[n] = (a[n] - (z' * w) / n) / w[0]
//! ```
//!
//! with `a*` the series without its start, and `a'[j] = j a[j]`. What is not known yet is multiplied by
//! zero: so all of these are convolutions of the same kind, and many can be done side by side.
//!
//! In what is written for n, symbols of their own stand for n-th coefficients, and the expressions
//! of the description for their values at the start.

use super::graph::{Graph, Id, Node, Stage};
use super::number::Function;

/// A coordinate of a motion.
#[derive(Clone, Copy, Debug)]
pub struct Coordinate {
    pub symbol: Id,
    pub rate: Id,
}

/// The coefficients of a motion, order by order.
#[derive(Debug)]
pub struct Recurrences {
    /// The symbols of the n-th coefficients of the coordinates.
    pub coefficients: Vec<Id>,
    /// The symbols of n, and of 1/n.
    pub order: Id,
    pub inverse: Id,
    /// The n-th coefficients of quotients and functions.
    pub results: Vec<(Id, Id)>,
    /// The convolutions, by level: what a level multiplies is made of the levels below.
    pub products: Vec<Product>,
    /// The rates of the coordinates at the start, and their n-th coefficients.
    pub start: Vec<Id>,
    pub rates: Vec<Id>,
}

/// A convolution of two series.
#[derive(Clone, Copy, Debug)]
pub struct Product {
    /// The expression that it was written for.
    pub of: Id,
    pub level: usize,
    /// The symbol of its value.
    pub sum: Id,
    pub factors: [Factor; 2],
}

/// A series that is multiplied.
#[derive(Clone, Copy, Debug)]
pub struct Factor {
    pub start: Id,
    /// Its n-th coefficient; if it is known later than the convolution, that does not depend on it.
    pub next: Id,
}

impl Recurrences {
    /// All expressions that code is generated for.
    pub fn roots(&self) -> Vec<Id> {
        let factors = self.products.iter().flat_map(|product| product.factors);
        let factors = factors.flat_map(|factor| [factor.start, factor.next]);
        self.start
            .iter()
            .chain(&self.rates)
            .copied()
            .chain(factors)
            .collect()
    }
}

impl Graph {
    /// The first place in `roots` where there is no Taylor series, if these symbols move.
    pub fn first_kink(&self, roots: &[Id], moving: &[Id]) -> Option<Id> {
        let order = self.differentiated(roots);
        let moves = self.moving(&order, moving);
        order.into_iter().find(|id| match *self.node(*id) {
            Node::Select(condition, ..) => moves[condition.index()],
            Node::Unary(function, _) | Node::Binary(function, ..) => {
                function.is_piecewise() && moves[id.index()]
            }
            _ => false,
        })
    }

    /// The recurrences of a motion without kinks.
    pub fn recurrences(&mut self, coordinates: &[Coordinate]) -> Recurrences {
        let symbols: Vec<Id> = coordinates
            .iter()
            .filter(|coordinate| !self.is_zero(coordinate.rate))
            .map(|coordinate| coordinate.symbol)
            .collect();
        let written: Vec<Id> = coordinates
            .iter()
            .map(|coordinate| coordinate.rate)
            .collect();
        let start = self.elementary(&written, &symbols);
        let order = self.with_companions(&start, &symbols);
        let moves = self.moving(&order, &symbols);
        let [number, inverse, zero] = [
            self.symbol(Stage::State),
            self.symbol(Stage::State),
            self.zero(),
        ];
        let coefficients: Vec<Id> = coordinates
            .iter()
            .map(|_| self.symbol(Stage::State))
            .collect();
        let mut expansion = Expansion {
            graph: self,
            number,
            inverse,
            next: vec![zero; moves.len()],
            levels: vec![0; moves.len()],
            moves,
            results: Vec::new(),
            products: Vec::new(),
            pending: Vec::new(),
        };
        for (coordinate, coefficient) in coordinates.iter().zip(&coefficients) {
            let index = coordinate.symbol.index();
            if expansion.moves.get(index) == Some(&true) {
                expansion.next[index] = *coefficient;
            }
        }
        for id in order {
            expansion.expand(id);
        }
        expansion.finish(coefficients, start)
    }

    /// What has to be differentiated in `roots`, children first: not the size that guards a divisor.
    fn differentiated(&self, roots: &[Id]) -> Vec<Id> {
        let mut seen = std::collections::HashSet::new();
        let mut pending = roots.to_vec();
        while let Some(id) = pending.pop() {
            if seen.insert(id) {
                let guards = matches!(self.node(id), Node::Pivot(..));
                let count = if guards { 1 } else { 3 };
                pending.extend(self.node(id).operands().take(count));
            }
        }
        let mut order: Vec<Id> = seen.into_iter().collect();
        order.sort_unstable();
        order
    }

    /// Which of the expressions of `order`, by index, change with these symbols.
    fn moving(&self, order: &[Id], symbols: &[Id]) -> Vec<bool> {
        let mut moves = vec![false; order.last().map_or(0, |last| last.index() + 1)];
        for id in order {
            let guards = matches!(self.node(*id), Node::Pivot(..));
            let mut operands = self.node(*id).operands().take(if guards { 1 } else { 3 });
            moves[id.index()] =
                symbols.contains(id) || operands.any(|operand| moves[operand.index()]);
        }
        moves
    }

    /// `roots` in operations that have a recurrence; quantities are looked into, so that factors known
    /// early come out of products.
    fn elementary(&mut self, roots: &[Id], symbols: &[Id]) -> Vec<Id> {
        let order = self.reachable(roots, |_| true);
        let moves = self.moving(&order, symbols);
        self.rebuild(roots, |graph, id, image| match *graph.node(id) {
            _ if graph.is_early(id) => id,
            Node::Quantity(a) => image(a),
            Node::Binary(Function::Hypot, a, b) if moves[id.index()] => {
                let (a, b) = (graph.square(image(a)), graph.square(image(b)));
                let sum = graph.add(a, b);
                graph.apply(Function::Sqrt, &[sum])
            }
            Node::Binary(Function::Powf, a, b) if moves[b.index()] => {
                let logarithm = graph.apply(Function::Ln, &[image(a)]);
                let exponent = graph.multiply(image(b), logarithm);
                graph.apply(Function::Exp, &[exponent])
            }
            _ => graph.remake(id, image),
        })
    }

    /// What `roots` are made of, with the companions of the functions in it, children first.
    fn with_companions(&mut self, roots: &[Id], symbols: &[Id]) -> Vec<Id> {
        let mut roots = roots.to_vec();
        loop {
            let order = self.differentiated(&roots);
            let moves = self.moving(&order, symbols);
            let known = roots.len();
            for id in &order {
                if let Some(companion) = self.companion(*id).filter(|_| moves[id.index()])
                    && order.binary_search(&companion).is_err()
                    && !roots.contains(&companion)
                {
                    roots.push(companion);
                }
            }
            if roots.len() == known {
                return order;
            }
        }
    }

    /// The w of `z' = w a'` or of `w z' = a'`, of a function z of a.
    fn companion(&mut self, id: Id) -> Option<Id> {
        let one = self.one();
        match *self.node(id) {
            Node::Unary(function, a) => {
                let (of_value, of_argument) = (self.square(id), self.square(a));
                match function {
                    Function::Sin => Some(self.apply(Function::Cos, &[a])),
                    Function::Cos => Some(self.apply(Function::Sin, &[a])),
                    Function::Sinh => Some(self.apply(Function::Cosh, &[a])),
                    Function::Cosh => Some(self.apply(Function::Sinh, &[a])),
                    Function::Exp => Some(id),
                    Function::Ln => Some(a),
                    Function::Tan => Some(self.add(one, of_value)),
                    Function::Tanh => Some(self.subtract(one, of_value)),
                    Function::Atan => Some(self.add(one, of_argument)),
                    Function::Asin | Function::Acos => {
                        let rest = self.subtract(one, of_argument);
                        Some(self.apply(Function::Sqrt, &[rest]))
                    }
                    Function::Cbrt => {
                        let three = self.integer(3);
                        Some(self.multiply(three, of_value))
                    }
                    _ => None,
                }
            }
            // (a^p)' = p a^p / a a'
            Node::Binary(Function::Powf, a, exponent) => {
                let ratio = self.divide(id, a);
                Some(self.multiply(exponent, ratio))
            }
            Node::Binary(Function::Atan2, a, b) => {
                let (a, b) = (self.square(a), self.square(b));
                Some(self.add(a, b))
            }
            _ => None,
        }
    }
}

/// Recurrences while they are written.
struct Expansion<'g> {
    graph: &'g mut Graph,
    number: Id,
    inverse: Id,
    /// The n-th coefficient of each expression, its level, and whether it moves, by index.
    next: Vec<Id>,
    levels: Vec<usize>,
    moves: Vec<bool>,
    results: Vec<(Id, Id)>,
    products: Vec<Product>,
    /// Factors that were not known when their product was written.
    pending: Vec<(usize, usize, Series)>,
}

/// A series that is made of that of an expression.
#[derive(Clone, Copy)]
enum Series {
    Plain(Id),
    /// Without its start.
    Tail(Id),
    /// Times n.
    Rate(Id),
}

impl Series {
    fn of(self) -> Id {
        let (Self::Plain(id) | Self::Tail(id) | Self::Rate(id)) = self;
        id
    }
}

impl Expansion<'_> {
    fn expand(&mut self, id: Id) {
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
            (Node::Quantity(_), &[a]) => a,
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

    /// What is held is a number along the step.
    fn scaled(&mut self, held: Id, coefficient: Id) -> Id {
        let held = if self.graph.is_early(held) {
            held
        } else {
            self.graph.quantity(held)
        };
        self.graph.multiply(held, coefficient)
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

    /// `(a[n] - (z' * w) / n) / w[0]`, where `a[n]` is given, or n times it.
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
            sum,
            factors: [left, right].map(factor),
        });
        self.pending.extend([(index, 0, left), (index, 1, right)]);
        sum
    }

    /// The factors, now that all coefficients are known, and what came of it.
    fn finish(self, coefficients: Vec<Id>, start: Vec<Id>) -> Recurrences {
        let Self {
            graph,
            number,
            inverse,
            next,
            results,
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
        products.sort_by_key(|product| product.level);
        let rates = start.iter().map(|rate| next[rate.index()]).collect();
        Recurrences {
            coefficients,
            order: number,
            inverse,
            results,
            products,
            start,
            rates,
        }
    }
}
