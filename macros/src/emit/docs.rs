//! The documentation of a body: its equations, what they cost and what was left out.

use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::quote;

use crate::mechanics::Equations;
use crate::model::{Declared, Frame, Outline};
use crate::symbolic::Cost;

use super::implementations::Bodies;
use super::items::{Constructor, private};

/// The rustdoc of the type, and its inherent constants.
pub struct Documentation {
    /// Lines of the type's documentation.
    pub lines: Vec<String>,
    /// `EQUATIONS`, `OPERATIONS`, `SKIPPED`.
    pub constants: TokenStream,
}

impl Documentation {
    pub fn write(
        outline: &Outline,
        bodies: &Bodies,
        constructor: &Constructor,
        equations: &Equations,
    ) -> Self {
        let mut functions: Vec<(&str, &str, Cost)> = bodies
            .functions(outline)
            .into_iter()
            .map(|(name, function)| (name, "State", function.cost))
            .collect();
        if !constructor.stored.is_empty() {
            functions.insert(0, ("new", "Parameter", constructor.cost));
        }
        Self {
            lines: lines(outline, bodies, &functions, equations),
            constants: constants(outline, bodies, &functions, equations),
        }
    }

    pub fn stub() -> Self {
        Self {
            lines: vec![" A description with errors.".to_owned()],
            constants: TokenStream::new(),
        }
    }
}

fn lines(
    outline: &Outline,
    bodies: &Bodies,
    functions: &[(&str, &str, Cost)],
    equations: &Equations,
) -> Vec<String> {
    let motion = outline.motion.word();
    let mut lines = if outline.doc.is_empty() {
        vec![format!("A rigid body in `{motion}` motion.")]
    } else {
        outline.doc.clone()
    };
    lines.push(String::new());
    lines.push("```text".to_owned());
    lines.extend(bodies.equations.iter().cloned());
    lines.push("```".to_owned());
    let costs: Vec<String> = functions
        .iter()
        .map(|(name, _, cost)| format!("`{name}` {}", describe(*cost)))
        .collect();
    lines.push(format!("Operations: {}.", costs.join("; ")));
    if !equations.skipped.is_empty() {
        lines.push(String::new());
        lines.push(format!("Skipped: {}.", equations.skipped.join("; ")));
    }
    lines
        .into_iter()
        .map(|line| {
            if line.is_empty() {
                line
            } else {
                format!(" {line}")
            }
        })
        .collect()
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
    bodies: &Bodies,
    functions: &[(&str, &str, Cost)],
    equations: &Equations,
) -> TokenStream {
    let private = private(outline);
    let text = bodies.equations.join("\n");
    let rows = functions.iter().map(|(name, stage, cost)| {
        let stage = Ident::new(stage, Span::call_site());
        let counts = [
            cost.mul, cost.add, cost.div, cost.sqrt, cost.trig, cost.other,
        ]
        .map(Literal::u32_unsuffixed);
        quote!(#private::Operations::counted(#name, #private::Stage::#stage, [#(#counts),*]))
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
    format!(" `{}` in {}{axes}.", declared.name, declared.dimension)
}
