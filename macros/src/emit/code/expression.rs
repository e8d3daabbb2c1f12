//! Expressions of the graph as Rust expressions, with no more parentheses than needed.

use proc_macro2::{Ident, Span, TokenStream};
use quote::{ToTokens, quote};

use crate::symbolic::{Comparison, Foreign, Function, Id, Node, Number};

use super::block::Block;
use super::naming::given;
use super::scalar::number_literal;

/// The precedence of an expression, from loosest to tightest.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Precedence {
    Lowest,
    Or,
    And,
    Comparison,
    Sum,
    Product,
    Sign,
    Atom,
}

impl Block<'_> {
    /// The right-hand side of a statement.
    pub fn definition(&self, id: Id) -> TokenStream {
        match *self.writer.work.graph.node(id) {
            Node::Quantity(inner) => self.value(inner),
            _ => self.operation(id).0,
        }
    }

    /// An expression in any position.
    pub fn value(&self, id: Id) -> TokenStream {
        self.expression(id, Precedence::Lowest)
    }

    /// An expression in a position where operators bind as tightly as `outer`.
    pub fn expression(&self, id: Id, outer: Precedence) -> TokenStream {
        let (tokens, precedence) = self.operand(id);
        if precedence < outer {
            quote!((#tokens))
        } else {
            tokens
        }
    }

    fn operand(&self, id: Id) -> (TokenStream, Precedence) {
        if let Some(name) = self.names.get(&id) {
            return (name.into_token_stream(), Precedence::Atom);
        }
        if let Some(field) = self.writer.fields.get(id) {
            return (quote!(self.#field), Precedence::Atom);
        }
        match self.writer.work.graph.node(id) {
            // this only renames an existing statement
            Node::Quantity(inner) => self.operand(*inner),
            _ => self.operation(id),
        }
    }

    fn operation(&self, id: Id) -> (TokenStream, Precedence) {
        let graph = &self.writer.work.graph;
        if let Some(operation) = self.choice_of_any_scalar(id).or_else(|| self.infix(id)) {
            return operation;
        }
        let prefix = |operator: TokenStream, a: Id, inner: Precedence| {
            let a = self.expression(a, inner);
            (quote!(#operator #a), Precedence::Sign)
        };
        match *graph.node(id) {
            Node::Number(ref number) => {
                self.numbers.borrow_mut().insert(id);
                number_tokens(number)
            }
            Node::Truth(value) => (value.into_token_stream(), Precedence::Atom),
            Node::Quantity(inner) => self.operand(inner),
            Node::Negate(a) => prefix(quote!(-), a, Precedence::Sign),
            Node::Not(a) => prefix(quote!(!), a, Precedence::Atom),
            Node::Unary(function, a) => (self.call(function, &[a]), Precedence::Atom),
            Node::Binary(function, a, b) => (self.call(function, &[a, b]), Precedence::Atom),
            Node::Foreign(function, arguments) => {
                (self.foreign_call(function, &arguments), Precedence::Atom)
            }
            Node::Pivot(divisor, scale) => (self.guarded(id, divisor, scale), Precedence::Atom),
            Node::Positive(a) => {
                let (private, a) = (&self.writer.shapes.private, self.value(a));
                (quote!(#private::positive(#a)), Precedence::Atom)
            }
            Node::Select(condition, a, b) => {
                let [condition, a, b] = [condition, a, b].map(|id| self.value(id));
                // it stands alone on the right of a statement, or in parentheses
                (quote!(if #condition { #a } else { #b }), Precedence::Lowest)
            }
            // infix operators are handled above
            _ => (quote!(f64::NAN), Precedence::Atom),
        }
    }

    /// `a + b`, and so on.
    fn infix(&self, id: Id) -> Option<(TokenStream, Precedence)> {
        let graph = &self.writer.work.graph;
        let (a, operator, b, precedence, tighter) = match *graph.node(id) {
            Node::Negate(a) => match *graph.node(a) {
                // -(x - y), kept in this form for readability
                Node::Subtract(x, y) if !self.names.contains_key(&a) => {
                    (y, quote!(-), x, Precedence::Sum, Precedence::Product)
                }
                _ => return None,
            },
            Node::Add(a, b) => {
                let is_second = self.comes_second(a, b);
                let (a, b) = if is_second { (b, a) } else { (a, b) };
                let number = graph.as_number(b).filter(|number| number.is_negative());
                if let Some(number) = number.filter(|_| !self.names.contains_key(&b)) {
                    self.numbers.borrow_mut().insert(b);
                    let a = self.expression(a, Precedence::Sum);
                    let b = number_tokens(&number.abs()).0;
                    return Some((quote!(#a - #b), Precedence::Sum));
                }
                (a, quote!(+), b, Precedence::Sum, Precedence::Product)
            }
            Node::Subtract(a, b) => (a, quote!(-), b, Precedence::Sum, Precedence::Product),
            Node::Multiply(a, b) => (a, quote!(*), b, Precedence::Product, Precedence::Sign),
            Node::Divide(a, b) => (a, quote!(/), b, Precedence::Product, Precedence::Sign),
            Node::Compare(comparison, a, b) => {
                let operator = match comparison {
                    Comparison::Less => quote!(<),
                    Comparison::LessOrEqual => quote!(<=),
                    Comparison::Equal => quote!(==),
                    Comparison::NotEqual => quote!(!=),
                };
                (a, operator, b, Precedence::Comparison, Precedence::Sum)
            }
            Node::And(a, b) => (a, quote!(&&), b, Precedence::And, Precedence::Comparison),
            Node::Or(a, b) => (a, quote!(||), b, Precedence::Or, Precedence::And),
            _ => return None,
        };
        let (a, b) = (self.expression(a, precedence), self.expression(b, tighter));
        Some((quote!(#a #operator #b), precedence))
    }

    /// A reciprocal, guarded against a divisor that is nothing but rounding error.
    fn guarded(&self, id: Id, divisor: Id, scale: Id) -> TokenStream {
        let private = &self.writer.shapes.private;
        let [divisor, scale] = [divisor, scale].map(|id| self.value(id));
        if self.writer.is_fallible {
            let unknown = self.unknown(id);
            quote!(#private::reciprocal(#unknown, #divisor, #scale)?)
        } else {
            quote!(#private::determined(#divisor, #scale))
        }
    }

    /// The comparisons and choices of a generic body, which may apply to several numbers at once.
    fn choice_of_any_scalar(&self, id: Id) -> Option<(TokenStream, Precedence)> {
        let atom = |tokens: TokenStream| Some((tokens, Precedence::Atom));
        let infix = |a: Id, operator: TokenStream, b: Id| {
            let [a, b] = [a, b].map(|id| self.expression(id, Precedence::Sign));
            Some((quote!(#a #operator #b), Precedence::Or))
        };
        match *self.writer.work.graph.node(id) {
            _ if !self.is_generic => None,
            Node::Compare(comparison, a, b) => {
                let compared = |name: &str| self.method(name, &[a, b]);
                match comparison {
                    Comparison::Less => atom(compared("less")),
                    Comparison::LessOrEqual => atom(compared("less_or_equal")),
                    Comparison::Equal => atom(compared("equal")),
                    Comparison::NotEqual => {
                        let equal = compared("equal");
                        Some((quote!(!#equal), Precedence::Sign))
                    }
                }
            }
            Node::And(a, b) => infix(a, quote!(&), b),
            Node::Or(a, b) => infix(a, quote!(|), b),
            Node::Select(condition, a, b) => {
                let kind = self.writer.shapes.scalar.kind();
                let arguments = self.arguments(&[condition, a, b]);
                atom(quote!(#kind::select(#(#arguments),*)))
            }
            _ => None,
        }
    }

    /// Whether `a` comes second in a sum, where the order does not matter. Terms known early come
    /// last. Terms that are sums themselves come first, so that they need no parentheses.
    fn comes_second(&self, a: Id, b: Id) -> bool {
        let graph = &self.writer.work.graph;
        let is_sum = |id: Id| {
            !self.names.contains_key(&id)
                && matches!(graph.node(id), Node::Add(..) | Node::Subtract(..))
        };
        if graph.is_early(a) == graph.is_early(b) {
            is_sum(b) && !is_sum(a)
        } else {
            graph.is_early(a)
        }
    }

    /// The unknown that a guarded reciprocal gives, as `Body.normal`.
    fn unknown(&self, reciprocal: Id) -> String {
        let unknown = self.writer.work.labels.unknown(reciprocal);
        format!("{}.{unknown}", self.writer.outline.name)
    }

    fn call(&self, function: Function, arguments: &[Id]) -> TokenStream {
        if let (Function::Table, &[argument, table]) = (function, arguments) {
            return self.looked_up(argument, table);
        }
        if self.is_generic {
            return self.method(function.name(), arguments);
        }
        let (private, arguments) = (&self.writer.shapes.private, self.arguments(arguments));
        let name = Ident::new(function.name(), Span::call_site());
        quote!(#private::math::#name(#(#arguments),*))
    }

    /// The value of a table, from its polynomials.
    fn looked_up(&self, argument: Id, table: Id) -> TokenStream {
        let table = self.writer.work.graph.table(table);
        let pieces = table.map_or(Vec::new(), |table| table.pieces);
        let width = pieces.iter().map(|piece| piece.coefficients.len()).max();
        let rows = pieces.iter().map(|piece| {
            let rest = (0..width.unwrap_or(0)).map(|power| match piece.coefficients.get(power) {
                Some(one) => number_literal(one.to_f64()),
                None => number_literal(0.0),
            });
            let start = number_literal(piece.start.to_f64());
            quote!((#start, [#(#rest),*]))
        });
        let (private, argument) = (&self.writer.shapes.private, self.value(argument));
        quote!(#private::table(#argument, &[#(#rows),*]))
    }

    /// `Self::given_lift(alpha)`
    fn foreign_call(&self, which: Foreign, arguments: &[Id]) -> TokenStream {
        let function = &self.writer.work.functions[which.number()];
        let word = function.word(which).unwrap_or_default();
        let name = given(&word);
        let arguments = self.arguments(&arguments[..function.arguments.len()]);
        quote!(Self::#name(#(#arguments),*))
    }

    /// A method of the scalar, `x.sin()`.
    pub fn method(&self, name: &str, arguments: &[Id]) -> TokenStream {
        let (receiver, rest) = arguments.split_at(1);
        let receiver = receiver
            .iter()
            .map(|receiver| self.expression(*receiver, Precedence::Atom));
        let (name, rest) = (Ident::new(name, Span::call_site()), self.arguments(rest));
        quote!(#(#receiver)*.#name(#(#rest),*))
    }

    fn arguments(&self, arguments: &[Id]) -> Vec<TokenStream> {
        let arguments = arguments.iter();
        arguments.map(|argument| self.value(*argument)).collect()
    }
}

fn number_tokens(number: &Number) -> (TokenStream, Precedence) {
    let value = number.to_f64();
    (
        number_literal(value),
        if value < 0.0 {
            Precedence::Sign
        } else {
            Precedence::Atom
        },
    )
}
