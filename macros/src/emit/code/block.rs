//! A block of code while it is written, and the names in it: words of the description and of
//! mechanics if there are any, otherwise descriptions of the computation.

use std::cell::RefCell;
use std::collections::{BTreeSet, HashSet};

use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote;

use crate::model::{Meaning, Workspace};
use crate::symbolic::{Id, Node, Number, ShortMap};

use super::naming::{Names, local};
use super::writer::{Source, Writer};

/// A longer name is replaced by the kind of operation.
const LENGTH: usize = 24;

/// The statements of a function, while they are written.
pub struct Block<'a> {
    pub writer: &'a Writer<'a>,
    pub names: ShortMap<Id, Ident>,
    pub taken: Names,
    pub noted: HashSet<&'static str>,
    pub reads: Vec<Source>,
    /// Whether it is written for any scalar, so that constants are statements.
    pub is_generic: bool,
    /// The numbers that occur in it.
    pub numbers: RefCell<BTreeSet<Id>>,
}

impl<'a> Block<'a> {
    pub fn new(writer: &'a Writer<'a>, is_generic: bool) -> Self {
        Self {
            writer,
            names: ShortMap::default(),
            taken: writer.taken(),
            noted: HashSet::new(),
            reads: Vec::new(),
            is_generic,
            numbers: RefCell::default(),
        }
    }
}

impl Block<'_> {
    /// A name that no other local has.
    pub fn unique(&mut self, wanted: &str) -> Ident {
        self.taken.unique(wanted)
    }

    /// The name of a statement.
    pub fn statement_name(&mut self, id: Id) -> Ident {
        self.name_of(id, &[])
    }

    /// The name of a statement whose value `copies` have, too.
    pub fn name_of(&mut self, id: Id, copies: &[Id]) -> Ident {
        let work = &self.writer.work;
        let inner = match work.graph.node(id) {
            Node::Quantity(inner) => *inner,
            _ => id,
        };
        // the same expression, as a statement or not: a statement has the better name, unless it is
        // the sine or cosine of an angle
        let mut alike = [&[id, inner], copies].concat();
        alike.extend(work.graph.quantity_of(inner));
        if work.graph.other_half(inner).is_none() {
            alike.sort_by_key(|id| !matches!(work.graph.node(*id), Node::Quantity(_)));
        }
        let targets = self.writer.targets;
        if let Some(target) = alike.iter().find_map(|id| targets.get(*id)) {
            return target.clone();
        }
        let plain = work.graph.as_number(id).and_then(number_name);
        let label = |id: Id| {
            let forms = [Some(id), work.graph.quantity_of(id)];
            let mut forms = forms.into_iter().flatten();
            forms.find_map(|id| work.labels.get(id))
        };
        let opposite = |id: Id| Some(format!("minus_{}", label(work.graph.negation_of(id)?)?));
        let mut alike = alike.into_iter();
        let wanted = plain
            .or_else(|| alike.clone().find_map(label))
            .map(str::to_owned)
            .or_else(|| alike.find_map(opposite));
        let wanted = wanted.unwrap_or_else(|| self.describe(inner));
        self.unique(&wanted)
    }

    /// A name that describes a computation.
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
            Node::Pivot(a, _) => (operand(a).map(|a| format!("inverse_{a}")), "inverse"),
            Node::Positive(_) => (None, "positive"),
            Node::Foreign(function, _) => {
                let functions = &self.writer.work.functions;
                (functions[function.number()].word(function), "value")
            }
            Node::Select(..) => (None, "choice"),
            Node::Number(_) => (None, "constant"),
            _ => (None, "condition"),
        };
        name.filter(|name| name.len() <= LENGTH)
            .unwrap_or_else(|| kind.to_owned())
    }

    /// `let vx = state[7];`, if state and input are arrays.
    pub fn read_arrays(&mut self, symbols: &[(Id, Meaning)]) -> TokenStream {
        let outline = self.writer.outline;
        let (state, input) = (outline.numbers_of_state(), outline.numbers_of_input());
        let mut tokens = TokenStream::new();
        for (id, meaning) in symbols {
            if *meaning == Meaning::Time {
                self.reads.push(Source::Time);
                self.names.insert(*id, local("time"));
                continue;
            }
            let given = input.iter().position(|(_, known)| known == meaning);
            let (source, array, place, name) = match (outline.number_of_state(*meaning), given) {
                (Some(place), _) => (Source::State, "state", place, &state[place]),
                (None, Some(place)) => (Source::Input, "input", place, &input[place].0),
                (None, None) => continue,
            };
            let (name, array) = (self.unique(name), local(array));
            let place = Literal::usize_unsuffixed(place);
            tokens.extend(quote!(let #name = #array[#place];));
            self.reads.push(source);
            self.names.insert(*id, name);
        }
        tokens
    }

    /// What the group that a statement belongs to means; given only for its first member.
    pub fn note(&mut self, id: Id, copies: &[Id], name: &Ident) -> Option<&'static str> {
        let Workspace { labels, graph, .. } = self.writer.work;
        let inner = match graph.node(id) {
            Node::Quantity(inner) => *inner,
            _ => id,
        };
        let alike = [copies, &[id, inner]].concat().into_iter();
        let opposite = alike.clone().filter_map(|id| graph.negation_of(id));
        let mut all = alike.clone().chain(opposite);
        let meaning = all.find_map(|id| labels.meaning(id));
        let (group, note) = match meaning {
            Some(meaning) => (meaning, meaning),
            None => labels.note(&name.to_string())?,
        };
        self.noted.insert(group).then_some(note)
    }
}

/// The name that a plain number gets as a constant of a generic body.
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
