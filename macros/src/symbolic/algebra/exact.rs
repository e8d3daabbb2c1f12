//! The values of expressions at exact numbers, with proven bounds.
//!
//! A [`Number`] is a ratio of integers, or a value with an error bound and a residue that proves
//! identities; if its digits do not distinguish it from zero, more are computed. An expression that
//! depends on an unknown sign has no value here: nothing is guessed.

use std::collections::BTreeSet;

use crate::symbolic::graph::{Comparison, Graph, Id, Node};
use crate::symbolic::number::{Foreign, Function, Number};

use super::operations::{self, Algebra};

/// The result for an expression.
#[derive(Clone, Debug)]
pub enum Exact {
    /// The value; for a condition, one if it holds and zero if not.
    Number(Number),
    /// It depends on symbols whose values are unknown.
    Open(BTreeSet<Id>),
    /// It depends on whether something is zero, and that is neither proved nor refuted.
    Undecided,
    /// It has no value: a quotient by zero, or the root of a negative number.
    Absent,
}

impl Graph {
    /// The values of `roots`, with those of the symbols given by `symbol`.
    pub fn exact(&self, roots: &[Id], symbol: impl Fn(Id) -> Option<Number>) -> Vec<Exact> {
        let order = self.nodes_of(roots);
        let mut values = vec![Exact::Absent; order.last().map_or(0, |last| last.index() + 1)];
        for id in order {
            let value = |operand: Id| values[operand.index()].clone();
            values[id.index()] = match *self.node(id) {
                Node::Symbol(_) => {
                    symbol(id).map_or_else(|| Exact::Open(BTreeSet::from([id])), Exact::Number)
                }
                Node::Binary(Function::Table, a, table) => self.exact_table(value(a), table),
                ref node => operations::value(&mut Exactly, node, value),
            };
        }
        let values = roots.iter().map(|root| values[root.index()].clone());
        values.collect()
    }

    /// The value of a table; undecided if the argument may be a knot, where two polynomials meet.
    fn exact_table(&self, argument: Exact, table: Id) -> Exact {
        let Exact::Number(x) = &argument else {
            return argument;
        };
        let Some(table) = self.table(table) else {
            return Exact::Absent;
        };
        let mut starts = table.pieces.iter().map(|piece| &piece.start);
        if starts.any(|start| is_near(x, start)) {
            return Exact::Undecided;
        }
        Exact::Number(table.value(x))
    }
}

/// Whether it is unknown which of the two is larger.
fn is_near(a: &Number, b: &Number) -> bool {
    (a.clone() - b.clone()).is_undecided()
}

impl Exact {
    /// The comparison of two numbers; `Undecided` if thousands of bits do not decide.
    pub fn compare(comparison: Comparison, a: &Number, b: &Number) -> Self {
        let difference = a.clone() - b.clone();
        if difference.is_undecided() {
            return Self::Undecided;
        }
        let holds = comparison.holds(difference.cmp(&Number::zero()));
        Self::Number(Number::integer(i64::from(holds)))
    }

    /// The value of a function if one of its arguments is not a number.
    fn poisoned(values: &[Self]) -> Self {
        let mut open = BTreeSet::new();
        for value in values {
            if let Self::Open(symbols) = value {
                open.extend(symbols);
            }
        }
        if !open.is_empty() {
            return Self::Open(open);
        }
        let is_absent = values.iter().any(|value| matches!(value, Self::Absent));
        if is_absent {
            Self::Absent
        } else {
            Self::Undecided
        }
    }
}

/// Arithmetic of exact values.
struct Exactly;

impl Exactly {
    fn both(a: &Exact, b: &Exact, make: impl FnOnce(&Number, &Number) -> Exact) -> Exact {
        match (a, b) {
            (Exact::Number(a), Exact::Number(b)) => make(a, b),
            _ => Exact::poisoned(&[a.clone(), b.clone()]),
        }
    }
}

