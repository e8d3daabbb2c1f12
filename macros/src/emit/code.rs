//! Straight-line code: the statements and expressions of one generated function.

use std::collections::{HashMap, HashSet};

use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::{ToTokens, quote};

use crate::model::{AXES, Declared, Meaning, Model, Outline};
use crate::symbolic::{Comparison, Cost, Function, Id, Node, Number, Program, Stage};

/// Names that a function has before its first statement.
const TAKEN: [&str; 9] = [
    "self",
    "time",
    "state",
    "input",
    "acceleration",
    "reactions",
    "params",
    "math",
    "f64",
];

/// The code of one function.
pub struct Code {
    /// Reads what is given, and computes.
    pub statements: TokenStream,
    /// What was asked for.
    pub outputs: Vec<TokenStream>,
    /// What the code reads: to name arguments that it does not.
    pub reads: HashSet<Source>,
    pub cost: Cost,
    /// The statements as text, for documentation.
    pub text: Vec<String>,
}

/// Where the values of symbols come from.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Source {
    Time,
    State,
    Acceleration,
    Params,
    Input,
    Fields,
}

/// Expressions that the constructor stores, by their fields.
#[derive(Default)]
pub struct Fields(pub Vec<(Id, Ident)>);

impl Fields {
    fn get(&self, id: Id) -> Option<&Ident> {
        self.0
            .iter()
            .find(|(field, _)| *field == id)
            .map(|(_, name)| name)
    }
}

/// Writes functions of one body.
pub struct Writer<'a> {
    pub model: &'a Model,
    pub outline: &'a Outline,
    pub fields: &'a Fields,
    /// The path of what generated code may name.
    pub private: TokenStream,
}

impl Writer<'_> {
    pub fn schedule(&self, outputs: &[Id], stage: Stage) -> Program {
        self.model.frames.graph.schedule(outputs, stage)
    }

    /// The code that computes `outputs` at `stage`.
    pub fn function(&self, outputs: &[Id], stage: Stage) -> Code {
        let program = self.schedule(outputs, stage);
        let mut body = Body {
            writer: self,
            names: HashMap::new(),
            taken: TAKEN.iter().map(|name| (*name).to_owned()).collect(),
            noted: HashSet::new(),
        };
        let (reads, prologue) = body.prologue(&program);
        let mut statements = prologue;
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
        let values = program
            .outputs
            .iter()
            .map(|id| body.expression(*id, Precedence::Lowest))
            .collect();
        let cost = self.model.frames.graph.cost(&program.nodes);
        let mut code = Code {
            statements,
            outputs: values,
            reads,
            cost,
            text,
        };
        if !program.hoisted.is_empty() {
            code.reads.insert(Source::Fields);
        }
        code
    }
}

/// How tightly an expression binds, from the loosest to the tightest.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
enum Precedence {
    Lowest,
    Or,
    And,
    Comparison,
    Sum,
    Product,
    Sign,
    Atom,
}

struct Body<'a> {
    writer: &'a Writer<'a>,
    names: HashMap<Id, Ident>,
    taken: HashSet<String>,
    noted: HashSet<&'static str>,
}

fn local(name: &str) -> Ident {
    Ident::new(name, Span::mixed_site())
}

