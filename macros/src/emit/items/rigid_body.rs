//! What every body implements: its accelerations, the times at which these switch, and its
//! integration.

use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};

use crate::emit::code::{COMMON, Method, Site, Source, Told, Writer, local, number_literal};
use crate::mechanics::{Partial, Switch};
use crate::model::Substance;
use crate::symbolic::{Id, Number};

use super::possible::Checked;

/// The accelerations, in the order of the state, and the times at which they switch.
pub struct Equated {
    pub accelerations: Vec<Id>,
    pub switches: Vec<Switch>,
    pub partial: Vec<Partial>,
}

/// The best method of integration for a body, in ascending order from the one that every body has.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Default)]
pub enum Best {
    #[default]
    RungeKutta,
    /// Series at tolerances of 10⁻ᴺ and below.
    SeriesBelow(u32),
    Series,
    ClosedForm,
}

/// `fn acceleration(..)`. Its cost and its text appear in the documentation.
pub fn write_acceleration(site: &Site<'_>, equations: Option<&Equated>) -> Method {
    let shapes = &site.shapes;
    site.method(equations, |writer, equations| {
        let outputs = &equations.accelerations;
        let mut method = Method::write(writer, outputs, |values| shapes.acceleration(values));
        // results known early are not statements, but they appear in the text
        let results = shapes
            .acceleration_names()
            .into_iter()
            .zip(&method.facts.output_text);
        let stated = results.filter(|(name, value)| name != *value);
        let text: Vec<String> = stated
            .map(|(name, value)| format!("{name} = {value}"))
            .collect();
        method.facts.text.extend(text);
        method
    })
}

