//! Violations of constraints, the check for them, and the projection, for bodies under constraints.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use crate::emit::code::{COMMON, Method, Site, Source, Values, Writer, local};
use crate::emit::items::Addition;
use crate::mechanics::{Consistency, Reach};
use crate::model::Outline;
use crate::symbolic::Id;

use super::output::{Basis, Output, Place};
use super::subject::Subject;

#[derive(Default)]
pub struct Constrained(Option<Kept>);

/// The constraints of a motion, and the size of the rounding error in each.
struct Kept {
    constraints: Vec<Consistency>,
    reach: Vec<Reach>,
}

impl<S: Subject> Output<S> for Constrained {
    fn place(&self, outline: &Outline) -> Option<Place> {
        // where nothing moves by itself, there is no state to project
        (outline.is_constrained && !outline.is_still()).then_some(Place::First)
    }

    fn derive(&mut self, basis: &mut Basis<'_, S>) -> Option<()> {
        let Basis {
            model,
            equations,
            work,
            ..
        } = basis;
        let (constraints, reach) = model.constraints(work, equations).into_iter().unzip();
        self.0 = Some(Kept { constraints, reach });
        Some(())
    }

    fn roots(&self) -> Vec<Id> {
        let kept = self.0.iter();
        let roots = kept.flat_map(|kept| {
            let constraints = kept.constraints.iter().flat_map(Consistency::roots);
            let reach = kept.reach.iter();
            let reach = reach.flat_map(|reach| reach.position.into_iter().chain([reach.velocity]));
            constraints.chain(reach)
        });
        roots.collect()
    }

