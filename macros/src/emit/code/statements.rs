//! Straight-line code: the statements of one generated function, and its result.

use std::collections::BTreeSet;

use proc_macro2::{Ident, TokenStream};
use quote::quote;

use crate::model::Meaning;
use crate::symbolic::{Comparison, Cost, Function, Id, Node, Program};

use super::block::Block;
use super::text::code_text;
use super::writer::{Source, Writer};

/// If there are more statements than `LONG`, their names are declared in groups of `GROUP`.
const LONG: usize = 2048;
const GROUP: usize = 256;

/// The code of one function.
pub struct Code {
    /// Statements that read the arguments and compute.
    pub statements: TokenStream,
    /// The requested outputs.
    pub outputs: Vec<TokenStream>,
    pub facts: Facts,
}

/// What is known about code.
#[derive(Default)]
pub struct Facts {
    /// Where it reads values from. Arguments that it does not read get an underscore.
    pub reads: Vec<Source>,
    pub cost: Cost,
    /// Whether statements carry notes.
    pub has_notes: bool,
    /// Whether numbers are compared for equality.
    pub has_equality: bool,
    /// Whether conditions are combined, perhaps to a range.
    pub has_combined: bool,
    pub guards: Guards,
    /// The names of the symbols that it reads.
    pub symbols: Vec<(String, Meaning)>,
    /// The statements as text, for the documentation.
    pub text: Vec<String>,
    /// The requested outputs as text.
    pub output_text: Vec<String>,
}

/// The guards in code. If one fails, the result is NaN.
#[derive(Clone, Copy, Default)]
pub struct Guards {
    /// Whether it divides by something that may vanish.
    pub pivots: bool,
    /// Whether it checks positive quantities that change, such as masses.
    pub positives: bool,
}

/// One statement: its name, its value, and its documentation.
struct Line {
    left: TokenStream,
    right: TokenStream,
    note: Option<String>,
}

/// `let a = ..; let b = ..;`, or, if there are many, `let (a, b); a = ..; b = ..;`. Each `let`
/// opens a scope inside the previous one, and the debug information for thousands of scopes
/// overflows the stack of the compiler.
fn written(lines: &[Line]) -> TokenStream {
    if lines.len() <= LONG {
        let lines = lines.iter().map(|Line { left, right, note }| {
            let note = note.iter();
            quote!(#(#[doc = #note])* let #left = #right;)
        });
        return lines.collect();
    }
    let groups = lines.chunks(GROUP).map(|group| {
        let left: Vec<_> = group.iter().map(|line| &line.left).collect();
        let right = group.iter().map(|line| &line.right);
        quote!(let (#(#left,)*); #(#left = #right;)*)
    });
    groups.collect()
}

impl Writer<'_> {
    /// The code that computes `outputs`. The code of a generic body has a line for each constant,
    /// but the text is that of the same code for `f64`.
    pub fn function(&self, outputs: &[Id]) -> Code {
        let program = self.schedule(outputs);
        let (plain, numbers) = self.write(&program, None);
        if !self.shapes.scalar.is_generic() {
            return plain;
        }
        let (mut generic, _) = self.write(&program, Some(&numbers));
        generic.facts.text = plain.facts.text;
        generic.facts.output_text = plain.facts.output_text;
        generic
    }

    /// The code of a program, and the numbers in it. With `constants`, it is written for any
    /// scalar.
    fn write(&self, program: &Program, constants: Option<&BTreeSet<Id>>) -> (Code, BTreeSet<Id>) {
        let mut block = Block::new(self, constants.is_some());
        let mut statements = block.read(program);
        if let Some(constants) = constants {
            statements.extend(block.constants(constants));
        }
        let (computed, text) = block.statements(program, |_| true);
        statements.extend(computed);
        let graph = &self.work.graph;
        let has =
            |wanted: fn(&Node) -> bool| program.nodes.iter().any(|id| wanted(graph.node(*id)));
        let outputs = program.outputs.iter();
        let outputs: Vec<TokenStream> = outputs.map(|id| block.value(*id)).collect();
        let symbols = program.symbols.iter().filter_map(|id| {
            let name = block.names.get(id)?;
            Some((name.to_string(), self.work.meaning(*id)?))
        });
        let facts = Facts {
            symbols: symbols.collect(),
            output_text: outputs.iter().map(code_text).collect(),
            cost: graph.cost(&program.nodes),
            has_notes: !block.noted.is_empty(),
            guards: Guards {
                pivots: has(|node| matches!(node, Node::Pivot(..))),
                positives: has(|node| matches!(node, Node::Positive(_))),
            },
            has_equality: has(|node| {
                matches!(
                    node,
                    Node::Compare(Comparison::Equal | Comparison::NotEqual, ..)
                )
            }),
            has_combined: has(|node| matches!(node, Node::And(..) | Node::Or(..))),
            reads: block.reads,
            text,
        };
        let code = Code {
            statements,
            outputs,
            facts,
        };
        (code, block.numbers.into_inner())
    }
}

impl Block<'_> {
    /// The statements of `program` that are due and have no name yet, as code and as text.
    pub fn statements(
        &mut self,
        program: &Program,
        is_due: impl Fn(Id) -> bool,
    ) -> (TokenStream, Vec<String>) {
        let (mut lines, mut text) = (Vec::new(), Vec::new());
        for &id in program.statements.iter().filter(|id| is_due(**id)) {
            if self.names.contains_key(&id) {
                continue;
            }
            let copies = program.values.copies_of(id);
            let name = self.name_of(id, copies);
            let note = self.note(id, copies, &name);
            text.extend(note.iter().map(|note| format!("# {note}")));
            let copied = copies.iter().map(|copy| (*copy, name.clone()));
            let copied: Vec<(Id, Ident)> = copied.collect();
            let (left, right) = self.statement(id, name, program);
            self.names.extend(copied);
            text.push(format!("{} = {}", code_text(&left), code_text(&right)));
            let note = note.map(|note| format!(" {note}"));
            lines.push(Line { left, right, note });
        }
        (written(&lines), text)
    }

    /// The left and the right side of a statement. A sine and a cosine of the same angle share one.
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
            let private = &self.writer.shapes.private;
            let angle = self.value(*angle);
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
