//! Straight-line code: the statements of one generated function, and what it returns.

use std::cell::RefCell;
use std::collections::{BTreeSet, HashMap, HashSet};

use proc_macro2::{Ident, TokenStream};
use quote::quote;

use crate::model::{Model, Outline, Workspace};
use crate::symbolic::{Comparison, Cost, Function, Id, Node, Program, Stage};

use super::expression::Precedence;
use super::scalar::Scalar;
use super::text::to_text;

/// Names that a function has before its first statement.
const TAKEN: [&str; 8] = [
    "self",
    "time",
    "state",
    "input",
    "acceleration",
    "reactions",
    "params",
    "f64",
];

/// The code of one function.
pub struct Code {
    /// Reads what is given, and computes.
    pub statements: TokenStream,
    /// What was asked for.
    pub outputs: Vec<TokenStream>,
    /// What the code reads: to name arguments that it does not.
    pub reads: Vec<Source>,
    pub cost: Cost,
    /// Whether statements carry notes.
    pub has_notes: bool,
    /// Whether numbers are compared for equality.
    pub has_equality: bool,
    /// Whether it divides by what may vanish.
    pub has_pivots: bool,
    /// The statements as text, for documentation.
    pub text: Vec<String>,
    /// What was asked for as text.
    pub output_text: Vec<String>,
}

/// Where the values of symbols come from.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Source {
    Time,
    State,
    Acceleration,
    Reactions,
    Params,
    Input,
}

/// Expressions that the constructor stores, by their fields.
#[derive(Default)]
pub struct Fields(pub Vec<(Id, Ident)>);

impl Fields {
    pub fn get(&self, id: Id) -> Option<&Ident> {
        self.0
            .iter()
            .find(|(field, _)| *field == id)
            .map(|(_, name)| name)
    }
}

/// Writes the functions of one body that run at one stage.
pub struct Writer<'a> {
    pub model: &'a Model,
    pub work: &'a Workspace,
    pub outline: &'a Outline,
    /// What the constructor has stored, to be read.
    pub fields: &'a Fields,
    /// What the constructor is to store, to be computed under these names.
    pub targets: &'a Fields,
    pub stage: Stage,
    /// Whether the functions return a `Result`, so that a division that cannot be done ends them;
    /// it panics in the others.
    pub is_fallible: bool,
    /// Whether they compute all that is not stored, for functions that are seldom called.
    pub is_whole: bool,
    /// Whether the functions are given a state.
    pub has_state: bool,
    /// What the numbers are.
    pub scalar: Scalar,
    /// The path of what generated code may name.
    pub private: TokenStream,
}

/// A function while it is written.
pub struct Body<'a> {
    pub writer: &'a Writer<'a>,
    pub names: HashMap<Id, Ident>,
    pub taken: HashSet<String>,
    pub noted: HashSet<&'static str>,
    pub reads: Vec<Source>,
    /// Whether it is written for any scalar, whose constants are statements.
    pub is_generic: bool,
    /// The numbers that it has.
    pub numbers: RefCell<BTreeSet<Id>>,
}

