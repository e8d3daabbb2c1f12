//! The constructor of a body. It checks the parameters, and computes and stores everything that
//! depends on them alone.

use proc_macro2::{Ident, Span, TokenStream};
use quote::quote;

use crate::emit::code::{Fields, Names, PRINCIPAL_AXES, Told, Writer, code_text, local};
use crate::model::{AXES, Meaning, Outline, Property, Substance, Workspace};
use crate::symbolic::{Cost, Id, Stage};

use super::possible::Checked;

/// All expressions that code is generated for.
pub struct Roots {
    /// The expressions that must be finite.
    pub finite: Vec<Id>,
    /// The times at which the equations change. A time that is not finite is no switch.
    pub switches: Vec<Id>,
    /// The entries of a tensor whose principal axes a body of doubles stores.
    pub tensor: Option<[Id; 6]>,
    /// The properties of links and cables, and the inertia of bodies with added mass.
    pub properties: Vec<Property>,
}

/// The content of `new`, and the fields that a body stores.
#[derive(Default)]
pub struct Constructor {
    /// The fields next to `params`: expressions that depend on parameters alone.
    pub stored: Vec<Ident>,
    /// The field for principal axes, if a closed form needs them.
    pub axes: Option<Ident>,
    /// What `new` checks and computes.
    pub body: TokenStream,
    pub cost: Cost,
    /// The computations as text.
    pub text: Vec<String>,
    /// The names of the symbols in it.
    pub symbols: Vec<(String, Meaning)>,
}

/// The expressions that depend on parameters alone, each with the name of its field.
pub fn stored_fields(outline: &Outline, work: &Workspace, roots: &Roots) -> Fields {
    let mut all = [&roots.finite[..], &roots.switches].concat();
    // a generic body stores no principal axes
    if outline.scalar.is_some() {
        all.extend(roots.tensor.into_iter().flatten());
    }
    let program = Writer::new(outline, work, Fields::NONE).schedule(&all);
    let is_constant = |id: &Id| matches!(work.meaning(*id), Some(Meaning::Constant(_)));
    let constants = program.symbols.into_iter().filter(is_constant);
    let hoisted = program.hoisted.into_iter().chain(constants);
    let mut taken: Names = ["params", PRINCIPAL_AXES].into_iter().collect();
    let fields = hoisted.map(|id| {
        let label = |id: Id| work.labels.get(id).map(str::to_owned);
        let opposite = || Some(format!("minus_{}", label(work.graph.negation_of(id)?)?));
        let wanted = label(id).or_else(opposite);
        let wanted = wanted.unwrap_or_else(|| field_name(outline, work, id));
        (id, taken.unique(&wanted))
    });
    Fields(fields.collect())
}

/// All parts of expressions, down to those that are known early, which are stored as a whole.
fn reached(work: &Workspace, roots: &[Id]) -> Vec<Id> {
    let graph = &work.graph;
    graph.reachable(roots, &|id| !graph.is_early(id))
}

/// The name of a field. A constant is named after the parameters that it is computed from.
fn field_name(outline: &Outline, work: &Workspace, id: Id) -> String {
    let mut words = outline.sources(work, &[id]);
    words.truncate(3);
    format!("from_{}", words.join("_"))
}

