//! `compose([part, part])`: a body composed of parts.

use proc_macro2::{Delimiter, Group, Ident, TokenTree};

use crate::errors::{Errors, Extent};

use crate::syntax::Value;
use crate::syntax::expression::{Expression, Kind};
use crate::syntax::tokens::{Entry, bracketed, split, stream, without_attributes};

/// The parts of a body.
#[derive(Clone)]
pub struct Composition {
    pub word: Ident,
    /// `None` stands for an unreadable part, which is reported.
    pub parts: Vec<Option<Part>>,
}

/// `form.mass(mass).at(point)`
#[derive(Clone)]
pub struct Part {
    pub form: Expression,
    /// The argument of `.mass(..)`, if given.
    pub mass: Option<Value>,
    /// The argument of `.at(..)`, if given.
    pub point: Option<Value>,
}

impl Composition {
    /// Reads `compose([..])`, if `tokens` begin with it.
    pub fn parse(tokens: &[TokenTree], errors: &mut Errors) -> Option<Self> {
        let (word, rest) = match tokens {
            [TokenTree::Ident(word), rest @ ..] if word == "compose" => (word, rest),
            _ => return None,
        };
        let (list, rest) = match rest {
            [TokenTree::Group(arguments), rest @ ..] => (parse_list(arguments), rest),
            _ => (None, &[][..]),
        };
        if !rest.is_empty() {
            errors.push(
                Extent::of(stream(rest)),
                "`compose([..])` gives the mass, G and the inertia about G: nothing follows it",
            );
        }
        let mut parts = Vec::new();
        if let Some(list) = list {
            for entry in split(list.stream(), Entry::Defined, errors) {
                let part = without_attributes(&entry, errors);
                let part = Expression::parse(stream(part), errors);
                parts.push(part.map(|part| Part::parse(part, errors)));
            }
        }
        if parts.is_empty() {
            errors.push(
                word.span(),
                "a body is composed of a list of parts: write `compose([sphere(0.1[m]).mass(1[kg]), ..])`",
            );
            parts.push(None);
        }
        Some(Self {
            word: word.clone(),
            parts,
        })
    }

    /// All expressions written in its parts.
    pub fn expressions(&self) -> impl Iterator<Item = &Expression> {
        self.parts.iter().flatten().flat_map(|part| {
            let others = part.mass.iter().chain(&part.point).flatten();
            core::iter::once(&part.form).chain(others)
        })
    }
}

/// The list in `([..])`.
fn parse_list(arguments: &Group) -> Option<Group> {
    let tokens: Vec<TokenTree> = arguments.stream().into_iter().collect();
    let list = bracketed(&tokens).cloned();
    list.filter(|_| arguments.delimiter() == Delimiter::Parenthesis)
}

impl Part {
    /// Takes `.mass(..)` and `.at(..)` out of the methods after a form.
    fn parse(written: Expression, errors: &mut Errors) -> Self {
        let (mut mass, mut point) = (None, None);
        let mut others = Vec::new();
        let mut form = written;
        loop {
            let Expression { kind, extent } = form;
            match kind {
                Kind::Method(inner, method, arguments) if method == "mass" => {
                    take(&mut mass, &method, arguments, "`.mass(1[kg])`", errors);
                    form = *inner;
                }
                Kind::Method(inner, method, arguments) if method == "at" => {
                    take(&mut point, &method, arguments, "`.at(P)`", errors);
                    form = *inner;
                }
                Kind::Method(inner, method, arguments) => {
                    others.push((method, arguments, extent));
                    form = *inner;
                }
                kind => {
                    form = Expression { kind, extent };
                    break;
                }
            }
        }
        for (method, arguments, extent) in others.into_iter().rev() {
            let kind = Kind::Method(Box::new(form), method, arguments);
            form = Expression { kind, extent };
        }
        Self { form, mass, point }
    }
}

/// Stores the argument of a method that takes exactly one and may occur only once.
fn take(
    into: &mut Option<Value>,
    method: &Ident,
    mut arguments: Vec<Expression>,
    example: &str,
    errors: &mut Errors,
) {
    if into.is_some() {
        errors.push(
            method.span(),
            format!("a part has one `.{method}(..)`: leave one of them out"),
        );
    } else if arguments.len() == 1 {
        *into = Some(arguments.pop());
    } else {
        errors.push(
            method.span(),
            format!("`.{method}` takes one argument: write {example}"),
        );
        *into = Some(None);
    }
}
