//! Taylor series of a motion: the n-th coefficients of expressions, from the preceding ones.
//!
//! A motion is a list of coordinates with their rates. The coefficients of a linear combination of
//! series are the same combination of coefficients. Everything else has a differential equation,
//! from which follows a recurrence in convolutions `sum_j a[j] b[n - j]`:
//!
//! ```text
//! z = a b:     z[n] = a * b
//! z = a / b:   z[n] = (a[n] - b* * z) / b[0]
//! z^2 = a:     z[n] = (a[n] - z* * z*) / 2 z[0]
//! z' = w a':   z[n] = (a' * w) / n
//! w z' = a':   z[n] = (a[n] - (z' * w) / n) / w[0]
//! ```
//!
//! Here `a*` is the series without its start, and `a'[j] = j a[j]`. Coefficients that are not known
//! yet are multiplied by zero. So all of these are convolutions of the same kind, and many can be
//! computed side by side.
//!
//! In the code for order n, new symbols stand for the n-th coefficients. The expressions of the
//! description stand for their values at the start.

use crate::symbolic::graph::{Graph, Id, Node, Stage};
use crate::symbolic::number::Function;

use super::expansion::Expansion;
use super::recurrences::{Coordinate, Polynomial, Recurrences};

impl Graph {
    /// The first expression in `roots` that has no Taylor series, if these symbols move.
    pub fn first_kink(&self, roots: &[Id], moving: &[Id]) -> Option<Id> {
        let order = self.differentiated(roots);
        let moves = self.moving(&order, moving);
        order.into_iter().find(|id| match *self.node(*id) {
            Node::Select(condition, ..) => moves[condition.index()],
            Node::Unary(function, _) | Node::Binary(function, ..) => {
                function.is_piecewise() && moves[id.index()]
            }
            Node::Foreign(..) => moves[id.index()],
            _ => false,
        })
    }

    /// The recurrences of a motion without kinks.
    pub fn recurrences(
        &mut self,
        coordinates: &[Coordinate],
        polynomials: &[Polynomial],
    ) -> Recurrences {
        let changing = coordinates.iter();
        let changing = changing.filter(|coordinate| !self.is_zero(coordinate.rate));
        let symbols: Vec<Id> = changing
            .map(|coordinate| coordinate.symbol)
            .chain(polynomials.iter().map(|polynomial| polynomial.symbol))
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
        let polynomials: Vec<(Polynomial, Id)> = polynomials
            .iter()
            .map(|polynomial| (polynomial.clone(), self.symbol(Stage::State)))
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
        let symbols = coordinates.iter().map(|coordinate| coordinate.symbol);
        let next = symbols.zip(coefficients.iter().copied());
        let known = polynomials.iter();
        for (symbol, next) in next.chain(known.map(|(known, next)| (known.symbol, *next))) {
            if expansion.moves.get(symbol.index()) == Some(&true) {
                expansion.next[symbol.index()] = next;
            }
        }
        for id in order {
            expansion.expand(id);
        }
        expansion.finish(coefficients, polynomials, start)
    }

    /// The parts of `roots` that are differentiated, children first. The size that guards a divisor
    /// is not among them.
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

    /// Whether each expression of `order`, by index, changes with these symbols.
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

    /// `roots`, written with operations that have a recurrence. Quantities are expanded, so that
    /// factors known early can be taken out of products.
    fn elementary(&mut self, roots: &[Id], symbols: &[Id]) -> Vec<Id> {
        let order = self.nodes_of(roots);
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

    /// The parts of `roots`, with the companions of their functions, children first.
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

    /// The w in `z' = w a'` or `w z' = a'`, for a function z of a.
    pub(in crate::symbolic) fn companion(&mut self, id: Id) -> Option<Id> {
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
