//! Expressions: the subset of Rust's expressions that a description may use.

use proc_macro2::Ident;

use crate::errors::Extent;

use super::unit::UnitExpression;

/// An expression and its place.
#[derive(Clone, Debug)]
pub struct Expression {
    pub kind: Kind,
    pub extent: Extent,
}

/// The forms of an expression.
#[derive(Clone, Debug)]
pub enum Kind {
    /// The digits of a literal.
    Number(String),
    Name(Ident),
    /// A string: the name of a file, or of one of its columns.
    Text(String),
    /// `_`
    Placeholder,
    /// Unreadable and already reported. It has no value, but the expression around it is still
    /// checked.
    Poisoned,
    /// `(x, y, z)`
    Tuple(Vec<Expression>),
    /// `[a, b]`, in the parentheses of `.on(..)`.
    List(Vec<Expression>),
    /// `operand[unit]`
    Unit(Box<Expression>, UnitExpression),
    Prefix(Prefix, Box<Expression>),
    /// `first op second op third`, from left to right.
    Chain(Box<Expression>, Vec<Step>),
    /// `function(arguments)`
    Call(Ident, Vec<Expression>),
    /// `receiver.method(arguments)`
    Method(Box<Expression>, Ident, Vec<Expression>),
    /// `receiver.field`
    Field(Box<Expression>, Ident),
    /// `name { field: value, .. }`
    Record(Ident, Vec<(Ident, Expression)>),
    /// `if condition { first } else { second }`
    If(Box<[Expression; 3]>),
}

/// `op operand` of a chain.
#[derive(Clone, Debug)]
pub struct Step {
    pub operator: Operator,
    /// The place of the operator.
    pub place: Extent,
    pub operand: Expression,
}

/// `-` or `!`
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Prefix {
    Minus,
    Not,
}

/// Operators with two operands.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Operator {
    Add,
    Subtract,
    Multiply,
    Divide,
    Less,
    LessOrEqual,
    Greater,
    GreaterOrEqual,
    Equal,
    NotEqual,
    And,
    Or,
    /// `^`, which is a power in units alone. It is reported where the names around it are known.
    Power,
}

/// A function or a method, with its arguments.
pub type Called<'e> = (&'e Ident, &'e [Expression]);

/// `kind(arguments)`, and the methods called on it.
pub fn call(value: &Expression) -> Option<(Called<'_>, Vec<Called<'_>>)> {
    let mut methods = Vec::new();
    let mut inner = value;
    loop {
        match &inner.kind {
            Kind::Method(receiver, method, arguments) => {
                methods.push((method, arguments.as_slice()));
                inner = receiver;
            }
            Kind::Call(word, arguments) => return Some(((word, arguments), methods)),
            _ => return None,
        }
    }
}

impl Expression {
    /// The number of names and numbers in it.
    pub fn size(&self) -> usize {
        let mut size = 0;
        self.visit(|part| {
            size += usize::from(matches!(part.kind, Kind::Name(_) | Kind::Number(_)));
        });
        size
    }

    /// The names in it, in order.
    pub fn names(&self) -> Vec<&Ident> {
        let mut names = Vec::new();
        self.visit(|part| {
            if let Kind::Name(name) = &part.kind {
                names.push(name);
            }
        });
        names
    }

    /// Visits every part, from left to right.
    pub fn visit<'e>(&'e self, mut show: impl FnMut(&'e Self)) {
        let mut pending = vec![self];
        while let Some(part) = pending.pop() {
            show(part);
            let shown = pending.len();
            match &part.kind {
                Kind::Number(_)
                | Kind::Name(_)
                | Kind::Text(_)
                | Kind::Placeholder
                | Kind::Poisoned => {}
                Kind::Tuple(parts) | Kind::List(parts) | Kind::Call(_, parts) => {
                    pending.extend(parts);
                }
                Kind::Unit(operand, _) | Kind::Prefix(_, operand) | Kind::Field(operand, _) => {
                    pending.push(operand);
                }
                Kind::Chain(first, rest) => {
                    pending.push(first);
                    pending.extend(rest.iter().map(|step| &step.operand));
                }
                Kind::Method(receiver, _, arguments) => {
                    pending.push(receiver);
                    pending.extend(arguments);
                }
                Kind::Record(_, fields) => pending.extend(fields.iter().map(|(_, value)| value)),
                Kind::If(parts) => pending.extend(parts.iter()),
            }
            pending[shown..].reverse();
        }
    }
}
