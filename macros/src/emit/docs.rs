//! The documentation of a body: its equations, what kind of body it is, what they cost and what was
//! left out.

use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::quote;

use crate::mechanics::Equations;
use crate::model::{Declared, Frame, Outline};
use crate::symbolic::Cost;

use super::constructor::Constructor;
use super::functions::Functions;
use super::paths::private;

/// The rustdoc of the type, and its inherent constants.
pub struct Documentation {
    /// The type's documentation. Its equations are there for rustdoc alone: who reads the expansion
    /// reads the code.
    pub lines: TokenStream,
    /// `EQUATIONS`, `OPERATIONS`, `SKIPPED`.
    pub constants: TokenStream,
}

impl Documentation {
    pub fn write(
        outline: &Outline,
        functions: &Functions,
        constructor: &Constructor,
        equations: &Equations,
    ) -> Self {
        let by_name = functions.by_name(outline);
        let mut costs: Vec<(&str, &str, Cost)> = by_name
            .into_iter()
            .map(|(name, function)| (name, "state", function.cost))
            .collect();
        if !constructor.stored.is_empty() {
            costs.insert(0, ("new", "parameter", constructor.cost));
        }
        let text = equations_text(functions, constructor);
        let mut lines = lines(outline, &text, &costs, equations);
        if functions.acceleration.has_pivots {
            lines.extend(quote! {
                #[doc = ""]
                #[doc = " # Singular configurations"]
                #[doc = " Where the constraints do not determine their reactions, `acceleration` is not a number; `reactions`, if it is there, returns an error."]
            });
        }
        if functions.inverse.has_pivots {
            lines.extend(quote! {
                #[doc = ""]
                #[doc = " Where the configuration does not determine the drives, `inverse` returns an error."]
            });
        }
        Self {
            lines,
            constants: constants(outline, &text, &costs, equations),
        }
    }

    pub fn stub(outline: &Outline) -> Self {
        let private = private(outline);
        Self {
            lines: quote!(#[doc = " A description with errors."]),
            constants: quote! {
                #[allow(missing_docs)]
                pub const EQUATIONS: &str = "";
                #[allow(missing_docs)]
                pub const OPERATIONS: &[#private::Operations] = &[];
                #[allow(missing_docs)]
                pub const SKIPPED: &[&str] = &[];
            },
        }
    }
}

fn lines(
    outline: &Outline,
    text: &[String],
    costs: &[(&str, &str, Cost)],
    equations: &Equations,
) -> TokenStream {
    let motion = outline.motion.word;
    let title = if outline.doc.is_empty() {
        vec![format!("A rigid body in `{motion}` motion.")]
    } else {
        outline.doc.clone()
    };
    let title = title.iter().map(|line| spaced(line));
    let text = text.iter().map(|line| spaced(line));
    let costs: Vec<String> = costs
        .iter()
        .map(|(name, _, cost)| format!("`{name}`: {}", describe(*cost)))
        .collect();
    let inertia = listed("Inertia about G", &equations.inertia_class);
    let charges = listed("Charges", &equations.charges);
    let operations = listed("Operations", &costs);
    let flow = equations.flow.as_ref();
    let flow = flow.map_or_else(Vec::new, |flow| flow.describe(outline.motion));
    let flow = listed("Closed form", &flow);
    let skipped = listed("Skipped", &equations.skipped);
    quote! {
        #(#[doc = #title])*
        #[cfg_attr(doc, doc = "", doc = " ```text")]
        #(#[cfg_attr(doc, doc = #text)])*
        #[cfg_attr(doc, doc = " ```")]
        #(#[doc = #inertia])*
        #(#[doc = #charges])*
        #(#[doc = #flow])*
        #(#[doc = #operations])*
        #(#[doc = #skipped])*
    }
}

/// What is computed once, and then the acceleration.
fn equations_text(functions: &Functions, constructor: &Constructor) -> Vec<String> {
    let stored = &constructor.text;
    let heading = (!stored.is_empty()).then(|| "# once, in the constructor".to_owned());
    let then = (!stored.is_empty()).then(|| "# at every evaluation".to_owned());
    let lines = heading
        .iter()
        .chain(stored)
        .chain(&then)
        .chain(&functions.acceleration.text);
    lines.cloned().collect()
}

/// A heading and a list, or nothing.
fn listed(heading: &str, rows: &[String]) -> Vec<String> {
    if rows.is_empty() {
        return Vec::new();
    }
    let head = [String::new(), format!(" {heading}:")];
    head.into_iter()
        .chain(rows.iter().map(|row| format!(" - {row}")))
        .collect()
}

fn spaced(line: &str) -> String {
    if line.is_empty() {
        String::new()
    } else {
        format!(" {line}")
    }
}

fn describe(cost: Cost) -> String {
    let parts = [
        (cost.mul, "mul"),
        (cost.add, "add"),
        (cost.div, "div"),
        (cost.sqrt, "sqrt"),
        (cost.trig, "trig"),
        (cost.other, "other"),
    ];
    let words: Vec<String> = parts
        .into_iter()
        .filter(|(count, _)| *count > 0)
        .map(|(count, name)| format!("{count} {name}"))
        .collect();
    if words.is_empty() {
        "none".to_owned()
    } else {
        words.join(" + ")
    }
}

fn constants(
    outline: &Outline,
    text: &[String],
    costs: &[(&str, &str, Cost)],
    equations: &Equations,
) -> TokenStream {
    let private = private(outline);
    let text = text.join("\n");
    let rows = costs.iter().map(|(name, stage, cost)| {
        let stage = Ident::new(stage, Span::call_site());
        let counts = [
            cost.mul, cost.add, cost.div, cost.sqrt, cost.trig, cost.other,
        ]
        .map(Literal::u32_unsuffixed);
        quote!(#private::Operations::#stage(#name, [#(#counts),*]))
    });
    let skipped = &equations.skipped;
    quote! {
        /// The equations of motion, as they are evaluated.
        pub const EQUATIONS: &str = #text;
        /// What they cost, by function and stage.
        pub const OPERATIONS: &[#private::Operations] = &[#(#rows),*];
        /// What they do not contain, and why.
        pub const SKIPPED: &[&str] = &[#(#skipped),*];
    }
}

/// `arm`: unit, axes and default of a field.
pub fn declared_doc(declared: &Declared) -> String {
    let axes = match declared.frame {
        Some(Frame::Body) => ", body axes",
        Some(Frame::World) => ", world axes",
        None => "",
    };
    let moving = if declared.moves {
        ", when it is given"
    } else {
        ""
    };
    format!(
        " `{}` in {}{axes}{moving}.",
        declared.name, declared.dimension
    )
}
