//! What is generated for constraints: their violations, whether these are rounding, and the way back.

use proc_macro2::TokenStream;
use quote::quote;

use crate::mechanics::{Consistency, Equations, Reach};
use crate::symbolic::Id;

use super::code::Writer;
use super::functions::Function;
use super::naming::local;
use super::shapes::{Shapes, Values};

/// `[Violation { name, position, velocity }, ..]`
pub fn write_violations(writer: &Writer<'_>, shapes: &Shapes, equations: &Equations) -> Function {
    let constraints = &equations.constraints;
    let values = |constraint: &Consistency| {
        let position = constraint.position.map(|(value, _)| value);
        position.into_iter().chain([constraint.velocity.0])
    };
    let outputs: Vec<Id> = constraints.iter().flat_map(values).collect();
    let private = &shapes.private;
    Function::write(writer, &outputs, |values| {
        let list = constraints.iter().map(|constraint| {
            let name = &constraint.name;
            let position = optional(constraint.position.and_then(|_| values.next().cloned()));
            let velocity = values.next();
            quote!(#private::Violation { name: #name, position: #position, velocity: #velocity })
        });
        quote!([#(#list),*])
    })
}

/// `check([Size { name, position, velocity }, ..])`
pub fn write_check(writer: &Writer<'_>, shapes: &Shapes, equations: &Equations) -> Function {
    let constraints = || equations.constraints.iter().zip(&equations.reach);
    let sized = |(constraint, reach): (&Consistency, &Reach)| {
        let position = constraint.position.zip(reach.position);
        let position = position
            .into_iter()
            .flat_map(|((value, _), size)| [value, size]);
        position
            .chain([constraint.velocity.0, reach.velocity])
            .collect::<Vec<_>>()
    };
    let outputs: Vec<Id> = constraints().flat_map(sized).collect();
    let private = &shapes.private;
    Function::write(writer, &outputs, |values| {
        let list = constraints().map(|(constraint, _)| {
            let name = &constraint.name;
            let position = optional(constraint.position.map(|_| pair(values)));
            let velocity = pair(values);
            quote!(#private::Size { name: #name, position: #position, velocity: #velocity })
        });
        quote!(#private::check(&[#(#list),*]))
    })
}

/// `project(state, |state| [Row { name, position, velocity, shift, push, coupling }, ..])`
pub fn write_project(writer: &Writer<'_>, shapes: &Shapes, equations: &Equations) -> Function {
    let constraints = &equations.constraints;
    let direction =
        |constraint: &Consistency| shapes.pair_part(&constraint.linear, &constraint.angular);
    let values = |constraint: &Consistency| {
        let (velocity, size) = constraint.velocity;
        let position = constraint
            .position
            .into_iter()
            .flat_map(|(value, size)| [value, size]);
        let measured = position.chain([velocity, size]).collect::<Vec<_>>();
        [measured, direction(constraint), constraint.coupling.clone()].concat()
    };
    let outputs: Vec<Id> = constraints.iter().flat_map(values).collect();
    let (private, state, kind) = (&shapes.private, local("state"), shapes.state_type());
    let mut function = Function::write(writer, &outputs, |values| {
        let list = constraints.iter().map(|constraint| {
            let name = &constraint.name;
            let position = optional(constraint.position.map(|_| pair(values)));
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
                    velocity: #velocity,
                    shift: #private::State::rate(&#fast, &::core::default::Default::default()),
                    push: #private::State::rate(&#still, &#acceleration),
                    coupling: [#(#coupling),*],
                }
            }
        });
        quote!([#(#list),*])
    });
    let (lints, rows) = (function.lints(), function.body);
    function.body = quote!(#private::project(#state, #lints |#state: &#kind| { #rows }));
    function
}

fn optional(value: Option<TokenStream>) -> TokenStream {
    let none = || quote!(::core::option::Option::None);
    value.map_or_else(none, |value| quote!(::core::option::Option::Some(#value)))
}

/// A value and its size.
fn pair(values: &mut Values<'_>) -> TokenStream {
    let (value, size) = (values.next(), values.next());
    quote!((#value, #size))
}