impl Body<'_> {
    fn model(&self) -> &Model {
        self.writer.model
    }

    /// A name that no other local has.
    fn unique(&mut self, wanted: &str) -> Ident {
        let mut name = wanted.to_owned();
        let mut suffix = 0;
        while !self.taken.insert(name.clone()) {
            suffix += 1;
            name = format!("{wanted}_{suffix}");
        }
        local(&name)
    }

    fn statement_name(&mut self, id: Id) -> Ident {
        let model = self.model();
        let inner = match model.frames.graph.node(id) {
            Node::Quantity(inner) => *inner,
            _ => id,
        };
        let labels = &model.frames.labels;
        let label = labels
            .get(inner)
            .or_else(|| labels.get(id))
            .map(str::to_owned);
        let opposite = || {
            labels
                .get(model.frames.graph.negation_of(id)?)
                .map(|name| format!("minus_{name}"))
        };
        let wanted = label
            .or_else(opposite)
            .unwrap_or_else(|| self.describe(inner));
        self.unique(&wanted)
    }

    /// A name made of what is computed.
    fn describe(&self, id: Id) -> String {
        let graph = &self.model().frames.graph;
        let operand = |id: Id| self.names.get(&id).map(ToString::to_string);
        let short = |name: String, otherwise: &str| {
            if name.len() <= 24 {
                name
            } else {
                otherwise.to_owned()
            }
        };
        match *graph.node(id) {
            Node::Multiply(a, b) if a == b => operand(a).map_or_else(
                || "square".to_owned(),
                |a| short(format!("{a}_squared"), "square"),
            ),
            Node::Multiply(a, b) => match (operand(a), operand(b)) {
                (Some(a), Some(b)) => short(format!("{a}_{b}"), "product"),
                _ => "product".to_owned(),
            },
            Node::Unary(function, a) => operand(a).map_or_else(
                || function.name().to_owned(),
                |a| short(format!("{}_{a}", function.name()), function.name()),
            ),
            Node::Binary(function, ..) => function.name().to_owned(),
            Node::Add(..) => "sum".to_owned(),
            Node::Subtract(..) => "difference".to_owned(),
            Node::Divide(..) => "ratio".to_owned(),
            Node::Select(..) => "choice".to_owned(),
            _ => "condition".to_owned(),
        }
    }

    /// What the group of a name is, where its first member is computed.
    fn note(&mut self, name: &Ident) -> Option<&'static str> {
        let (group, note) = self.model().frames.labels.note(&name.to_string())?;
        self.noted.insert(group).then_some(note)
    }

    /// Reads the symbols of `program`.
    fn prologue(&mut self, program: &Program) -> (HashSet<Source>, TokenStream) {
        let graph = &self.model().frames.graph;
        let symbols: Vec<(Id, Meaning)> = program
            .symbols
            .iter()
            .filter_map(|id| match graph.node(*id) {
                Node::Symbol(symbol) => Some((*id, self.model().meanings.of(*symbol))),
                _ => None,
            })
            .collect();
        let mut sources = HashSet::new();
        let mut tokens = TokenStream::new();
        let outline = self.writer.outline;
        self.struct_fields(
            &symbols,
            Source::Params,
            &outline.params,
            &mut sources,
            &mut tokens,
        );
        self.struct_fields(
            &symbols,
            Source::Input,
            &outline.inputs,
            &mut sources,
            &mut tokens,
        );
        let planar = self.model().motion.is_planar();
        let pick = |wanted: fn(Meaning) -> Option<usize>| -> Vec<(usize, Id)> {
            symbols
                .iter()
                .filter_map(|(id, meaning)| Some((wanted(*meaning)?, *id)))
                .collect()
        };
        let axes = |prefix: &str| AXES.map(|axis| format!("{prefix}{axis}"));
        let [x, y, z] = axes("q");
        let (state, acceleration) = (local("state"), local("acceleration"));
        let groups: [(Vec<(usize, Id)>, Source, TokenStream, Vec<String>); 6] = [
            (
                pick(|m| {
                    if let Meaning::Position(i) = m {
                        Some(i)
                    } else {
                        None
                    }
                }),
                Source::State,
                quote!(#state.position),
                AXES.map(str::to_owned).to_vec(),
            ),
            (
                pick(|m| {
                    if let Meaning::Quaternion(i) = m {
                        Some((i + 3) % 4)
                    } else {
                        None
                    }
                }),
                Source::State,
                quote!(#state.attitude.coords),
                vec![x, y, z, "qw".to_owned()],
            ),
            (
                pick(|m| {
                    if let Meaning::Velocity(i) = m {
                        Some(i)
                    } else {
                        None
                    }
                }),
                Source::State,
                quote!(#state.velocity),
                axes("v").to_vec(),
            ),
            (
                pick(|m| {
                    if let Meaning::AngularVelocity(i) = m {
                        Some(i)
                    } else {
                        None
                    }
                }),
                Source::State,
                quote!(#state.angular_velocity),
                axes("w").to_vec(),
            ),
            (
                pick(|m| {
                    if let Meaning::LinearAcceleration(i) = m {
                        Some(i)
                    } else {
                        None
                    }
                }),
                Source::Acceleration,
                quote!(#acceleration.linear),
                axes("a").to_vec(),
            ),
            (
                pick(|m| {
                    if let Meaning::AngularAcceleration(i) = m {
                        Some(i)
                    } else {
                        None
                    }
                }),
                Source::Acceleration,
                quote!(#acceleration.angular),
                axes("alpha_").to_vec(),
            ),
        ];
        for (found, source, place, names) in groups {
            if found.is_empty() {
                continue;
            }
            sources.insert(source);
            let place = self.acceleration_place(place, source);
            let is_scalar = planar && matches!(names[0].as_str(), "wx" | "alpha_x");
            let wanted = if planar && !is_scalar {
                &names[..2]
            } else {
                &names[..]
            };
            tokens.extend(self.read_components(&found, &place, wanted, is_scalar));
        }
        for (id, meaning) in &symbols {
            match meaning {
                Meaning::Time => {
                    sources.insert(Source::Time);
                    self.names.insert(*id, local("time"));
                }
                Meaning::Angle => {
                    sources.insert(Source::State);
                    let name = self.unique("angle");
                    tokens.extend(quote!(let #name = #state.angle;));
                    self.names.insert(*id, name);
                }
                _ => {}
            }
        }
        (sources, tokens)
    }

    /// Accelerations of motions with one kind of coordinate are not in a struct.
    fn acceleration_place(&self, place: TokenStream, source: Source) -> TokenStream {
        let motion = self.model().motion;
        let both = motion.has_attitude() && motion.has_position();
        if source == Source::Acceleration && !both {
            let acceleration = local("acceleration");
            quote!((*#acceleration))
        } else {
            place
        }
    }

    /// `let [x, _, z]: [f64; 3] = place.into();`
    fn read_components(
        &mut self,
        found: &[(usize, Id)],
        place: &TokenStream,
        names: &[String],
        is_scalar: bool,
    ) -> TokenStream {
        if is_scalar {
            let name = self.unique(names[0].trim_end_matches('x').trim_end_matches('_'));
            self.names.insert(found[0].1, name.clone());
            return quote!(let #name = #place;);
        }
        let mut pattern = Vec::new();
        for (i, wanted) in names.iter().enumerate() {
            match found.iter().find(|(component, _)| *component == i) {
                Some((_, id)) => {
                    let name = self.unique(wanted);
                    self.names.insert(*id, name.clone());
                    pattern.push(name.into_token_stream());
                }
                None => pattern.push(quote!(_)),
            }
        }
        let count = Literal::usize_unsuffixed(names.len());
        quote!(let [#(#pattern),*]: [f64; #count] = #place.into();)
    }

    /// `let Params { arm, .. } = self.params;`, and the components of vectors among them.
    fn struct_fields(
        &mut self,
        symbols: &[(Id, Meaning)],
        source: Source,
        declared: &[Declared],
        sources: &mut HashSet<Source>,
        tokens: &mut TokenStream,
    ) {
        let of = |meaning: Meaning| match (meaning, source) {
            (Meaning::Param(index, component), Source::Params)
            | (Meaning::Input(index, component), Source::Input) => Some((index, component)),
            _ => None,
        };
        let (mut pattern, mut components) = (Vec::new(), TokenStream::new());
        for (index, declaration) in declared.iter().enumerate() {
            let used: Vec<(usize, Id)> = symbols
                .iter()
                .filter_map(|(id, meaning)| {
                    of(*meaning)
                        .filter(|(found, _)| *found == index)
                        .map(|(_, component)| (component.unwrap_or(0), *id))
                })
                .collect();
            if used.is_empty() {
                continue;
            }
            let word = declaration.name.to_string();
            let name = self.unique(&word);
            let field = Ident::new(&word, Span::mixed_site());
            pattern.push(if name == field {
                quote!(#field)
            } else {
                quote!(#field: #name)
            });
            if declaration.frame.is_some() {
                let axes = self.model().motion.axes();
                let names: Vec<String> = AXES[..axes]
                    .iter()
                    .map(|axis| format!("{name}_{axis}"))
                    .collect();
                components.extend(self.read_components(
                    &used,
                    &name.into_token_stream(),
                    &names,
                    false,
                ));
            } else {
                self.names.insert(used[0].1, name);
            }
        }
        if pattern.is_empty() {
            return;
        }
        sources.insert(source);
        if pattern.len() < declared.len() {
            pattern.push(quote!(..));
        }
        let body = &self.writer.outline.name;
        let (suffix, place) = match source {
            Source::Params => ("Params", quote!(self.params)),
            _ => {
                let input = local("input");
                ("Input", quote!(*#input))
            }
        };
        let kind = Ident::new(&format!("{body}{suffix}"), body.span());
        tokens.extend(quote!(let #kind { #(#pattern),* } = #place; #components));
    }

    /// The right-hand side of a statement.
    fn definition(&self, id: Id) -> TokenStream {
        match *self.model().frames.graph.node(id) {
            Node::Quantity(inner) => self.expression(inner, Precedence::Lowest),
            _ => self.operation(id).0,
        }
    }

    /// An expression where something binding as tightly as `outer` is expected.
    fn expression(&self, id: Id, outer: Precedence) -> TokenStream {
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
        match self.model().frames.graph.node(id) {
            // another name for what is a statement already
            Node::Quantity(inner) => self.operand(*inner),
            _ => self.operation(id),
        }
    }

    fn operation(&self, id: Id) -> (TokenStream, Precedence) {
        let infix =
            |a: Id, operator: TokenStream, b: Id, precedence: Precedence, tighter: Precedence| {
                let (a, b) = (self.expression(a, precedence), self.expression(b, tighter));
                (quote!(#a #operator #b), precedence)
            };
        let graph = &self.model().frames.graph;
        match *graph.node(id) {
            Node::Number(ref number) => number_tokens(number),
            Node::Truth(value) => (value.into_token_stream(), Precedence::Atom),
            Node::Undefined | Node::Symbol(_) => (quote!(f64::NAN), Precedence::Atom),
            Node::Quantity(inner) => self.operand(inner),
            Node::Negate(a) => match *graph.node(a) {
                // -(x - y), written as it is read
                Node::Subtract(x, y) if !self.names.contains_key(&a) => {
                    infix(y, quote!(-), x, Precedence::Sum, Precedence::Product)
                }
                _ => {
                    let a = self.expression(a, Precedence::Sign);
                    (quote!(-#a), Precedence::Sign)
                }
            },
            Node::Add(a, b) => {
                let (a, b) = if self.comes_second(a, b) {
                    (b, a)
                } else {
                    (a, b)
                };
                match graph.as_number(b).filter(|number| number.is_negative()) {
                    Some(number) => {
                        let (a, b) = (
                            self.expression(a, Precedence::Sum),
                            number_tokens(&number.abs()).0,
                        );
                        (quote!(#a - #b), Precedence::Sum)
                    }
                    None => infix(a, quote!(+), b, Precedence::Sum, Precedence::Product),
                }
            }
            Node::Subtract(a, b) => infix(a, quote!(-), b, Precedence::Sum, Precedence::Product),
            Node::Multiply(a, b) => infix(a, quote!(*), b, Precedence::Product, Precedence::Sign),
            Node::Divide(a, b) => infix(a, quote!(/), b, Precedence::Product, Precedence::Sign),
            Node::Unary(function, a) => (self.call(function, &[a]), Precedence::Atom),
            Node::Binary(function, a, b) => (self.call(function, &[a, b]), Precedence::Atom),
            Node::Compare(comparison, a, b) => {
                let operator = match comparison {
                    Comparison::Less => quote!(<),
                    Comparison::LessOrEqual => quote!(<=),
                    Comparison::Equal => quote!(==),
                    Comparison::NotEqual => quote!(!=),
                };
                infix(a, operator, b, Precedence::Comparison, Precedence::Sum)
            }
            Node::And(a, b) => infix(a, quote!(&&), b, Precedence::And, Precedence::Comparison),
            Node::Or(a, b) => infix(a, quote!(||), b, Precedence::Or, Precedence::And),
            Node::Not(a) => {
                let a = self.expression(a, Precedence::Atom);
                (quote!(!#a), Precedence::Sign)
            }
            Node::Select(condition, a, b) => {
                let condition = self.expression(condition, Precedence::Lowest);
                let (a, b) = (
                    self.expression(a, Precedence::Lowest),
                    self.expression(b, Precedence::Lowest),
                );
                // alone on the right of a statement, or in parentheses
                (quote!(if #condition { #a } else { #b }), Precedence::Lowest)
            }
        }
    }

    /// In a sum of which the order does not matter: what is known early stands last, and what is
    /// itself a sum stands first, so that it needs no parentheses.
    fn comes_second(&self, a: Id, b: Id) -> bool {
        let graph = &self.model().frames.graph;
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

    fn call(&self, function: Function, arguments: &[Id]) -> TokenStream {
        let name = Ident::new(function.name(), Span::call_site());
        let arguments = arguments
            .iter()
            .map(|argument| self.expression(*argument, Precedence::Lowest));
        let private = &self.writer.private;
        quote!(#private::math::#name(#(#arguments),*))
    }
}

/// A double, as the shortest literal that reads back as it.
pub fn number_literal(value: f64) -> TokenStream {
    let magnitude = value.abs();
    let plain = magnitude == 0.0 || (1e-5..1e16).contains(&magnitude);
    let mut text = if plain {
        format!("{magnitude}")
    } else {
        format!("{magnitude:e}")
    };
    if !text.contains(['.', 'e']) {
        text.push_str(".0");
    }
    let literal: Literal = text
        .parse()
        .unwrap_or_else(|_| Literal::f64_unsuffixed(0.0));
    if value < 0.0 {
        quote!(-#literal)
    } else {
        quote!(#literal)
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

/// Tokens as a line of text, for documentation.
fn to_text(tokens: &TokenStream) -> String {
    use proc_macro2::{Delimiter, Spacing, TokenTree};
    let mut text = String::new();
    let mut pending: Vec<TokenTree> = tokens
        .clone()
        .into_iter()
        .collect::<Vec<_>>()
        .into_iter()
        .rev()
        .collect();
    let mut closing: Vec<(usize, &str)> = Vec::new();
    let mut tight = true;
    while let Some(token) = pending.pop() {
        match token {
            TokenTree::Group(group) => {
                let (open, close) = match group.delimiter() {
                    Delimiter::Brace => ("{ ", " }"),
                    Delimiter::Bracket => ("[", "]"),
                    _ => ("(", ")"),
                };
                let called = text.ends_with(|last: char| last.is_alphanumeric() || last == '_')
                    && group.delimiter() == Delimiter::Parenthesis;
                if !tight && !called {
                    text.push(' ');
                }
                text.push_str(open);
                closing.push((pending.len(), close));
                pending.extend(
                    group
                        .stream()
                        .into_iter()
                        .collect::<Vec<_>>()
                        .into_iter()
                        .rev(),
                );
                tight = true;
            }
            TokenTree::Punct(punct) => {
                let mark = punct.as_char();
                let glued = matches!(mark, '.' | ':' | ',') || tight;
                if !glued {
                    text.push(' ');
                }
                text.push(mark);
                let sign = tight && matches!(mark, '-' | '!');
                tight = matches!(mark, '.' | ':') || sign || punct.spacing() == Spacing::Joint;
            }
            other => {
                if !tight {
                    text.push(' ');
                }
                text.push_str(&other.to_string());
                tight = false;
            }
        }
        while closing
            .last()
            .is_some_and(|(left, _)| *left == pending.len())
        {
            text.push_str(closing.pop().map_or("", |(_, close)| close));
            tight = false;
        }
    }
    // `$crate::private::math::sin(x)` and `self.inverse_mass` are read better without their paths
    let text = text
        .rsplit_once("private::math::")
        .map_or(text.clone(), |_| {
            let mut cleaned = String::new();
            let mut rest = text.as_str();
            while let Some((before, after)) = rest.split_once("private::math::") {
                cleaned.push_str(before.trim_end_matches(|c: char| {
                    c.is_alphanumeric() || matches!(c, '_' | ':' | '$')
                }));
                rest = after;
            }
            cleaned + rest
        });
    text.replace("self.", "")
}
