//! The traits of the runtime, implemented for a body.

use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};

use crate::model::{Outline, Output};
use crate::symbolic::Number;

use super::code::Source;
use super::functions::{Function, Functions};
use super::naming::local;
use super::paths::private;
use super::scalar::Scalar;
use super::shapes::Shapes;

pub fn emit_implementations(outline: &Outline, functions: &Functions) -> TokenStream {
    let shapes = Shapes::of(outline);
    let outputs = outline.outputs.iter().map(|output| match output {
        Output::Energy => emit_energy(outline, &shapes, functions),
        Output::Momentum => emit_momentum(outline, &shapes, functions),
        Output::Balance => emit_balance(outline, &shapes, functions),
        Output::Reactions => emit_reactions(outline, &shapes, functions),
        Output::Inverse => emit_inverse(outline, &shapes, functions),
        Output::Flow => emit_flow(outline, functions),
        Output::Taylor => emit_taylor(outline, functions),
    });
    let rigid_body = emit_rigid_body(outline, &shapes, functions);
    let constrained = outline
        .is_constrained
        .then(|| emit_constrained(outline, functions));
    let integrate = emit_integrate(outline);
    [rigid_body, integrate]
        .into_iter()
        .chain(constrained)
        .chain(outputs)
        .collect()
}

