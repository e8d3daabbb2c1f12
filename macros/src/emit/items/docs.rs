//! The documentation of a body: its equations, its class, the cost of its functions, and the
//! skipped terms.

use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::quote;

use crate::emit::code::{Method, private};
use crate::emit::page::{laws_in_text, laws_on_page, statements_on_page};
use crate::mechanics::Report;
use crate::model::{Declared, FrameWord, Outline, shown};
use crate::symbolic::Cost;

use super::addition::Addition;
use super::constructor::Constructor;
use super::rigid_body::Best;
use super::symbols::symbols;

/// The rustdoc of the type, and its associated constants.
pub struct Documentation {
    /// The documentation of the type. It contains the equations only when rustdoc runs: in an
    /// expansion, the code shows them.
    pub lines: TokenStream,
    /// `EQUATIONS`, `OPERATIONS`, `SKIPPED`.
    pub constants: TokenStream,
}

impl Documentation {
    pub fn write(
        outline: &Outline,
        acceleration: &Method,
        constructor: &Constructor,
        report: &Report,
        addition: &Addition,
    ) -> Self {
        let stored = (!constructor.stored.is_empty()).then_some(("new", constructor.cost));
        let stored = stored.map(|(name, cost)| (name, "parameter", cost));
        let evaluated = [("acceleration", acceleration.facts.cost)].into_iter();
        let evaluated = evaluated.chain(addition.costs.iter().copied());
        let evaluated = evaluated.map(|(name, cost)| (name, "state", cost));
        let costs: Vec<_> = stored.into_iter().chain(evaluated).collect();
        let text = equations_text(acceleration, constructor);
        let named = [&constructor.symbols[..], &acceleration.facts.symbols].concat();
        let symbols = symbols(outline, &named, &text);
        let mut lines = lines(outline, (&symbols, &text), &costs, report);
        if !outline.is_still() {
            let method = integration(addition.best, outline.is_constrained);
            lines.extend(quote!(#[cfg_attr(doc, doc = "", doc = #method)]));
        }
        let guards = acceleration.facts.guards;
        let singular = [
            guards.pivots.then(|| singular(outline)),
            guards.positives.then_some(CHANGING),
        ];
        if guards.pivots || guards.positives {
            lines.extend(quote!(#[doc = ""] #[doc = " # Singular configurations"]));
        }
        for remark in singular.into_iter().flatten() {
            lines.extend(quote!(#[doc = ""] #[doc = #remark]));
        }
        for remark in &addition.remarks {
            lines.extend(quote!(#[doc = ""] #[doc = #remark]));
        }
        Self {
            lines,
            constants: constants(outline, (&symbols, &text), &costs, &report.skipped),
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
    (symbols, text): (&[(String, String)], &[String]),
    costs: &[(&str, &str, Cost)],
    report: &Report,
) -> TokenStream {
    let motion = outline.motion.word;
    let title = if outline.doc.is_empty() {
        vec![if outline.is_system {
            "A system of rigid bodies.".to_owned()
        } else {
            format!("A rigid body in `{motion}` motion.")
        }]
    } else {
        outline.doc.clone()
    };
    let title = title.iter().map(|line| spaced(line));
    let in_text = laws_in_text(&report.laws);
    let in_text = in_text.iter().map(|law| format!("\n - `{law}`"));
    let in_text: String = in_text.collect();
    let page = page(symbols, text, report);
    let costs: Vec<String> = costs
        .iter()
        .map(|(name, _, cost)| format!("`{name}`: {}", describe(*cost)))
        .collect();
    let lists = report.lists.iter();
    let lists = lists.flat_map(|(heading, rows)| listed(heading, rows));
    let params = listed("Parameters", &params_rows(outline));
    let params = (!params.is_empty()).then(|| params.join("\n"));
    let params = params.into_iter();
    let operations = listed("Operations", &costs);
    let skipped = listed("Skipped", &report.skipped);
    quote! {
        #(#[doc = #title])*
        #[cfg_attr(not(doc), doc = #in_text)]
        #[cfg_attr(doc, doc = #page)]
        #(#[cfg_attr(doc, doc = #params)])*
        #(#[doc = #lists])*
        #(#[doc = #operations])*
        #(#[doc = #skipped])*
    }
}

/// What only rustdoc shows: laws and equations in `MathML`, and the statements as they are
/// computed.
fn page(symbols: &[(String, String)], text: &[String], report: &Report) -> String {
    let headed = |heading: &str, content: Option<String>| {
        content.map_or_else(String::new, |content| {
            format!("\n# {heading}\n\n{content}\n")
        })
    };
    let laws = headed("Laws", laws_on_page(&report.laws));
    let equations = headed("Equations", statements_on_page(text));
    let symbols = symbols.iter();
    let symbols = symbols.map(|(names, meaning)| format!(" - `{names}`: {meaning}"));
    let symbols = symbols.collect::<Vec<_>>().join("\n");
    let statements = text.join("\n");
    format!(
        "{laws}{equations}\n{symbols}\n\n<details><summary>Statements as computed</summary>\n\n```text\n\
         {statements}\n```\n\n</details>\n"
    )
}

/// The method and the tolerance of `integrate`.
fn integration(best: Best, is_constrained: bool) -> String {
    let pair = "Verner's of order 9, and Dormand and Prince's of order 8 for tolerances above 1e-5";
    let method = match best {
        Best::ClosedForm => "evaluates the closed form; a tolerance has no effect".to_owned(),
        Best::Series => "takes steps of Taylor series, with errors of 1e-9 per step".to_owned(),
        Best::SeriesBelow(exponent) => format!(
            "takes steps of Taylor series, with errors of 1e-9 per step, and for tolerances above \
             1e-{exponent} steps of a Runge–Kutta pair: {pair}"
        ),
        Best::RungeKutta => {
            format!("takes steps of a Runge–Kutta pair, with errors of 1e-9 per step: {pair}")
        }
    };
    let projected = if is_constrained {
        ". After each step the state is projected onto the constraints"
    } else {
        ""
    };
    format!("By default `integrate` {method}{projected}.")
}

/// The equations that the constructor computes, followed by those of the acceleration.
fn equations_text(acceleration: &Method, constructor: &Constructor) -> Vec<String> {
    let (stored, evaluated) = (&constructor.text[..], &acceleration.facts.text[..]);
    if stored.is_empty() {
        return evaluated.to_vec();
    }
    let [once, always] = ["# once, in the constructor", "# at every evaluation"].map(str::to_owned);
    [&[once], stored, &[always], evaluated].concat()
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

/// In which states a changing body has no acceleration.
const CHANGING: &str =
    " Where the mass or an inertia, which can change, is not positive, `acceleration` is NaN.";

/// In which states a body has no acceleration, if a divisor may vanish.
fn singular(outline: &Outline) -> &'static str {
    if outline.is_constrained {
        " Where the constraints do not determine their reactions, `acceleration` is NaN, and \
         `reactions`, if requested, returns an error."
    } else {
        " Where the mass or an inertia, including the terms of loads that depend on the acceleration, \
         is not positive, `acceleration` is NaN."
    }
}

fn counts(cost: Cost) -> [(u32, &'static str); 6] {
    [
        (cost.mul, "mul"),
        (cost.add, "add"),
        (cost.div, "div"),
        (cost.sqrt, "sqrt"),
        (cost.trig, "trig"),
        (cost.other, "other"),
    ]
}

fn describe(cost: Cost) -> String {
    let counted = counts(cost).into_iter().filter(|(count, _)| *count > 0);
    let words: Vec<String> = counted
        .map(|(count, name)| format!("{count} {name}"))
        .collect();
    if words.is_empty() {
        return "none".to_owned();
    }
    words.join(" + ")
}

fn constants(
    outline: &Outline,
    (symbols, text): (&[(String, String)], &[String]),
    costs: &[(&str, &str, Cost)],
    skipped: &[String],
) -> TokenStream {
    let private = private(outline);
    let symbols = symbols.iter();
    let symbols = symbols.map(|(names, meaning)| format!("# {names}: {meaning}"));
    let text = symbols.chain(text.iter().cloned());
    let text = text.collect::<Vec<_>>().join("\n");
    let rows = costs.iter().map(|(name, stage, cost)| {
        let stage = Ident::new(stage, Span::call_site());
        let counts = counts(*cost).map(|(count, _)| Literal::u32_unsuffixed(count));
        quote!(#private::Operations::#stage(#name, [#(#counts),*]))
    });
    quote! {
        /// The equations of motion, as evaluated.
        pub const EQUATIONS: &str = {
            const TEXT: &str = #text;
            TEXT
        };
        /// Their operation counts, by function and stage.
        pub const OPERATIONS: &[#private::Operations] = &[#(#rows),*];
        /// The terms that were left out, and why.
        pub const SKIPPED: &[&str] = &[#(#skipped),*];
    }
}

/// The documentation of a field: the text in the description, and its unit, axes and default.
pub fn declared_doc(declared: &Declared) -> String {
    let moving = if declared.moves {
        ", at the time it is given"
    } else {
        ""
    };
    let texts = declared.text.iter().map(|line| format!("{line}\n"));
    let mut text: String = texts.collect();
    if !text.is_empty() {
        text.push('\n');
    }
    let (name, axes) = (&declared.name, axes(declared));
    let unit = declared.in_unit();
    let default = default_value(declared).map(|value| format!(", {value} by default"));
    let default = default.unwrap_or_default();
    format!("{text} `{name}`{unit}{axes}{moving}{default}.")
}

fn axes(declared: &Declared) -> String {
    let axes = |frame: FrameWord| format!(", {} axes", frame.text());
    declared.frame.map_or_else(String::new, axes)
}

/// `2.4`, or `(0, 0, 1)`.
fn default_value(declared: &Declared) -> Option<String> {
    let numbers = declared.default.as_ref()?.iter().map(shown);
    let numbers = numbers.collect::<Vec<_>>().join(", ");
    Some(match declared.frame {
        None => numbers,
        Some(_) => format!("({numbers})"),
    })
}

/// The parameters with their defaults.
pub fn params_rows(outline: &Outline) -> Vec<String> {
    let rows = outline.params.iter().map(|param| {
        let (name, unit) = (&param.name, param.plain_unit());
        let value = match default_value(param) {
            Some(value) => format!(" = {value} {unit}"),
            None => param.in_unit(),
        };
        let text = param.text.iter().map(|line| line.trim());
        let text: Vec<&str> = text.take_while(|line| !line.is_empty()).collect();
        let text = (!text.is_empty()).then(|| format!(": {}", text.join(" ")));
        let (value, axes) = (value.trim_end(), axes(param));
        format!("`{name}`{value}{axes}{}", text.unwrap_or_default())
    });
    rows.collect()
}