impl Algebra for Exactly {
    type Value = Exact;

    fn number(&mut self, number: &Number) -> Exact {
        Exact::Number(number.clone())
    }

    fn undefined(&mut self) -> Exact {
        Exact::Absent
    }

    fn negate(&mut self, a: &Exact) -> Exact {
        match a {
            Exact::Number(a) => Exact::Number(-a.clone()),
            other => other.clone(),
        }
    }

    fn add(&mut self, a: &Exact, b: &Exact) -> Exact {
        Self::both(a, b, |a, b| Exact::Number(a.clone() + b.clone()))
    }

    fn multiply(&mut self, a: &Exact, b: &Exact) -> Exact {
        match (a, b) {
            // an unknown factor does not matter if the other one is zero
            (Exact::Open(_), zero) | (zero, Exact::Open(_)) if self.is_zero(zero) => zero.clone(),
            _ => Self::both(a, b, |a, b| Exact::Number(a.clone() * b.clone())),
        }
    }

    fn divide(&mut self, a: &Exact, b: &Exact) -> Exact {
        Self::both(a, b, |a, b| match a.checked_div(b) {
            Some(quotient) => Exact::Number(quotient),
            None if b.is_undecided() => Exact::Undecided,
            None => Exact::Absent,
        })
    }

    fn positive(&mut self, a: &Exact) -> Exact {
        match a {
            Exact::Number(number) if number.is_undecided() => Exact::Undecided,
            Exact::Number(number) if !number.is_positive() => Exact::Absent,
            other => other.clone(),
        }
    }

    fn apply(&mut self, function: Function, arguments: &[Exact]) -> Exact {
        let numbers = arguments.iter().map(|argument| match argument {
            Exact::Number(number) => Some(number.clone()),
            _ => None,
        });
        let Some(numbers) = numbers.collect::<Option<Vec<Number>>>() else {
            return Exact::poisoned(arguments);
        };
        if jumps(function, &numbers) {
            return Exact::Undecided;
        }
        match Number::apply(function, &numbers) {
            Some(value) => Exact::Number(value),
            None if numbers.iter().any(Number::is_undecided) => Exact::Undecided,
            None => Exact::Absent,
        }
    }

    /// The result of a foreign function is not known before the code runs.
    fn foreign(&mut self, _: Foreign, arguments: &[Exact; Foreign::ARGUMENTS]) -> Exact {
        Exact::poisoned(arguments)
    }

    fn is_zero(&self, a: &Exact) -> bool {
        matches!(a, Exact::Number(a) if a.is_zero())
    }

    fn compare(&mut self, comparison: Comparison, a: &Exact, b: &Exact) -> Exact {
        Self::both(a, b, |a, b| Exact::compare(comparison, a, b))
    }

    fn select(&mut self, condition: &Exact, first: &Exact, second: &Exact) -> Exact {
        match condition {
            Exact::Number(holds) if holds.is_zero() => second.clone(),
            Exact::Number(_) => first.clone(),
            other => other.clone(),
        }
    }
}

/// Whether the value depends on an unknown sign.
fn jumps(function: Function, numbers: &[Number]) -> bool {
    let [x, rest @ ..] = numbers else {
        return false;
    };
    match (function, rest) {
        (Function::Signum, _) => x.is_undecided(),
        (Function::Floor | Function::Ceil, _) => {
            let Some(below) = Number::apply(Function::Floor, core::slice::from_ref(x)) else {
                return true;
            };
            is_near(x, &below) || is_near(x, &(below + Number::one()))
        }
        (Function::Min | Function::Max, [y]) => is_near(x, y),
        (Function::Atan2, [y]) => x.is_undecided() || y.is_undecided(),
        (Function::Powf, [exponent]) => {
            let seems_whole = exponent.is_rounded() && exponent.value.is_int();
            x.is_undecided() || exponent.is_undecided() || seems_whole
        }
        _ => false,
    }
}