/// `impl Trait for Body`, of a generic body `impl<T: Scalar> Trait for Body<T>`
pub fn header(outline: &Outline, scalar: &Scalar, name: &str) -> TokenStream {
    let private = private(outline);
    let (declared, applied) = (scalar.declared(), scalar.applied());
    let (body, name) = (&outline.name, format_ident!("{name}"));
    quote!(impl #declared #private::#name for #body #applied)
}

/// The type of the inputs; nothing is given to a body that declares none.
fn input_type(outline: &Outline, scalar: &Scalar) -> TokenStream {
    let (name, applied) = (format_ident!("{}Input", outline.name), scalar.applied());
    if outline.inputs.is_empty() {
        quote!(())
    } else {
        quote!(#name #applied)
    }
}

/// The type of the unknown reactions, if there are any.
fn reactions_type(outline: &Outline) -> TokenStream {
    let (name, applied) = (
        format_ident!("{}Reactions", outline.name),
        Scalar::of(outline).applied(),
    );
    if outline.reactions.is_empty() {
        quote!(())
    } else {
        quote!(#name #applied)
    }
}

/// `time: f64, state: &State, input: &Input`
fn arguments(outline: &Outline, shapes: &Shapes, function: &Function) -> TokenStream {
    let time = function.argument(Source::Time, "time");
    let state = function.argument(Source::State, "state");
    let input = function.argument(Source::Input, "input");
    let (state_type, input_type) = (shapes.state_type(), input_type(outline, &shapes.scalar));
    let scalar = shapes.scalar.kind();
    quote!(#time: #scalar, #state: &#state_type, #input: &#input_type)
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

fn emit_rigid_body(outline: &Outline, shapes: &Shapes, functions: &Functions) -> TokenStream {
    let function = &functions.acceleration;
    let header = header(outline, &shapes.scalar, "RigidBody");
    let (state, input) = (shapes.state_type(), input_type(outline, &shapes.scalar));
    let scalar = shapes.scalar.kind();
    let acceleration = method(
        "acceleration",
        &arguments(outline, shapes, function),
        &shapes.acceleration_type(),
        function,
    );
    let private = &shapes.private;
    let switches = functions.switches.as_ref().map(|function| {
        let given = function.argument(Source::Input, "input");
        let times = local("times");
        let arguments = quote!(#given: &#input, #times: &mut #private::Switches);
        let (lints, body) = (function.lints(), &function.body);
        quote!(#lints fn switches(&self, #arguments) { #body })
    });
    let input_after = emit_input_after(outline, shapes);
    let lost_load = functions.lost_load.as_ref().map(|function| {
        let name = quote!(::core::option::Option<&'static str>);
        let method = method(
            "lost_load",
            &arguments(outline, shapes, function),
            &name,
            function,
        );
        quote!(#[cold] #method)
    });
    // in lanes, all of it has to be compiled for the register
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
        }
    }
}

/// An input that moves goes on with its rate and acceleration.
fn emit_input_after(outline: &Outline, shapes: &Shapes) -> Option<TokenStream> {
    let kind = shapes.scalar.kind();
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
    let name = format_ident!("{}Input", outline.name);
    let all = input_type(outline, &shapes.scalar);
    let one_half = shapes
        .scalar
        .constant(&Number::ratio(1, 2), &quote!(#duration));
    Some(quote! {
        #[inline]
        fn input_after(&self, #input: &#all, #duration: #kind) -> ::core::option::Option<#all> {
            let #half = #one_half * #duration;
            ::core::option::Option::Some(#name { #(#moving)* ..*#input })
        }
    })
}

fn emit_energy(outline: &Outline, shapes: &Shapes, functions: &Functions) -> TokenStream {
    let header = header(outline, &shapes.scalar, "Energy");
    let (kinetic, potential) = (&functions.kinetic_energy, &functions.potential_energy);
    let scalar = shapes.scalar.kind();
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
    quote!(#header { #kinetic #potential })
}

fn emit_momentum(outline: &Outline, shapes: &Shapes, functions: &Functions) -> TokenStream {
    let header = header(outline, &shapes.scalar, "Momentum");
    let angular = shapes.moment_type();
    // the momentum of a body whose motion of G is not modelled is not known
    let linear = if outline.motion.knows_position {
        shapes.vector_type()
    } else {
        quote!(())
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
    let scalar = shapes.scalar.kind();
    let about_pole = method(
        "angular_momentum_about_pole",
        &quote!(#time: #scalar, #state),
        &angular,
        function,
    );
    quote! {
        #header {
            type Linear = #linear;
            type Angular = #angular;
            #translation
            #rotation
            #about_pole
        }
    }
}

fn emit_balance(outline: &Outline, shapes: &Shapes, functions: &Functions) -> TokenStream {
    let header = header(outline, &shapes.scalar, "Balance");
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
        input_type(outline, &shapes.scalar),
    );
    let scalar = shapes.scalar.kind();
    let of_residual = quote!(#time: #scalar, #state, #acceleration: &#acceleration_type, #reactions: &#reactions_type, #input: &#input_type);
    let residual = method("residual", &of_residual, &wrench, function);
    quote! {
        #header {
            type Wrench = #wrench;
            type Reactions = #reactions_type;
            type Loads = #loads;
            #applied
            #residual
            #listed
        }
    }
}

fn emit_constrained(outline: &Outline, functions: &Functions) -> TokenStream {
    let shapes = &Shapes::double(outline);
    let header = header(outline, &shapes.scalar, "Constrained");
    let private = &shapes.private;
    let count = Literal::usize_unsuffixed(functions.constraint_count);
    let kind = quote!([#private::Violation; #count]);
    let violations = method(
        "violations",
        &arguments(outline, shapes, &functions.violations),
        &kind,
        &functions.violations,
    );
    let outcome = quote!(::core::result::Result<(), #private::Inconsistent>);
    let check = method(
        "check",
        &arguments(outline, shapes, &functions.check),
        &outcome,
        &functions.check,
    );
    let body = &functions.project.body;
    let (time, input) = (
        functions.project.argument(Source::Time, "time"),
        functions.project.argument(Source::Input, "input"),
    );
    let (state, state_type, input_type) = (
        local("state"),
        shapes.state_type(),
        input_type(outline, &shapes.scalar),
    );
    let scalar = shapes.scalar.kind();
    quote! {
        #header {
            type Violations = #kind;
            #violations
            #check
            fn project(&self, #time: #scalar, #state: &mut #state_type, #input: &#input_type) -> #outcome {
                #body
            }
        }
    }
}

fn emit_reactions(outline: &Outline, shapes: &Shapes, functions: &Functions) -> TokenStream {
    let header = header(outline, &shapes.scalar, "Reactions");
    let private = &shapes.private;
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
        #header {
            type Reactions = #kind;
            #reactions
        }
    }
}

fn emit_inverse(outline: &Outline, shapes: &Shapes, functions: &Functions) -> TokenStream {
    let header = header(outline, &shapes.scalar, "Inverse");
    let (name, function) = (&outline.name, &functions.inverse);
    let (drives, applied) = (format_ident!("{name}Drives"), shapes.scalar.applied());
    let drives = quote!(#drives #applied);
    let private = &shapes.private;
    let drives = if function.has_pivots {
        quote!(::core::result::Result<#drives, #private::Singular>)
    } else {
        drives
    };
    let time = function.argument(Source::Time, "time");
    let acceleration = function.argument(Source::Acceleration, "acceleration");
    let input = function.argument(Source::Input, "input");
    let (state, acceleration_type, input_type) = (
        state_argument(shapes, function),
        shapes.acceleration_type(),
        input_type(outline, &shapes.scalar),
    );
    let scalar = shapes.scalar.kind();
    let arguments =
        quote!(#time: #scalar, #state, #acceleration: &#acceleration_type, #input: &#input_type);
    let inverse = method("inverse", &arguments, &drives, function);
    quote! {
        #header {
            type Drives = #drives;
            #inverse
        }
    }
}

/// With the method that is best for what the description asks for.
fn emit_integrate(outline: &Outline) -> TokenStream {
    let shapes = Shapes::double(outline);
    let header = header(outline, &shapes.scalar, "Integrate");
    let private = &shapes.private;
    let method = if outline.outputs.contains(&Output::Flow) {
        quote!(#private::ClosedForm)
    } else if outline.outputs.contains(&Output::Taylor) {
        quote!(#private::TaylorSeries)
    } else {
        quote!(#private::DormandPrince)
    };
    let method = if outline.is_constrained {
        quote!(#private::Projected<#method>)
    } else {
        method
    };
    quote!(#header { type Best = #method; })
}

/// Elliptic functions are those of doubles.
fn emit_flow(outline: &Outline, functions: &Functions) -> TokenStream {
    let shapes = Shapes::double(outline);
    let header = header(outline, &shapes.scalar, "Flow");
    let (kind, state, state_type) = (&functions.path_type, local("state"), shapes.state_type());
    let (lints, body) = (functions.path.lints(), &functions.path.body);
    quote! {
        #header {
            type Path = #kind;
            #lints
            fn path(&self, #state: &#state_type) -> #kind { #body }
        }
    }
}

/// In doubles, of a generic body too.
fn emit_taylor(outline: &Outline, functions: &Functions) -> TokenStream {
    let shapes = Shapes::double(outline);
    let header = header(outline, &shapes.scalar, "Taylor");
    let (private, function) = (&shapes.private, &functions.expand);
    let (state_type, input_type) = (shapes.state_type(), input_type(outline, &shapes.scalar));
    let width = Literal::usize_unsuffixed(functions.product_count);
    let time = function.argument(Source::Time, "time");
    let input = function.argument(Source::Input, "input");
    let (state, series) = (local("state"), local("series"));
    let products = local("products");
    let (lints, body) = (function.lints(), &function.body);
    let axes = functions.axes.as_ref().map(|axes| {
        let (state, time) = (
            state_argument(&shapes, axes),
            axes.argument(Source::Time, "time"),
        );
        let kind = quote!(#private::Axes);
        method("axes", &quote!(#time: f64, #state), &kind, axes)
    });
    quote! {
        #header {
            type Products<A: #private::Arithmetic, const COUNT: usize> = #private::Products<A, #width, COUNT>;
            #axes
            #lints
            #[allow(clippy::inline_always)]
            #[inline(always)]
            fn expand<A: #private::Arithmetic, const COUNT: usize>(&self, #time: f64, #state: &#state_type, #input: &#input_type, #products: &mut Self::Products<A, COUNT>, #series: &mut #private::Series<#state_type, COUNT>) {
                #body
            }
        }
    }
}