    fn emit(&self, site: &Site<'_>) -> Addition {
        let site = site.double();
        let shapes = &site.shapes;
        let [violations, check, rows] = [write_violations, write_check, write_rows]
            .map(|write| site.method(self.0.as_ref(), write));
        let private = &shapes.private;
        let count = self.0.as_ref().map_or(0, |kept| kept.constraints.len());
        let count = Literal::usize_unsuffixed(count);
        let list = quote!([#private::Violation; #count]);
        let outcome = quote!(::core::result::Result<(), #private::Inconsistent>);
        let [time, state, input] = ["time", "state", "input"].map(local);
        let (state_type, input_type) = (shapes.state_type(), site.input_type());
        let kept = quote!(#private::Kept::rows);
        let parts = [
            quote!(type Violations = #list;),
            quote! {
                fn project(&self, #time: f64, #state: &mut #state_type, #input: &#input_type) -> #outcome {
                    #private::project(#state, |#state: &#state_type| #kept(self, #time, #state, #input))
                }
                fn dependent(
                    &self,
                    #time: f64,
                    #state: &#state_type,
                    #input: &#input_type,
                ) -> ::core::option::Option<&'static str> {
                    #private::dependent(&#kept(self, #time, #state, #input))
                }
            },
        ];
        let methods = [
            ("violations", &violations, &COMMON[..], &list),
            ("check", &check, &COMMON, &outcome),
        ];
        let mut addition = Addition::implement(&site, "Constrained", parts, &methods);
        addition.costs.push(("project", rows.facts.cost));
        let row = quote!(#private::Row<<#state_type as #private::State>::Rate, #count>);
        let rows = rows.declared(
            "rows",
            &site.arguments(&rows, &COMMON),
            &quote!([#row; #count]),
        );
        let header = site.header_with("Kept", &quote!(<#count>));
        addition.implementations.extend(quote!(#header { #rows }));
        addition
    }
}

/// `[Violation { name, position, velocity }, ..]`
fn write_violations(writer: &Writer<'_>, kept: &Kept) -> Method {
    let (shapes, constraints) = (&writer.shapes, &kept.constraints);
    let values = |constraint: &Consistency| {
        let position = constraint.position.map(|(value, _)| value);
        let position = position.into_iter().chain(constraint.facing);
        position.chain([constraint.velocity.0])
    };
    let outputs: Vec<Id> = constraints.iter().flat_map(values).collect();
    let private = &shapes.private;
    Method::write(writer, &outputs, |values| {
        let list = constraints.iter().map(|constraint| {
            let name = &constraint.name;
            let position = constraint.position.map(|_| {
                let value = values.next();
                if constraint.facing.is_none() {
                    return quote!(#value);
                }
                let cosine = values.next();
                quote!(#private::off(#value, #cosine))
            });
            let position = optional(position);
            let velocity = values.next();
            quote!(#private::Violation { name: #name, position: #position, velocity: #velocity })
        });
        quote!([#(#list),*])
    })
}

/// `check([Size { name, position, facing, velocity }, ..])`
fn write_check(writer: &Writer<'_>, kept: &Kept) -> Method {
    let (shapes, constraints) = (&writer.shapes, || kept.constraints.iter().zip(&kept.reach));
    let sized = |(constraint, reach): (&Consistency, &Reach)| {
        let position = constraint.position.zip(reach.position);
        let position = position
            .into_iter()
            .flat_map(|((value, _), size)| [value, size]);
        position
            .chain(constraint.facing)
            .chain([constraint.velocity.0, reach.velocity])
            .collect::<Vec<_>>()
    };
    let outputs: Vec<Id> = constraints().flat_map(sized).collect();
    let private = &shapes.private;
    Method::write(writer, &outputs, |values| {
        let list = constraints().map(|(constraint, _)| {
            let name = &constraint.name;
            let position = optional(constraint.position.map(|_| pair(values)));
            let facing = facing(constraint, values);
            let velocity = pair(values);
            quote!(#private::Size { name: #name, position: #position, facing: #facing, velocity: #velocity })
        });
        quote!(#private::check(&[#(#list),*]))
    })
}

/// `[Row { name, position, facing, velocity, shift, push, coupling, part, follows }, ..]`
fn write_rows(writer: &Writer<'_>, kept: &Kept) -> Method {
    let (shapes, constraints) = (&writer.shapes, &kept.constraints);
    let values = |constraint: &Consistency| {
        let (velocity, size) = constraint.velocity;
        let position = constraint
            .position
            .into_iter()
            .flat_map(|(value, size)| [value, size]);
        let position = position.chain(constraint.facing);
        let measured = position.chain([velocity, size]).collect::<Vec<_>>();
        [
            measured,
            constraint.direction.clone(),
            // user-defined states are unchanged
            vec![writer.work.graph.zero(); writer.outline.states.len()],
            constraint.coupling.clone(),
        ]
        .concat()
    };
    let outputs: Vec<Id> = constraints.iter().flat_map(values).collect();
    let private = &shapes.private;
    let mut rows = Method::write(writer, &outputs, |values| {
        let list = constraints.iter().map(|constraint| {
            let (name, follows) = (&constraint.name, constraint.follows);
            let part = Literal::usize_unsuffixed(constraint.part);
            let position = optional(constraint.position.map(|_| pair(values)));
            let facing = facing(constraint, values);
            let velocity = pair(values);
            let (mut fast, mut still) = (values.clone(), values.clone());
            let acceleration = shapes.acceleration(values);
            let (fast, still) = (
                shapes.moving_state(&mut fast, true),
                shapes.moving_state(&mut still, false),
            );
            let coupling = values.take(constraints.len());
            quote! {
                #private::Row {
                    name: #name,
                    position: #position,
                    facing: #facing,
                    velocity: #velocity,
                    shift: #private::State::rate(&#fast, &::core::default::Default::default()),
                    push: #private::State::rate(&#still, &#acceleration),
                    coupling: [#(#coupling),*],
                    part: #part,
                    follows: #follows,
                }
            }
        });
        quote!([#(#list),*])
    });
    // a displacement begins at the state
    rows.facts.reads.push(Source::State);
    rows
}

fn optional(value: Option<TokenStream>) -> TokenStream {
    let none = || quote!(::core::option::Option::None);
    value.map_or_else(none, |value| quote!(::core::option::Option::Some(#value)))
}

/// The cosine of a constraint, one where nothing can be reversed.
fn facing(constraint: &Consistency, values: &mut Values<'_>) -> TokenStream {
    let cosine = constraint.facing.and_then(|_| values.next().cloned());
    cosine.unwrap_or_else(|| quote!(1.0))
}

/// A value and its size.
fn pair(values: &mut Values<'_>) -> TokenStream {
    let (value, size) = (values.next(), values.next());
    quote!((#value, #size))
}
