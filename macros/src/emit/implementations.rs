//! The traits of the runtime, implemented for a body.

use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};

use crate::model::{Motion, Outline, Output};

use super::code::Source;
use super::functions::{Function, Functions};
use super::naming::local;
use super::shapes::Shapes;

pub fn emit_implementations(outline: &Outline, functions: &Functions) -> TokenStream {
    let shapes = Shapes::of(outline);
    let outputs = outline.outputs.iter().map(|output| match output {
        Output::Energy => emit_energy(outline, &shapes, functions),
        Output::Momentum => emit_momentum(outline, &shapes, functions),
        Output::Balance => emit_balance(outline, &shapes, functions),
        Output::Reactions => emit_reactions(outline, &shapes, functions),
        Output::Inverse => emit_inverse(outline, &shapes, functions),
    });
    let rigid_body = emit_rigid_body(outline, &shapes, &functions.acceleration);
    let constrained = outline
        .is_constrained
        .then(|| emit_constrained(outline, &shapes, functions));
    core::iter::once(rigid_body)
        .chain(constrained)
        .chain(outputs)
        .collect()
}

/// The type of the inputs; nothing is given to a body that declares none.
fn input_type(outline: &Outline) -> TokenStream {
    let name = format_ident!("{}Input", outline.name);
    if outline.inputs.is_empty() {
        quote!(())
    } else {
        quote!(#name)
    }
}

/// The type of the unknown reactions, if there are any.
fn reactions_type(outline: &Outline) -> TokenStream {
    let name = format_ident!("{}Reactions", outline.name);
    if outline.reactions.is_empty() {
        quote!(())
    } else {
        quote!(#name)
    }
}

/// `time: f64, state: &State, input: &Input`
fn arguments(outline: &Outline, shapes: &Shapes, function: &Function) -> TokenStream {
    let time = function.argument(Source::Time, "time");
    let state = function.argument(Source::State, "state");
    let input = function.argument(Source::Input, "input");
    let (state_type, input_type) = (shapes.state_type(), input_type(outline));
    quote!(#time: f64, #state: &#state_type, #input: &#input_type)
}

/// `state: &State`
fn state_argument(shapes: &Shapes, function: &Function) -> TokenStream {
    let (state, state_type) = (
        function.argument(Source::State, "state"),
        shapes.state_type(),
    );
    quote!(#state: &#state_type)
}

/// `fn name(&self, arguments) -> result { body }`
fn method(
    name: &str,
    arguments: &TokenStream,
    result: &TokenStream,
    function: &Function,
) -> TokenStream {
    let (name, lints, body) = (format_ident!("{name}"), function.lints(), &function.body);
    quote!(#lints fn #name(&self, #arguments) -> #result { #body })
}

fn emit_rigid_body(outline: &Outline, shapes: &Shapes, function: &Function) -> TokenStream {
    let (name, private) = (&outline.name, &shapes.private);
    let (state, input) = (shapes.state_type(), input_type(outline));
    let acceleration = method(
        "acceleration",
        &arguments(outline, shapes, function),
        &shapes.acceleration_type(),
        function,
    );
    quote! {
        impl #private::RigidBody for #name {
            type Scalar = f64;
            type State = #state;
            type Input = #input;
            #[inline]
            #acceleration
        }
    }
}

fn emit_energy(outline: &Outline, shapes: &Shapes, functions: &Functions) -> TokenStream {
    let (name, private) = (&outline.name, &shapes.private);
    let (kinetic, potential) = (&functions.kinetic_energy, &functions.potential_energy);
    let scalar = quote!(f64);
    let kinetic = method(
        "kinetic_energy",
        &state_argument(shapes, kinetic),
        &scalar,
        kinetic,
    );
    let potential = method(
        "potential_energy",
        &arguments(outline, shapes, potential),
        &scalar,
        potential,
    );
    quote!(impl #private::Energy for #name { #kinetic #potential })
}

fn emit_momentum(outline: &Outline, shapes: &Shapes, functions: &Functions) -> TokenStream {
    let (name, private, angular) = (&outline.name, &shapes.private, shapes.moment_type());
    // the momentum of a body whose motion of G is not modelled is not known
    let linear = if outline.motion == Motion::Rotation {
        quote!(())
    } else {
        shapes.vector_type()
    };
    let of_state = |name: &str, result: &TokenStream, function: &Function| {
        method(name, &state_argument(shapes, function), result, function)
    };
    let translation = of_state("linear_momentum", &linear, &functions.linear_momentum);
    let rotation = of_state("angular_momentum", &angular, &functions.angular_momentum);
    let function = &functions.angular_momentum_about_pole;
    let (time, state) = (
        function.argument(Source::Time, "time"),
        state_argument(shapes, function),
    );
    let about_pole = method(
        "angular_momentum_about_pole",
        &quote!(#time: f64, #state),
        &angular,
        function,
    );
    quote! {
        impl #private::Momentum for #name {
            type Linear = #linear;
            type Angular = #angular;
            #translation
            #rotation
            #about_pole
        }
    }
}

fn emit_balance(outline: &Outline, shapes: &Shapes, functions: &Functions) -> TokenStream {
    let (name, private) = (&outline.name, &shapes.private);
    let (wrench, load) = (shapes.wrench_type(), shapes.load_type());
    let count = Literal::usize_unsuffixed(outline.loads);
    let loads = quote!([#load; #count]);
    let given = |name: &str, result: &TokenStream, function: &Function| {
        method(
            name,
            &arguments(outline, shapes, function),
            result,
            function,
        )
    };
    let applied = given("applied", &wrench, &functions.applied);
    let listed = given("loads", &loads, &functions.loads);
    let function = &functions.residual;
    let time = function.argument(Source::Time, "time");
    let acceleration = function.argument(Source::Acceleration, "acceleration");
    let input = function.argument(Source::Input, "input");
    let reactions = function.argument(Source::Reactions, "reactions");
    let reactions_type = reactions_type(outline);
    let (state, acceleration_type, input_type) = (
        state_argument(shapes, function),
        shapes.acceleration_type(),
        input_type(outline),
    );
    let of_residual = quote!(#time: f64, #state, #acceleration: &#acceleration_type, #reactions: &#reactions_type, #input: &#input_type);
    let residual = method("residual", &of_residual, &wrench, function);
    quote! {
        impl #private::Balance for #name {
            type Wrench = #wrench;
            type Reactions = #reactions_type;
            type Loads = #loads;
            #applied
            #residual
            #listed
        }
    }
}

fn emit_constrained(outline: &Outline, shapes: &Shapes, functions: &Functions) -> TokenStream {
    let (name, private) = (&outline.name, &shapes.private);
    let count = Literal::usize_unsuffixed(functions.constraint_count);
    let kind = quote!([#private::Violation; #count]);
    let violations = method(
        "violations",
        &arguments(outline, shapes, &functions.violations),
        &kind,
        &functions.violations,
    );
    let body = &functions.project.body;
    let (time, input) = (
        functions.project.argument(Source::Time, "time"),
        functions.project.argument(Source::Input, "input"),
    );
    let (state, state_type, input_type) =
        (local("state"), shapes.state_type(), input_type(outline));
    quote! {
        impl #private::Constrained for #name {
            type Violations = #kind;
            #violations
            fn project(&self, #time: f64, #state: &mut #state_type, #input: &#input_type) -> ::core::result::Result<(), #private::Inconsistent> {
                #body
            }
        }
    }
}

fn emit_reactions(outline: &Outline, shapes: &Shapes, functions: &Functions) -> TokenStream {
    let (name, private) = (&outline.name, &shapes.private);
    let (function, kind) = (&functions.reactions, reactions_type(outline));
    let kind = if outline.is_constrained {
        quote!(::core::result::Result<#kind, #private::Singular>)
    } else {
        kind
    };
    let reactions = method(
        "reactions",
        &arguments(outline, shapes, function),
        &kind,
        function,
    );
    quote! {
        impl #private::Reactions for #name {
            type Reactions = #kind;
            #reactions
        }
    }
}

fn emit_inverse(outline: &Outline, shapes: &Shapes, functions: &Functions) -> TokenStream {
    let (name, private, function) = (&outline.name, &shapes.private, &functions.inverse);
    let drives = format_ident!("{name}Drives");
    let time = function.argument(Source::Time, "time");
    let acceleration = function.argument(Source::Acceleration, "acceleration");
    let input = function.argument(Source::Input, "input");
    let (state, acceleration_type, input_type) = (
        state_argument(shapes, function),
        shapes.acceleration_type(),
        input_type(outline),
    );
    let arguments =
        quote!(#time: f64, #state, #acceleration: &#acceleration_type, #input: &#input_type);
    let inverse = method("inverse", &arguments, &quote!(#drives), function);
    quote! {
        impl #private::Inverse for #name {
            type Drives = #drives;
            #inverse
        }
    }
}