impl Writer<'_> {
    pub fn schedule(&self, outputs: &[Id]) -> Program {
        let graph = &self.work.graph;
        if self.is_whole {
            return graph.schedule_where(outputs, |id| self.fields.get(id).is_none());
        }
        graph.schedule(outputs, self.stage)
    }

    /// Names that are not there for statements: those of arguments, and those of fields, which are
    /// told from statements by `self` in the code and by nothing in its text, or which the
    /// constructor is yet to compute.
    fn taken(&self) -> HashSet<String> {
        let fields = self.fields.0.iter().chain(&self.targets.0);
        let fields = fields.map(|(_, name)| name.to_string());
        TAKEN
            .iter()
            .map(|name| (*name).to_owned())
            .chain(fields)
            .collect()
    }

    /// The code that computes `outputs`. That of a generic body has a line for each constant; its text
    /// is that of the same code for `f64`.
    pub fn function(&self, outputs: &[Id]) -> Code {
        let program = self.schedule(outputs);
        let (plain, numbers) = self.write(&program, None);
        if !self.scalar.is_generic() {
            return plain;
        }
        let (generic, _) = self.write(&program, Some(&numbers));
        Code {
            text: plain.text,
            output_text: plain.output_text,
            ..generic
        }
    }

    /// The code of a program, and the numbers in it; with `constants`, for any scalar.
    fn write(&self, program: &Program, constants: Option<&BTreeSet<Id>>) -> (Code, BTreeSet<Id>) {
        let mut body = Body::new(self, constants.is_some());
        let mut statements = body.read(program);
        if let Some(constants) = constants {
            statements.extend(body.constants(constants));
        }
        let (computed, text) = body.statements(program, |_| true);
        statements.extend(computed);
        let graph = &self.work.graph;
        let compares_equality = |id: &Id| {
            matches!(
                graph.node(*id),
                Node::Compare(Comparison::Equal | Comparison::NotEqual, ..)
            )
        };
        let outputs: Vec<TokenStream> = program
            .outputs
            .iter()
            .map(|id| body.expression(*id, Precedence::Lowest))
            .collect();
        let code = Code {
            statements,
            output_text: outputs.iter().map(to_text).collect(),
            outputs,
            cost: self.work.graph.cost(&program.nodes),
            has_notes: !body.noted.is_empty(),
            has_pivots: program
                .nodes
                .iter()
                .any(|id| matches!(graph.node(*id), Node::Pivot(..))),
            has_equality: program.nodes.iter().any(compares_equality),
            reads: body.reads,
            text,
        };
        (code, body.numbers.into_inner())
    }
}

impl<'a> Body<'a> {
    pub fn new(writer: &'a Writer<'a>, is_generic: bool) -> Self {
        Self {
            writer,
            names: HashMap::new(),
            taken: writer.taken(),
            noted: HashSet::new(),
            reads: Vec::new(),
            is_generic,
            numbers: RefCell::default(),
        }
    }

    /// The statements of `program` that are due and have no name yet, as code and as text.
    pub fn statements(
        &mut self,
        program: &Program,
        is_due: impl Fn(Id) -> bool,
    ) -> (TokenStream, Vec<String>) {
        let (mut statements, mut text) = (TokenStream::new(), Vec::new());
        for &id in program.statements.iter().filter(|id| is_due(**id)) {
            if self.names.contains_key(&id) {
                continue;
            }
            let name = self.statement_name(id);
            let note = self.note(&name);
            text.extend(note.iter().map(|note| format!("# {note}")));
            let (left, right) = self.statement(id, name, program);
            text.push(format!("{} = {}", to_text(&left), to_text(&right)));
            let note = note.map(|note| format!(" {note}"));
            let note = note.iter();
            statements.extend(quote!(#(#[doc = #note])* let #left = #right;));
        }
        (statements, text)
    }

    /// What is assigned, and its value; a sine and a cosine of the same angle are computed together.
    fn statement(&mut self, id: Id, name: Ident, program: &Program) -> (TokenStream, TokenStream) {
        let graph = &self.writer.work.graph;
        let pair = graph
            .other_half(id)
            .filter(|other| program.statements.contains(other));
        let (Some(other), Node::Unary(function, angle)) = (pair, graph.node(id)) else {
            let value = self.definition(id);
            let left = quote!(#name);
            self.names.insert(id, name);
            return (left, value);
        };
        let second = self.statement_name(other);
        let value = if self.is_generic {
            self.method("sin_cos", &[*angle])
        } else {
            let private = &self.writer.private;
            let angle = self.expression(*angle, Precedence::Lowest);
            quote!(#private::math::sin_cos(#angle))
        };
        let (sine, cosine) = if *function == Function::Sin {
            (&name, &second)
        } else {
            (&second, &name)
        };
        let tokens = (quote!((#sine, #cosine)), value);
        self.names.extend([(id, name), (other, second)]);
        tokens
    }
}
