//! The structs of a body: itself, its parameters, its inputs; and how it is built.

use proc_macro2::{Ident, Span, TokenStream};
use quote::{format_ident, quote};

use crate::mechanics::Equations;
use crate::model::{Declared, Inertia, LoadKind, Meaning, Model, Outline};
use crate::symbolic::{Cost, Id, Node, Stage};

use super::code::{Fields, Writer};
use super::docs::{Documentation, declared_doc};
use super::expression::number_literal;
use super::naming::local_name;
use super::shapes::Shapes;
use super::text::to_text;

/// What a body is built from and keeps.
pub struct Constructor {
    /// Fields beside `params`: what depends on the parameters alone.
    pub stored: Vec<Ident>,
    /// Checks and computations of `new`.
    pub body: TokenStream,
    pub cost: Cost,
    /// The computations as text.
    pub text: Vec<String>,
}

/// The expressions of the equations that depend on parameters alone, each with the name of its field.
pub fn stored_fields(outline: &Outline, model: &Model, equations: &Equations) -> Fields {
    let none = Fields::default();
    let writer = Writer {
        model,
        outline,
        fields: &none,
        targets: &none,
        stage: Stage::State,
        private: private(outline),
    };
    let hoisted = writer.schedule(&equations.roots()).hoisted;
    let mut taken: Vec<String> = vec!["params".to_owned()];
    let fields = hoisted.into_iter().map(|id| {
        let labels = &model.frames.labels;
        let label = labels.get(id).map(str::to_owned);
        let opposite = || {
            Some(format!(
                "minus_{}",
                labels.get(model.frames.graph.negation_of(id)?)?
            ))
        };
        let wanted = label.or_else(opposite);
        let wanted = local_name(&wanted.unwrap_or_else(|| field_name(outline, model, id)));
        let mut name = wanted.clone();
        let mut repeated = 0;
        while taken.contains(&name) {
            repeated += 1;
            name = format!("{wanted}_{repeated}");
        }
        taken.push(name.clone());
        (id, Ident::new(&name, Span::mixed_site()))
    });
    Fields(fields.collect())
}

/// A constant is called after the parameters that it is computed from.
fn field_name(outline: &Outline, model: &Model, id: Id) -> String {
    let graph = &model.frames.graph;
    let mut words: Vec<String> = Vec::new();
    for symbol in graph.reachable(&[id], |_| true) {
        let Node::Symbol(symbol) = graph.node(symbol) else {
            continue;
        };
        if let Meaning::Param(index, _) = model.meanings.of(*symbol) {
            words.push(outline.params[index].name.to_string());
        }
    }
    words.dedup();
    words.truncate(3);
    format!("from_{}", words.join("_"))
}

