//! Names of statements: the words of the description and of mechanics where there are some, and
//! else what is computed.

use proc_macro2::{Ident, Span};

use crate::symbolic::{Id, Node, Number};

use super::code::Body;

/// Longer names than this are replaced by the kind of operation.
const LENGTH: usize = 24;

/// A local of generated code: it does not see, and is not seen by, the names of the user.
pub fn local(name: &str) -> Ident {
    Ident::new(name, Span::mixed_site())
}

/// The name of a local after a name of the user's: in lower case, since a pattern `J` or `Some`
/// would mean a constant, if there is one; and no keyword, which `Box` would become.
pub fn local_name(name: &str) -> String {
    let name = name.to_lowercase();
    let is_word = name.bytes().all(|byte| byte.is_ascii_lowercase());
    if !is_word || syn::parse_str::<Ident>(&name).is_ok() {
        name
    } else {
        name + "_"
    }
}

/// What a plain number is called as a constant of a generic body.
fn number_name(number: &Number) -> Option<&'static str> {
    let names = [
        (Number::ratio(-1, 1), "minus_one"),
        (Number::zero(), "zero"),
        (Number::ratio(1, 2), "half"),
        (Number::ratio(1, 1), "one"),
        (Number::ratio(2, 1), "two"),
        (Number::ratio(3, 1), "three"),
        (Number::ratio(4, 1), "four"),
    ];
    let found = names.iter().find(|(known, _)| known == number);
    found.map(|(_, name)| *name)
}

impl Body<'_> {
    /// A name that no other local has.
    pub fn unique(&mut self, wanted: &str) -> Ident {
        let wanted = local_name(wanted);
        let mut name = wanted.clone();
        let mut suffix = 0;
        while !self.taken.insert(name.clone()) {
            suffix += 1;
            name = format!("{wanted}_{suffix}");
        }
        local(&name)
    }

    pub fn statement_name(&mut self, id: Id) -> Ident {
        let frames = &self.writer.work;
        let inner = match frames.graph.node(id) {
            Node::Quantity(inner) => *inner,
            _ => id,
        };
        if let Some(target) = self
            .writer
            .targets
            .get(id)
            .or_else(|| self.writer.targets.get(inner))
        {
            return target.clone();
        }
        let plain = frames.graph.as_number(id).and_then(number_name);
        let label = |id: Id| frames.labels.get(id).map(str::to_owned);
        let opposite = || {
            let mut negations = [id, inner]
                .map(|id| frames.graph.negation_of(id))
                .into_iter();
            let name = negations.find_map(|negation| label(negation?))?;
            Some(format!("minus_{name}"))
        };
        let wanted = plain
            .map(str::to_owned)
            .or_else(|| label(id))
            .or_else(|| label(inner))
            .or_else(opposite);
        let wanted = wanted.unwrap_or_else(|| self.describe(inner));
        self.unique(&wanted)
    }

    /// A name made of what is computed.
    pub fn describe(&self, id: Id) -> String {
        let graph = &self.writer.work.graph;
        let operand = |id: Id| self.names.get(&id).map(ToString::to_string);
        let (name, kind) = match *graph.node(id) {
            Node::Multiply(a, b) if a == b => {
                (operand(a).map(|a| format!("{a}_squared")), "square")
            }
            Node::Multiply(a, b) => (
                operand(a).zip(operand(b)).map(|(a, b)| format!("{a}_{b}")),
                "product",
            ),
            Node::Negate(a) => (operand(a).map(|a| format!("minus_{a}")), "opposite"),
            Node::Unary(function, a) => {
                let name = function.name();
                (operand(a).map(|a| format!("{name}_{a}")), name)
            }
            Node::Binary(function, ..) => (None, function.name()),
            Node::Add(..) => (None, "sum"),
            Node::Subtract(..) => (None, "difference"),
            Node::Divide(a, b) if graph.is_one(a) => {
                (operand(b).map(|b| format!("inverse_{b}")), "inverse")
            }
            Node::Divide(..) => (None, "ratio"),
            Node::Pivot(..) => (None, "reciprocal"),
            Node::Select(..) => (None, "choice"),
            Node::Number(_) => (None, "constant"),
            _ => (None, "condition"),
        };
        name.filter(|name| name.len() <= LENGTH)
            .unwrap_or_else(|| kind.to_owned())
    }

    /// What the group of a name is, where its first member is computed.
    pub fn note(&mut self, name: &Ident) -> Option<&'static str> {
        let (group, note) = self.writer.work.labels.note(&name.to_string())?;
        self.noted.insert(group).then_some(note)
    }
}