/// `impl RigidBody for Body { .. }`
pub fn emit_rigid_body(
    site: &Site<'_>,
    acceleration: &Method,
    equations: Option<&Equated>,
    bodies: &[Substance],
) -> TokenStream {
    let (shapes, header) = (&site.shapes, site.header("RigidBody"));
    let (state, input, scalar) = (shapes.state_type(), site.input_type(), shapes.scalar.kind());
    let acceleration = acceleration.declared(
        "acceleration",
        &site.arguments(acceleration, &COMMON),
        &shapes.acceleration_type(),
    );
    let switches = equations.map(|equations| emit_switches(site, &equations.switches));
    let input_after = emit_input_after(site);
    let lost_load = equations.map(|equations| emit_lost_load(site, &equations.partial));
    let possible = emit_possible(site, bodies);
    // in lanes, all code must be compiled for the wide registers
    let inline = if shapes.scalar.is_generic() {
        quote!(#[allow(clippy::inline_always)] #[inline(always)])
    } else {
        quote!(#[inline])
    };
    quote! {
        #header {
            type Scalar = #scalar;
            type State = #state;
            type Input = #input;
            #inline
            #acceleration
            #switches
            #input_after
            #lost_load
            #possible
        }
    }
}

/// `lost_load(&[("drag", &[drag_x, drag_y]), ..])`, if there are loads that may have no value.
fn emit_lost_load(site: &Site<'_>, partial: &[Partial]) -> Option<TokenStream> {
    if partial.is_empty() {
        return None;
    }
    let method = site.method(Some(partial), |writer, partial| {
        let outputs: Vec<Id> = partial.iter().flat_map(|load| load.parts.clone()).collect();
        let writer = Writer {
            is_whole: true,
            ..writer.clone()
        };
        let private = &writer.shapes.private;
        Method::write(&writer, &outputs, |values| {
            let loads = partial.iter().map(|load| {
                let (name, parts) = (&load.name, values.take(load.parts.len()));
                quote!((#name, &[#(#parts),*]))
            });
            let loads: Vec<TokenStream> = loads.collect();
            quote!(#private::lost_load(&[#(#loads),*]))
        })
    });
    let name = quote!(::core::option::Option<&'static str>);
    let method = method.declared("lost_load", &site.arguments(&method, &COMMON), &name);
    Some(quote!(#[cold] #method))
}

/// `check_mass(mass)?; ..`, for bodies that change during a motion.
fn emit_possible(site: &Site<'_>, bodies: &[Substance]) -> Option<TokenStream> {
    let method = site.method(Some(bodies), |writer, bodies| {
        let graph = &writer.work.graph;
        let checked = Checked::of(bodies, |ids| !graph.are_early(ids));
        if checked.is_empty() {
            return Method::default();
        }
        // the checks take the values themselves
        let outputs = checked.values();
        let outputs: Vec<Id> = outputs.into_iter().map(|id| graph.unchecked(id)).collect();
        let writer = Writer {
            is_whole: true,
            ..writer.clone()
        };
        let private = &writer.shapes.private;
        Method::write(&writer, &outputs, |values| {
            let checks = checked.emit(values.as_slice(), private);
            quote!(#checks ::core::result::Result::Ok(()))
        })
    });
    if method.body.is_empty() || bodies.is_empty() {
        return None;
    }
    let private = &site.shapes.private;
    let result = quote!(::core::result::Result<(), #private::InvalidBody>);
    let method = method.declared("possible", &site.arguments(&method, &COMMON), &result);
    Some(quote!(const CHANGES: bool = true; #method))
}

/// `fn switches(..)`, if there are times at which the equations change.
fn emit_switches(site: &Site<'_>, switches: &[Switch]) -> Option<TokenStream> {
    if switches.is_empty() {
        return None;
    }
    let method = site.method(Some(switches), write_switches);
    let (private, times) = (&site.shapes.private, local("times"));
    let input = site.arguments(&method, &[Source::Input]);
    let (lints, body) = (method.lints(), &method.body);
    Some(quote!(#lints fn switches(&self, #input, #times: &mut #private::Switches) { #body }))
}

/// `times.at(50.0); times.every(self.start, self.period);`
fn write_switches(writer: &Writer<'_>, switches: &[Switch]) -> Method {
    // numbers are written as literals, and not made from a scalar
    let graph = &writer.work.graph;
    let number = |id: &Id| {
        graph
            .as_number(*id)
            .map(|number| number_literal(number.to_f64()))
    };
    let outputs = switches.iter().flat_map(Switch::roots);
    let open: Vec<Id> = outputs.filter(|id| number(id).is_none()).collect();
    let times = local("times");
    let writer = Writer {
        told: Told::Nothing,
        ..writer.clone()
    };
    Method::write(&writer, &open, |values| {
        let calls = switches.iter().map(|switch| {
            let name = match switch {
                Switch::At(..) => quote!(at),
                Switch::Near(..) => quote!(near),
                Switch::Every(..) => quote!(every),
            };
            let roots = switch.roots();
            let arguments = roots
                .iter()
                .filter_map(|id| number(id).or_else(|| values.next().cloned()));
            let arguments: Vec<TokenStream> = arguments.collect();
            quote!(#times.#name(#(#arguments),*);)
        });
        quote!(#(#calls)*)
    })
}

/// The inputs at a later time: a `.moving` input continues with its rate and acceleration.
fn emit_input_after(site: &Site<'_>) -> Option<TokenStream> {
    let (outline, scalar) = (site.outline, &site.shapes.scalar);
    let kind = scalar.kind();
    let (input, duration, half) = (local("input"), local("duration"), local("half"));
    let moving: Vec<_> = outline
        .inputs
        .windows(3)
        .filter(|inputs| inputs[0].moves)
        .map(|inputs| {
            let [value, rate, acceleration] = [&inputs[0].name, &inputs[1].name, &inputs[2].name];
            quote! {
                #value: #input.#value + (#input.#rate + #input.#acceleration * #half) * #duration,
                #rate: #input.#rate + #input.#acceleration * #duration,
            }
        })
        .collect();
    if moving.is_empty() {
        return None;
    }
    let (name, all) = (format_ident!("{}Input", outline.name), site.input_type());
    let one_half = scalar.constant(&Number::ratio(1, 2), &quote!(#duration));
    Some(quote! {
        #[inline]
        fn input_after(&self, #input: &#all, #duration: #kind) -> ::core::option::Option<#all> {
            let #half = #one_half * #duration;
            ::core::option::Option::Some(#name { #(#moving)* ..*#input })
        }
    })
}

/// `impl Integrate for Body { type Best = ..; }`, for bodies that move.
pub fn emit_integrate(site: &Site<'_>, best: Best) -> TokenStream {
    if site.outline.is_still() {
        return TokenStream::new();
    }
    let site = site.double();
    let (header, private) = (site.header("Integrate"), &site.shapes.private);
    let method = match best {
        Best::ClosedForm => quote!(#private::ClosedForm),
        Best::SeriesBelow(exponent) => {
            let exponent = Literal::u32_unsuffixed(exponent);
            quote!(#private::SeriesBelow<#exponent>)
        }
        Best::Series => quote!(#private::TaylorSeries),
        Best::RungeKutta => quote!(#private::RungeKuttaPair),
    };
    let method = if site.outline.is_constrained {
        quote!(#private::Projected<#method>)
    } else {
        method
    };
    quote!(#header { type Best = #method; })
}
