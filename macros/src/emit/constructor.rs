//! How a body is built: its parameters are checked, and what depends on them alone is computed and
//! stored.

use proc_macro2::{Ident, Span, TokenStream};
use quote::quote;

use crate::mechanics::{Equations, Flow};
use crate::model::{Inertia, Meaning, Model, Outline, Workspace};
use crate::symbolic::{Cost, Id, Node, Stage};

use super::code::{Fields, Writer};
use super::naming::{local, local_name};
use super::paths::private;
use super::scalar::Scalar;
use super::text::to_text;

/// The field of principal axes.
pub const PRINCIPAL_AXES: &str = "principal_axes";

/// What a body is built from and keeps.
pub struct Constructor {
    /// Fields beside `params`: what depends on the parameters alone.
    pub stored: Vec<Ident>,
    /// The field of principal axes, where a closed form needs them.
    pub axes: Option<Ident>,
    /// Checks and computations of `new`.
    pub body: TokenStream,
    pub cost: Cost,
    /// The computations as text.
    pub text: Vec<String>,
}

/// The expressions of the equations that depend on parameters alone, each with the name of its field.
pub fn stored_fields(
    outline: &Outline,
    (model, work): (&Model, &Workspace),
    equations: &Equations,
) -> Fields {
    let none = Fields::default();
    let writer = Writer {
        model,
        work,
        outline,
        fields: &none,
        targets: &none,
        stage: Stage::State,
        is_fallible: false,
        is_whole: false,
        has_state: false,
        scalar: Scalar::of(outline),
        private: private(outline),
    };
    let mut roots = equations.roots();
    // for any scalar there are no principal axes to be stored
    if outline.scalar.is_some() {
        roots.extend(equations.flow.iter().filter_map(Flow::tensor).flatten());
    }
    let hoisted = writer.schedule(&roots).hoisted;
    let mut taken = vec!["params".to_owned(), PRINCIPAL_AXES.to_owned()];
    let fields = hoisted.into_iter().map(|id| {
        let labels = &work.labels;
        let label = labels.get(id).map(str::to_owned);
        let opposite = || {
            Some(format!(
                "minus_{}",
                labels.get(work.graph.negation_of(id)?)?
            ))
        };
        let wanted = label.or_else(opposite);
        let wanted = local_name(&wanted.unwrap_or_else(|| field_name(outline, work, id)));
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

/// What is known early of expressions, as it is stored.
fn reached(work: &Workspace, roots: &[Id]) -> Vec<Id> {
    let graph = &work.graph;
    graph.reachable(roots, |id| !graph.is_early(id))
}

/// A constant is called after the parameters that it is computed from.
fn field_name(outline: &Outline, work: &Workspace, id: Id) -> String {
    let graph = &work.graph;
    let mut words: Vec<String> = Vec::new();
    for symbol in graph.reachable(&[id], |_| true) {
        let Node::Symbol(symbol) = graph.node(symbol) else {
            continue;
        };
        if let Meaning::Param(index, _) = work.meanings.of(*symbol) {
            words.push(outline.params[index].name.to_string());
        }
    }
    words.dedup();
    words.truncate(3);
    format!("from_{}", words.join("_"))
}

impl Constructor {
    /// `new` checks the parameters, and computes and stores what depends on them alone.
    pub fn write(
        outline: &Outline,
        (model, work): (&Model, &Workspace),
        equations: &Equations,
        fields: &Fields,
    ) -> Self {
        let private = private(outline);
        let none = Fields::default();
        let writer = Writer {
            model,
            work,
            outline,
            fields: &none,
            targets: fields,
            stage: Stage::Parameter,
            is_fallible: false,
            is_whole: false,
            has_state: false,
            scalar: Scalar::of(outline),
            private: private.clone(),
        };
        let is_open = |id: &Id| work.graph.stage(*id) == Stage::Parameter;
        let mass: Vec<Id> = model.mass.into_iter().filter(is_open).collect();
        let inertia = if model.inertia_entries().iter().any(is_open) {
            model.inertia_entries()
        } else {
            Vec::new()
        };
        let tensor = stored_tensor(outline, equations).unwrap_or_default();
        let outputs: Vec<Id> = mass
            .iter()
            .chain(&inertia)
            .chain(&tensor)
            .copied()
            .chain(fields.0.iter().map(|(id, _)| *id))
            .collect();
        let code = writer.function(&outputs);
        let (mass_value, rest) = code.outputs.split_at(mass.len());
        let (inertia_values, rest) = rest.split_at(inertia.len());
        let (tensor_values, values) = rest.split_at(tensor.len());

        let given = finite_checks(outline, model);
        let mass_check = mass_value
            .iter()
            .map(|mass| quote!(#private::check_mass(#mass)?;));
        let inertia_check = match (model.inertia, inertia_values) {
            (_, []) => TokenStream::new(),
            (Inertia::Scalar(_), [moment, ..]) => quote!(#private::check_planar_inertia(#moment)?;),
            (_, entries) => quote!(#private::check_inertia([#(#entries),*])?;),
        };
        let stored: Vec<Ident> = fields.0.iter().map(|(_, name)| name.clone()).collect();
        let finite = reached(work, &equations.finite_roots());
        let checked = fields.0.iter().filter(|(id, _)| finite.contains(id));
        let checked: Vec<&Ident> = checked.map(|(_, name)| name).collect();
        let words = checked.iter().map(ToString::to_string);
        let derived = (!checked.is_empty())
            .then(|| quote!(#private::check_finite(&[#((#words, #checked)),*])?;));
        let axes = (!tensor.is_empty()).then(|| local(PRINCIPAL_AXES));
        let set_axes = axes
            .iter()
            .map(|axes| quote!(let #axes = #private::principal_axes([#(#tensor_values),*]);));
        let statements = &code.statements;
        let mut text = code.text;
        let mut rest = TokenStream::new();
        let value_text = &code.output_text[code.outputs.len() - values.len()..];
        for ((name, value), value_text) in stored.iter().zip(values).zip(value_text) {
            // what is a statement has its name already
            if *name != to_text(value) {
                text.push(format!("{name} = {value_text}"));
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
            #(#set_axes)*
            ::core::result::Result::Ok(Self { params, #(#stored,)* #axes })
        };
        Self {
            stored,
            axes,
            body,
            cost: code.cost,
            text,
        }
    }

    pub fn stub() -> Self {
        Self {
            stored: Vec::new(),
            axes: None,
            body: quote!(::core::result::Result::Ok(Self { params })),
            cost: Cost::default(),
            text: Vec::new(),
        }
    }
}

/// The tensor of which a body of doubles stores the principal axes.
pub fn stored_tensor(outline: &Outline, equations: &Equations) -> Option<Vec<Id>> {
    let tensor = equations.flow.as_ref()?.tensor()?;
    outline.scalar.is_none().then(|| tensor.to_vec())
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