/// The path of what generated code may name.
pub fn private(outline: &Outline) -> TokenStream {
    let runtime = &outline.runtime;
    quote!(#runtime::private)
}

impl Constructor {
    /// `new` checks the parameters, and computes and stores what depends on them alone.
    pub fn write(outline: &Outline, model: &Model, fields: &Fields) -> Self {
        let private = private(outline);
        let none = Fields::default();
        let writer = Writer {
            model,
            outline,
            fields: &none,
            targets: fields,
            stage: Stage::Parameter,
            private: private.clone(),
        };
        let is_open = |id: &Id| model.frames.graph.stage(*id) == Stage::Parameter;
        let mass: Vec<Id> = model.mass.into_iter().filter(is_open).collect();
        let inertia = if model.inertia_entries().iter().any(is_open) {
            model.inertia_entries()
        } else {
            Vec::new()
        };
        let outputs: Vec<Id> = mass
            .iter()
            .chain(&inertia)
            .copied()
            .chain(fields.0.iter().map(|(id, _)| *id))
            .collect();
        let code = writer.function(&outputs);
        let (mass_value, rest) = code.outputs.split_at(mass.len());
        let (inertia_values, values) = rest.split_at(inertia.len());

        let given = finite_checks(outline, model);
        let mass_check = mass_value
            .iter()
            .map(|mass| quote!(#private::check_mass(#mass)?;));
        let inertia_check = match (model.inertia, inertia_values) {
            (_, []) => TokenStream::new(),
            (Inertia::Planar(_), [moment, ..]) => quote!(#private::check_planar_inertia(#moment)?;),
            (_, entries) => quote!(#private::check_inertia([#(#entries),*])?;),
        };
        let stored: Vec<Ident> = fields.0.iter().map(|(_, name)| name.clone()).collect();
        let words = stored.iter().map(ToString::to_string);
        let derived = (!stored.is_empty())
            .then(|| quote!(#private::check_finite(&[#((#words, #stored)),*])?;));
        let statements = &code.statements;
        let mut text = code.text;
        let mut rest = TokenStream::new();
        for (name, value) in stored.iter().zip(values) {
            // what is a statement has its name already
            if *name != to_text(value) {
                text.push(format!("{name} = {}", to_text(value)));
                rest.extend(quote!(let #name = #value;));
            }
        }
        let body = quote! {
            #private::check_finite(&[#(#given),*])?;
            #statements
            #(#mass_check)*
            #inertia_check
            #rest
            #derived
            ::core::result::Result::Ok(Self { params, #(#stored),* })
        };
        Self {
            stored,
            body,
            cost: code.cost,
            text,
        }
    }

    pub fn stub() -> Self {
        Self {
            stored: Vec::new(),
            body: quote!(::core::result::Result::Ok(Self { params })),
            cost: Cost::default(),
            text: Vec::new(),
        }
    }
}

/// `("arm", params.arm)` of every parameter, by component.
fn finite_checks(outline: &Outline, model: &Model) -> Vec<TokenStream> {
    let axes = ["x", "y", "z"];
    let checks = outline.params.iter().flat_map(|param| {
        let (name, word) = (&param.name, param.name.to_string());
        match param.frame {
            None => vec![quote!((#word, params.#name))],
            Some(_) => axes[..model.motion.axes()]
                .iter()
                .map(|axis| {
                    let axis = Ident::new(axis, Span::call_site());
                    quote!((#word, params.#name.#axis))
                })
                .collect(),
        }
    });
    checks.collect()
}

/// The type of a declared quantity.
fn declared_type(outline: &Outline, declared: &Declared) -> TokenStream {
    let private = private(outline);
    match (declared.frame, outline.motion.axes()) {
        (None, _) => quote!(f64),
        (Some(_), 2) => quote!(#private::Vector2<f64>),
        (Some(_), _) => quote!(#private::Vector3<f64>),
    }
}

fn emit_struct(
    outline: &Outline,
    suffix: &str,
    doc: &str,
    derives: &TokenStream,
    declared: &[Declared],
) -> TokenStream {
    let name = format_ident!("{}{suffix}", outline.name);
    let docs = declared.iter().map(declared_doc);
    let names = declared.iter().map(|declared| &declared.name);
    let types = declared
        .iter()
        .map(|declared| declared_type(outline, declared));
    let lints = lints(declared);
    quote! {
        #[doc = #doc]
        #lints
        #derives
        pub struct #name { #(#[doc = #docs] pub #names: #types),* }
    }
}

/// One field for each load with unknown components.
fn emit_reactions(outline: &Outline) -> TokenStream {
    let shapes = Shapes::of(outline);
    let name = format_ident!("{}Reactions", outline.name);
    let doc = format!(
        " The unknown reactions of [`{}`], world axes.",
        outline.name
    );
    let fields = outline.reactions.iter().map(|(field, kind)| {
        let (kind, unit) = match kind {
            LoadKind::Force => (shapes.vector_type(), "N"),
            LoadKind::Moment => (shapes.moment_type(), "N * m"),
        };
        let doc = format!(" `{field}` in {unit}.");
        quote!(#[doc = #doc] pub #field: #kind)
    });
    quote! {
        #[doc = #doc]
        #[derive(Clone, Copy, Debug, Default, PartialEq)]
        pub struct #name { #(#fields),* }
    }
}

/// Users may call a parameter `J`, and inputs `thrust_1`, `thrust_2`, ...
fn lints(declared: &[Declared]) -> TokenStream {
    let has_capitals = |name: &Ident| name.to_string().contains(char::is_uppercase);
    let unusual = declared.iter().any(|declared| has_capitals(&declared.name));
    let snake_case = unusual.then(|| quote!(, non_snake_case));
    quote!(#[allow(clippy::struct_field_names #snake_case)])
}

fn default_value(outline: &Outline, declared: &Declared) -> Option<TokenStream> {
    let private = private(outline);
    let numbers = declared
        .default
        .as_ref()?
        .iter()
        .map(|number| number_literal(number.to_f64()));
    Some(match (declared.frame, outline.motion.axes()) {
        (None, _) => quote!(#(#numbers)*),
        (Some(_), 2) => quote!(#private::Vector2::new(#(#numbers),*)),
        (Some(_), _) => quote!(#private::Vector3::new(#(#numbers),*)),
    })
}

pub fn emit_items(
    outline: &Outline,
    constructor: &Constructor,
    documentation: &Documentation,
) -> TokenStream {
    let name = &outline.name;
    let documentation_lines = &documentation.lines;
    let constants = &documentation.constants;
    let inputs = (!outline.inputs.is_empty()).then(|| {
        let derives = quote!(#[derive(Clone, Copy, Debug, Default, PartialEq)]);
        emit_struct(
            outline,
            "Input",
            &format!(" What [`{name}`] is given at each evaluation, in SI units."),
            &derives,
            &outline.inputs,
        )
    });
    let reactions = (!outline.reactions.is_empty()).then(|| emit_reactions(outline));
    if outline.params.is_empty() {
        return quote! {
            #documentation_lines
            #[derive(Clone, Debug, Default)]
            pub struct #name {}
            #inputs
            #reactions
            impl #name { #constants }
        };
    }
    let params = format_ident!("{name}Params");
    let derives = quote!(#[derive(Clone, Copy, Debug, PartialEq)]);
    let param_struct = emit_struct(
        outline,
        "Params",
        &format!(" Parameters of [`{name}`], in SI units."),
        &derives,
        &outline.params,
    );
    let private = private(outline);
    let Constructor { stored, body, .. } = constructor;
    let default = outline.has_default().then(|| emit_default(outline));
    let new_doc = " Checks the parameters, and computes what depends on them alone.";
    quote! {
        #documentation_lines
        #[derive(Clone, Debug)]
        pub struct #name { params: #params, #(#stored: f64),* }
        #param_struct
        #inputs
        #reactions
        impl #name {
            #constants
            #[doc = #new_doc]
            #[doc = ""]
            #[doc = " # Errors"]
            #[doc = " A parameter is not finite, or no body has the mass or inertia they make."]
            pub fn new(params: #params) -> ::core::result::Result<Self, #private::InvalidBody> { #body }
            /// The parameters this body was built from.
            #[must_use]
            pub fn params(&self) -> &#params { &self.params }
        }
        #default
    }
}

fn emit_default(outline: &Outline) -> TokenStream {
    let name = &outline.name;
    let params = format_ident!("{name}Params");
    let names = outline.params.iter().map(|param| &param.name);
    let values = outline
        .params
        .iter()
        .filter_map(|param| default_value(outline, param));
    quote! {
        impl ::core::default::Default for #params {
            fn default() -> Self { Self { #(#names: #values),* } }
        }
        impl ::core::default::Default for #name {
            fn default() -> Self {
                Self::new(<#params as ::core::default::Default>::default()).expect("the defaults were checked at expansion")
            }
        }
    }
}

/// What lets the compiler and editors see the words of the description: its keys, and the names
/// that nothing refers to, which get the compiler's own warning.
pub fn emit_checks(outline: &Outline) -> TokenStream {
    let runtime = &outline.runtime;
    let body = Ident::new("body", Span::mixed_site());
    let lines = outline
        .keys
        .chunks(5)
        .map(|keys| quote!(let _ = [#(&#body.#keys),*];));
    let schema = quote!(const _: fn(&#runtime::schema::Body) = |#body| { #(#lines)* };);
    let unused = (!outline.unused.is_empty()).then(|| {
        let names = outline
            .unused
            .iter()
            .map(|name| Ident::new(&local_name(&name.to_string()), name.span()));
        quote!(const _: fn() = || { #(let #names = ();)* };)
    });
    quote!(#schema #unused)
}
