//! Straight-line code: the statements of one generated function, and what it returns.

use std::collections::{HashMap, HashSet};

use proc_macro2::{Ident, TokenStream};
use quote::quote;

use crate::model::{Model, Outline};
use crate::symbolic::{Cost, Id, Program, Stage};

use super::expression::Precedence;
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
    /// The statements as text, for documentation.
    pub text: Vec<String>,
}

/// Where the values of symbols come from.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Source {
    Time,
    State,
    Acceleration,
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
    pub outline: &'a Outline,
    pub fields: &'a Fields,
    pub stage: Stage,
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
}

impl Writer<'_> {
    pub fn schedule(&self, outputs: &[Id]) -> Program {
        self.model.frames.graph.schedule(outputs, self.stage)
    }

    /// The code that computes `outputs`.
    pub fn function(&self, outputs: &[Id]) -> Code {
        let program = self.schedule(outputs);
        let mut body = Body {
            writer: self,
            names: HashMap::new(),
            taken: TAKEN.iter().map(|name| (*name).to_owned()).collect(),
            noted: HashSet::new(),
            reads: Vec::new(),
        };
        let mut statements = body.read(&program);
        let mut text = Vec::new();
        for &id in &program.statements {
            let name = body.statement_name(id);
            let value = body.definition(id);
            let note = body.note(&name);
            text.extend(note.iter().map(|note| format!("# {note}")));
            text.push(format!("{name} = {}", to_text(&value)));
            let note = note.map(|note| format!(" {note}"));
            let note = note.iter();
            statements.extend(quote!(#(#[doc = #note])* let #name = #value;));
            body.names.insert(id, name);
        }
        let outputs = program
            .outputs
            .iter()
            .map(|id| body.expression(*id, Precedence::Lowest));
        Code {
            statements,
            outputs: outputs.collect(),
            cost: self.model.frames.graph.cost(&program.nodes),
            has_notes: !body.noted.is_empty(),
            reads: body.reads,
            text,
        }
    }
}