impl Constructor {
    /// Writes `new`, which checks the parameters, and computes and stores everything that depends
    /// on them alone.
    pub fn write(
        outline: &Outline,
        (bodies, work): (&[Substance], &Workspace),
        roots: &Roots,
        fields: &Fields,
    ) -> Self {
        let writer = Writer {
            targets: fields,
            stage: Stage::Parameter,
            told: Told::Nothing,
            ..Writer::new(outline, work, Fields::NONE)
        };
        let is_open = |id: &Id| work.graph.stage(*id) == Stage::Parameter;
        let checked = Checked::of(bodies, |ids| {
            ids.iter().any(is_open) && work.graph.are_early(ids)
        });
        let tensor = roots.tensor.filter(|_| outline.scalar.is_none());
        let tensor: Vec<Id> = tensor.into_iter().flatten().collect();
        let mut properties: Vec<&Property> = roots.properties.iter().collect();
        properties.retain(|property| is_open(&property.value));
        let made_with = properties.iter().map(|property| property.value).collect();
        let stored = fields.0.iter().map(|(id, _)| *id).collect();
        let possible = checked.values();
        let all = [possible.clone(), made_with, tensor.clone(), stored].concat();
        let code = writer.function(&all);
        let (possible, values) = code.outputs.split_at(possible.len());
        let (made_with, values) = values.split_at(properties.len());
        let (tensor, values) = values.split_at(tensor.len());

        let value_text = &code.facts.output_text[code.outputs.len() - values.len()..];
        let stored: Vec<Ident> = fields.0.iter().map(|(_, name)| name.clone()).collect();
        let (rest, text_of_rest) = let_fields(&stored, values, value_text);
        let text = [constants_text(work), code.facts.text, text_of_rest].concat();
        let private = &writer.shapes.private;
        let statements = code.statements;
        let possible = checked.emit(possible, private);
        let made = check_properties(&properties, made_with, private);
        let derived = check_derived((outline, work), roots, fields, private);
        let axes = (!tensor.is_empty()).then(|| local(PRINCIPAL_AXES));
        let principal = quote!(#private::principal_axes([#(#tensor),*]));
        let set_axes = axes.iter().map(|axes| quote!(let #axes = #principal;));
        let own = own_fields(outline);
        let check_params = check_params(outline, private);
        let body = quote! {
            #check_params
            #statements
            #possible
            #made
            #rest
            #derived
            #(#set_axes)*
            ::core::result::Result::Ok(Self { #own #(#stored,)* #axes })
        };
        Self {
            stored,
            symbols: code.facts.symbols,
            axes,
            body,
            cost: code.facts.cost,
            text,
        }
    }

    pub fn stub(outline: &Outline) -> Self {
        let own = own_fields(outline);
        Self {
            body: quote!(::core::result::Result::Ok(Self { #own })),
            ..Self::default()
        }
    }
}

/// The field for the parameters, or the marker of the scalar of a body without parameters.
fn own_fields(outline: &Outline) -> TokenStream {
    match (outline.params.is_empty(), &outline.scalar) {
        (false, _) => quote!(params,),
        (true, Some(_)) => quote!(scalar: ::core::marker::PhantomData,),
        (true, None) => TokenStream::new(),
    }
}

/// `area = crate::AREA` for each constant of the user.
fn constants_text(work: &Workspace) -> Vec<String> {
    let constants = work.constants.iter();
    constants
        .map(|constant| format!("{} = {}", constant.name, code_text(&constant.value)))
        .collect()
}

/// `let arm = ..;` for each field that is not yet a statement of that name, and the same as text.
fn let_fields(
    stored: &[Ident],
    values: &[TokenStream],
    value_text: &[String],
) -> (TokenStream, Vec<String>) {
    let all = stored.iter().zip(values).zip(value_text);
    let open = all.filter(|((name, value), _)| **name != code_text(value));
    let both = open.map(|((name, value), text)| {
        let statement = quote!(let #name = #value;);
        (statement, format!("{name} = {text}"))
    });
    both.unzip()
}

/// Checks the properties of links and cables that depend on parameters.
fn check_properties(
    properties: &[&Property],
    values: &[TokenStream],
    private: &TokenStream,
) -> TokenStream {
    let checks = properties.iter().zip(values).map(|(property, value)| {
        let (of, word, may_vanish) = (property.of.to_string(), property.word, property.may_vanish);
        quote!(#private::check_property((#of, #word), #value, #may_vanish)?;)
    });
    checks.collect()
}

/// Checks that stored values are finite where they must be: `check_finite(&[("lost", lost)])?;` for
/// the user's constants, and `check_derived(&[("`arm`, `mass`", inverse_inertia)])?;` for what is
/// computed from these names.
fn check_derived(
    (outline, work): (&Outline, &Workspace),
    roots: &Roots,
    fields: &Fields,
    private: &TokenStream,
) -> TokenStream {
    let finite = reached(work, &roots.finite);
    let checked = fields.0.iter().filter(|(id, _)| finite.contains(id));
    let (constants, derived): (Vec<_>, Vec<_>) =
        checked.partition(|(id, _)| work.meaning(*id).is_some());
    let constants = constants.into_iter().map(|(_, name)| {
        let word = name.to_string();
        quote!((#word, #name))
    });
    let derived = derived.into_iter().map(|(id, name)| {
        let from = first_names(&outline.sources(work, &[*id]));
        quote!((#from, #name))
    });
    let (constants, derived): (Vec<_>, Vec<_>) = (constants.collect(), derived.collect());
    let constants =
        (!constants.is_empty()).then(|| quote!(#private::check_finite(&[#(#constants),*])?;));
    let derived =
        (!derived.is_empty()).then(|| quote!(#private::check_derived(&[#(#derived),*])?;));
    quote!(#constants #derived)
}

/// "`arm`, `mass`", of many names the first.
fn first_names(names: &[String]) -> String {
    const MOST: usize = 4;
    let first = names[..names.len().min(MOST)].join("`, `");
    let others = if names.len() > MOST { ", .." } else { "" };
    format!("`{first}`{others}")
}

/// `check_finite(&[("arm", params.arm), ..])?;` for every component of every parameter.
fn check_params(outline: &Outline, private: &TokenStream) -> Option<TokenStream> {
    let axes = AXES[..outline.motion.axes()].iter();
    let axes = axes.map(|axis| Ident::new(axis, Span::call_site()));
    let parts: Vec<TokenStream> = axes.map(|axis| quote!(.#axis)).collect();
    let checks = outline.params.iter().flat_map(|param| {
        let (name, word) = (&param.name, param.name.to_string());
        let parts = param
            .frame
            .map_or(vec![TokenStream::new()], |_| parts.clone());
        parts
            .into_iter()
            .map(move |part| quote!((#word, params.#name #part)))
    });
    let checks: Vec<TokenStream> = checks.collect();
    (!checks.is_empty()).then(|| quote!(#private::check_finite(&[#(#checks),*])?;))
}
