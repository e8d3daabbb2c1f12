//! The first lines of a function. They read the parameters, inputs and parts of the state that the
//! function needs, and no others.

use std::collections::BTreeSet;

use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::{ToTokens, format_ident, quote};

use crate::families::LoadKind;
use crate::model::{AXES, Declared, Meaning, Outline};
use crate::symbolic::{Id, Number, Program, Stage};

use super::block::Block;
use super::naming::{given, local};
use super::places::places;
use super::writer::{Source, Told};

/// The names of reactions, where they are, and their numbers of components. For a system, these are
/// the force and moment of each joint that has reactions, and the load of each constraint.
fn reactions(outline: &Outline) -> Vec<(String, TokenStream, usize)> {
    let count = |kind: LoadKind| outline.motion.axes_of(kind).len();
    let own = outline.reactions.iter().map(|(word, kind)| {
        let field = local(&word.to_string());
        (word.to_string(), quote!(#field), count(*kind))
    });
    let joints = outline.holding.iter().flat_map(|joint| {
        [("force", LoadKind::Force), ("moment", LoadKind::Moment)].map(|(part, kind)| {
            let field = format_ident!("{part}");
            (
                format!("{joint}_{part}"),
                quote!(#joint.#field),
                count(kind),
            )
        })
    });
    let kept = outline.kept.iter();
    let kept = kept.map(|name| (name.to_string(), quote!(#name), 1));
    own.chain(joints).chain(kept).collect()
}

impl Block<'_> {
    /// Reads the symbols of `program`, and names them.
    pub fn read(&mut self, program: &Program) -> TokenStream {
        let work = self.writer.work;
        let symbols = program.symbols.iter();
        let symbols: Vec<(Id, Meaning)> = symbols
            .filter_map(|id| Some((*id, work.meaning(*id)?)))
            .collect();
        if self.writer.told == Told::Arrays {
            return self.read_arrays(&symbols);
        }
        let outline = self.writer.outline;
        let mut tokens = self.read_declared(&symbols, Source::Params, &outline.params);
        tokens.extend(self.read_declared(&symbols, Source::Input, &outline.inputs));
        for (_, id) in found(&symbols, |meaning| (meaning == Meaning::Time).then_some(0)) {
            self.reads.push(Source::Time);
            self.names.insert(id, local("time"));
        }
        tokens.extend(self.read_constants(&symbols));
        tokens.extend(self.read_reactions(&symbols));
        for (source, path, names, component) in places(outline) {
            let found = found(&symbols, component);
            if !found.is_empty() {
                self.reads.push(source);
                tokens.extend(self.read_components(&found, &path, &names));
            }
        }
        tokens
    }

    /// The constants of a generic body, each made from a value that is available.
    pub fn constants(&mut self, constants: &BTreeSet<Id>) -> TokenStream {
        let graph = &self.writer.work.graph;
        let numbers: Vec<(Id, Number)> = constants
            .iter()
            .filter_map(|id| Some((*id, graph.as_number(*id)?.clone())))
            .collect();
        if numbers.is_empty() {
            return TokenStream::new();
        }
        let (at_hand, scalar) = (self.value_at_hand(), &self.writer.shapes.scalar);
        let mut tokens = TokenStream::new();
        for (id, number) in numbers {
            let name = self.statement_name(id);
            let value = scalar.constant(&number, &at_hand);
            tokens.extend(quote!(let #name = #value;));
            self.names.insert(id, name);
        }
        tokens
    }

    /// A value that is available in every function of this stage.
    fn value_at_hand(&mut self) -> TokenStream {
        let outline = self.writer.outline;
        let (motion, state) = (outline.motion, local("state"));
        if outline.is_still() || self.writer.told != Told::State {
            return self.param_at_hand();
        }
        self.reads.push(Source::State);
        if let Some(joint) = outline.joints.first() {
            let rates = joint.shape.fields.iter().rev();
            let field = rates.map(|field| (field.path, field.names.len())).next();
            let (path, count) = field.unwrap_or_default();
            let (name, path) = (&joint.name, format_ident!("{path}"));
            let x = (count > 1).then(|| quote!(.x));
            return quote!(#state.#name.#path #x);
        }
        if let Some(own) = outline.states.first() {
            let name = &own.name;
            return quote!(#state.#name);
        }
        if motion.translates() {
            quote!(#state.velocity.x)
        } else if motion.has_angle() {
            quote!(#state.angular_velocity)
        } else {
            quote!(#state.angular_velocity.x)
        }
    }

    /// The first component of the first parameter; without parameters, the default of the scalar.
    fn param_at_hand(&self) -> TokenStream {
        let Some(param) = self.writer.outline.params.first() else {
            let kind = self.writer.shapes.scalar.kind();
            return quote!(<#kind as ::core::default::Default>::default());
        };
        let (name, x) = (&param.name, param.frame.map(|_| quote!(.x)));
        // in the constructor, the parameters are not stored yet
        let itself = (self.writer.stage != Stage::Parameter).then(|| quote!(self.));
        let params = Ident::new("params", Span::call_site());
        quote!(#itself #params.#name #x)
    }

    /// `let area = Self::given_area();` for constants that are not stored.
    fn read_constants(&mut self, symbols: &[(Id, Meaning)]) -> TokenStream {
        let component = |meaning: Meaning| match meaning {
            Meaning::Constant(number) => Some(number),
            _ => None,
        };
        let mut tokens = TokenStream::new();
        for (number, id) in found(symbols, component) {
            if self.writer.fields.get(id).is_some() {
                continue;
            }
            let word = self.writer.work.constants[number].name.to_string();
            let (name, given) = (self.statement_name(id), given(&word));
            let (private, kind) = (
                &self.writer.shapes.private,
                self.writer.shapes.scalar.kind(),
            );
            tokens.extend(quote!(let #name: #kind = #private::constant(Self::#given());));
            self.names.insert(id, name);
        }
        tokens
    }

    /// `let [pin_x, pin_y]: [f64; 2] = Into::into(reactions.pin);`
    fn read_reactions(&mut self, symbols: &[(Id, Meaning)]) -> TokenStream {
        let mut tokens = TokenStream::new();
        for (index, (word, path, count)) in reactions(self.writer.outline).iter().enumerate() {
            let component = |meaning: Meaning| match meaning {
                Meaning::Reaction(reaction, axis) if reaction == index => Some(axis),
                _ => None,
            };
            let found = found(symbols, component);
            if found.is_empty() {
                continue;
            }
            self.reads.push(Source::Reactions);
            let reactions = local("reactions");
            let names: Vec<String> = match &AXES[..*count] {
                [_] => vec![word.clone()],
                axes => axes.iter().map(|axis| format!("{word}_{axis}")).collect(),
            };
            tokens.extend(self.read_components(&found, &quote!(#reactions.#path), &names));
        }
        tokens
    }

    /// `let [x, _, z]: [f64; 3] = Into::into(path);`, or `let angle = path;` for a scalar.
    fn read_components(
        &mut self,
        found: &[(usize, Id)],
        path: &TokenStream,
        names: &[String],
    ) -> TokenStream {
        if let ([wanted], [(_, id)]) = (names, found) {
            let name = self.unique(wanted);
            self.names.insert(*id, name.clone());
            return quote!(let #name = #path;);
        }
        let mut pattern = Vec::new();
        for (component, wanted) in names.iter().enumerate() {
            // in the plane, angular quantities are along z and have a single name
            let Some((_, id)) = found.iter().find(|(found, _)| *found == component) else {
                pattern.push(quote!(_));
                continue;
            };
            let name = self.unique(wanted);
            self.names.insert(*id, name.clone());
            pattern.push(name.into_token_stream());
        }
        let count = Literal::usize_unsuffixed(names.len());
        let kind = self.writer.shapes.scalar.kind();
        quote!(let [#(#pattern),*]: [#kind; #count] = ::core::convert::Into::into(#path);)
    }

    /// `let Params { arm, .. } = self.params;`, and the components of any vectors in it.
    fn read_declared(
        &mut self,
        symbols: &[(Id, Meaning)],
        source: Source,
        declared: &[Declared],
    ) -> TokenStream {
        let component = |meaning: Meaning, wanted: usize| match (meaning, source) {
            (Meaning::Param(index, component), Source::Params)
            | (Meaning::Input(index, component), Source::Input) => {
                (index == wanted).then_some(component.unwrap_or(0))
            }
            _ => None,
        };
        let (mut pattern, mut components) = (Vec::new(), TokenStream::new());
        for (index, declaration) in declared.iter().enumerate() {
            let used = found(symbols, |meaning| component(meaning, index));
            if used.is_empty() {
                continue;
            }
            let word = declaration.name.to_string();
            let (name, field) = (self.unique(&word), Ident::new(&word, Span::mixed_site()));
            pattern.push(if name == field {
                quote!(#field)
            } else {
                quote!(#field: #name)
            });
            if declaration.frame.is_some() {
                let axes = &AXES[..self.writer.outline.motion.axes()];
                let names: Vec<String> = axes.iter().map(|axis| format!("{name}_{axis}")).collect();
                components.extend(self.read_components(&used, &name.into_token_stream(), &names));
            } else {
                self.names.insert(used[0].1, name);
            }
        }
        if pattern.is_empty() {
            return TokenStream::new();
        }
        self.reads.push(source);
        if pattern.len() < declared.len() {
            pattern.push(quote!(..));
        }
        let (body, input) = (&self.writer.outline.name, local("input"));
        let (suffix, place) = match (source, self.writer.stage) {
            (Source::Input, _) => ("Input", quote!(*#input)),
            // in the constructor, the parameters are not stored yet
            (_, Stage::Parameter) => ("Params", quote!(params)),
            _ => ("Params", quote!(self.params)),
        };
        let kind = Ident::new(&format!("{body}{suffix}"), body.span());
        quote!(let #kind { #(#pattern),* } = #place; #components)
    }
}

/// The symbols that are components of a quantity, with their indices.
fn found(
    symbols: &[(Id, Meaning)],
    component: impl Fn(Meaning) -> Option<usize>,
) -> Vec<(usize, Id)> {
    let symbols = symbols.iter();
    symbols
        .filter_map(|(id, meaning)| Some((component(*meaning)?, *id)))
        .collect()
}
