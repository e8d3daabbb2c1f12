//! The traits of the runtime, implemented for a body.

use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::{format_ident, quote};

use crate::mechanics::{Equations, Resultant};
use crate::model::{Family, Model, Motion, Outline, Output};
use crate::symbolic::{Components, Cost, Id, Stage};

use super::code::{Code, Fields, Source, Writer};
use super::items::private;

/// The bodies of all generated functions.
pub struct Bodies {
    pub acceleration: Function,
    pub kinetic_energy: Function,
    pub potential_energy: Function,
    pub linear_momentum: Function,
    pub angular_momentum: Function,
    pub angular_momentum_about_pole: Function,
    pub applied: Function,
    pub residual: Function,
    pub loads: Function,
    /// Number of loads.
    pub load_count: usize,
    /// The acceleration as text.
    pub equations: Vec<String>,
}

/// The body of one function, and which arguments it reads.
#[derive(Default)]
pub struct Function {
    body: TokenStream,
    reads: Vec<Source>,
    pub cost: Cost,
}

impl Function {
    /// An argument, with a leading underscore if it is not read.
    fn argument(&self, source: Source, name: &str) -> Ident {
        let read = self.reads.contains(&source);
        Ident::new(
            &if read {
                name.to_owned()
            } else {
                format!("_{name}")
            },
            Span::mixed_site(),
        )
    }

    fn from_code(code: Code, value: impl FnOnce(&[TokenStream]) -> TokenStream) -> Self {
        let value = value(&code.outputs);
        let statements = code.statements;
        let mut reads: Vec<Source> = code.reads.into_iter().collect();
        reads.sort_unstable_by_key(|source| *source as usize);
        Self {
            body: quote!(#statements #value),
            reads,
            cost: code.cost,
        }
    }
}

/// Shapes of vectors and moments, by the kind of motion.
struct Shapes {
    motion: Motion,
    private: TokenStream,
}

impl Shapes {
    fn of(outline: &Outline) -> Self {
        Self {
            motion: outline.motion,
            private: private(outline),
        }
    }

    fn state(&self) -> TokenStream {
        let private = &self.private;
        let name = match self.motion {
            Motion::Planar => "Planar",
            Motion::PlanarTranslation => "PlanarTranslation",
            Motion::Spatial => "Spatial",
            Motion::Translation => "Translation",
            Motion::Rotation => "Rotation",
        };
        let name = format_ident!("{name}");
        quote!(#private::#name)
    }

    fn vector_type(&self) -> TokenStream {
        let private = &self.private;
        if self.motion.is_planar() {
            quote!(#private::Vector2<f64>)
        } else {
            quote!(#private::Vector3<f64>)
        }
    }

    fn moment_type(&self) -> TokenStream {
        if self.motion.is_planar() {
            quote!(f64)
        } else {
            self.vector_type()
        }
    }

    fn acceleration_type(&self) -> TokenStream {
        let private = &self.private;
        match self.motion {
            Motion::Planar => quote!(#private::PlanarAcceleration),
            Motion::Spatial => quote!(#private::SpatialAcceleration),
            _ => self.vector_type(),
        }
    }

    fn wrench_type(&self) -> TokenStream {
        let private = &self.private;
        match self.motion {
            Motion::Rotation => self.vector_type(),
            _ if self.motion.is_planar() => quote!(#private::PlanarWrench),
            _ => quote!(#private::Wrench),
        }
    }

    fn load_type(&self) -> TokenStream {
        let private = &self.private;
        if self.motion.is_planar() {
            quote!(#private::PlanarLoad)
        } else {
            quote!(#private::Load)
        }
    }

    fn vector(&self, components: &[TokenStream]) -> TokenStream {
        let private = &self.private;
        let components = &components[..self.motion.axes()];
        let kind = if self.motion.is_planar() {
            quote!(Vector2)
        } else {
            quote!(Vector3)
        };
        quote!(#private::#kind::new(#(#components),*))
    }

    fn moment(&self, components: &[TokenStream]) -> TokenStream {
        if self.motion.is_planar() {
            components[2].clone()
        } else {
            self.vector(components)
        }
    }

    fn wrench(&self, components: &[TokenStream]) -> TokenStream {
        let (force, moment) = (self.vector(components), self.moment(&components[3..]));
        let kind = self.wrench_type();
        if self.motion == Motion::Rotation {
            moment
        } else {
            quote!(#kind { force: #force, moment: #moment })
        }
    }

    fn acceleration(&self, components: &[TokenStream]) -> TokenStream {
        let (linear, angular) = (self.vector(components), self.moment(&components[3..]));
        let kind = self.acceleration_type();
        match self.motion {
            Motion::Planar | Motion::Spatial => {
                quote!(#kind { linear: #linear, angular: #angular })
            }
            Motion::Rotation => angular,
            Motion::Translation | Motion::PlanarTranslation => linear,
        }
    }
}

impl Bodies {
    pub fn write(outline: &Outline, model: &Model, equations: &Equations, fields: &Fields) -> Self {
        let shapes = Shapes::of(outline);
        let writer = Writer {
            model,
            outline,
            fields,
            private: private(outline),
        };
        let code = |outputs: &[Id]| writer.function(outputs, Stage::State);
        let both = |first: &Components, second: &Components| -> Vec<Id> {
            first.iter().chain(second).copied().collect()
        };
        let scalar = |id: Option<Id>| {
            id.map(|id| Function::from_code(code(&[id]), |values| values[0].clone()))
                .unwrap_or_default()
        };
        let wrench = |resultant: Option<&Resultant>| {
            let resultant =
                resultant.map(|resultant| code(&wrench_outputs(model.motion, resultant)));
            resultant
                .map(|code| Function::from_code(code, |values| shapes.wrench(values)))
                .unwrap_or_default()
        };
        let acceleration = code(&both(&equations.linear, &equations.angular));
        let mut text = acceleration.text.clone();
        text.extend(last_lines(model, &acceleration));
        let momentum = equations.momentum.as_ref();
        let vector = |components: Option<&Components>| {
            let code = components.map(|components| code(components));
            code.map(|code| Function::from_code(code, |values| shapes.vector(values)))
                .unwrap_or_default()
        };
        let moment = |components: Option<&Components>| {
            let code = components.map(|components| code(&moment_outputs(model.motion, components)));
            code.map(|code| Function::from_code(code, |values| shapes.moment(values)))
                .unwrap_or_default()
        };
        let balance = equations.balance.as_ref();
        Self {
            acceleration: Function::from_code(acceleration, |values| shapes.acceleration(values)),
            kinetic_energy: scalar(equations.energy.as_ref().map(|energy| energy.kinetic)),
            potential_energy: scalar(equations.energy.as_ref().map(|energy| energy.potential)),
            linear_momentum: match model.motion {
                Motion::Rotation => Function::default(),
                _ => vector(momentum.map(|momentum| &momentum.linear)),
            },
            angular_momentum: moment(momentum.map(|momentum| &momentum.angular)),
            angular_momentum_about_pole: moment(momentum.map(|momentum| &momentum.about_pole)),
            applied: wrench(balance.map(|balance| &balance.applied)),
            residual: wrench(balance.map(|balance| &balance.residual)),
            loads: balance
                .map(|_| emit_loads(&writer, &shapes, equations))
                .unwrap_or_default(),
            load_count: balance.map_or(0, |balance| balance.loads.len()),
            equations: text,
        }
    }

    /// Bodies that are never run.
    pub fn stub(_: &Outline) -> Self {
        let never = || Function {
            body: quote!(::core::unreachable!("the description has errors")),
            ..Function::default()
        };
        Self {
            acceleration: never(),
            kinetic_energy: never(),
            potential_energy: never(),
            linear_momentum: never(),
            angular_momentum: never(),
            angular_momentum_about_pole: never(),
            applied: never(),
            residual: never(),
            loads: never(),
            load_count: 0,
            equations: Vec::new(),
        }
    }

    /// The generated functions by name, for the table of operations.
    pub fn functions(&self, outline: &Outline) -> Vec<(&'static str, &Function)> {
        let mut functions = vec![("acceleration", &self.acceleration)];
        for output in &outline.outputs {
            match output {
                Output::Energy => functions.extend([
                    ("kinetic_energy", &self.kinetic_energy),
                    ("potential_energy", &self.potential_energy),
                ]),
                Output::Momentum => functions.extend([
                    ("linear_momentum", &self.linear_momentum),
                    ("angular_momentum", &self.angular_momentum),
                    (
                        "angular_momentum_about_pole",
                        &self.angular_momentum_about_pole,
                    ),
                ]),
                Output::Balance => functions.extend([
                    ("applied", &self.applied),
                    ("residual", &self.residual),
                    ("loads", &self.loads),
                ]),
            }
        }
        functions
    }
}

/// Components that are not returned are not computed.
fn wrench_outputs(motion: Motion, resultant: &Resultant) -> Vec<Id> {
    let force = if motion == Motion::Rotation {
        resultant.moment
    } else {
        resultant.force
    };
    force
        .into_iter()
        .chain(moment_outputs(motion, &resultant.moment))
        .collect()
}

/// In the plane, only the component along z.
fn moment_outputs(motion: Motion, moment: &Components) -> Components {
    if motion.is_planar() {
        [moment[2]; 3]
    } else {
        *moment
    }
}

/// The accelerations that are not statements of their own.
fn last_lines(model: &Model, code: &Code) -> Vec<String> {
    let names = [
        "linear_x",
        "linear_y",
        "linear_z",
        "angular_x",
        "angular_y",
        "angular_z",
    ];
    let (moves, turns, axes) = (
        model.motion.has_position(),
        model.motion.has_attitude(),
        model.motion.axes(),
    );
    let wanted = |i: usize| {
        if i < 3 {
            moves && i < axes
        } else {
            turns && (axes == 3 || i == 5)
        }
    };
    let lines = code
        .outputs
        .iter()
        .enumerate()
        .filter(|(i, _)| wanted(*i))
        .map(|(i, value)| {
            let name = if i == 5 && axes == 2 {
                "angular"
            } else {
                names[i]
            };
            (name, value.to_string())
        });
    lines
        .filter(|(name, value)| name != value)
        .map(|(name, value)| format!("{name} = {value}"))
        .collect()
}

/// `[Load { name, family, force, point, moment }, ..]`
fn emit_loads(writer: &Writer<'_>, shapes: &Shapes, equations: &Equations) -> Function {
    let Some(balance) = &equations.balance else {
        return Function::default();
    };
    let outputs: Vec<Id> = balance
        .loads
        .iter()
        .flat_map(|load| load.force.into_iter().chain(load.point).chain(load.moment))
        .collect();
    let private = &shapes.private;
    let kind = shapes.load_type();
    Function::from_code(writer.function(&outputs, Stage::State), |values| {
        let loads = balance.loads.iter().zip(values.chunks(9)).map(|(load, values)| {
            let name = &load.name;
            let family = match load.family {
                Family::Reaction => quote!(Reaction),
                Family::Joint => quote!(Joint),
                Family::External => quote!(External),
                Family::Field => quote!(Field),
            };
            let (force, point, moment) = (shapes.vector(values), shapes.vector(&values[3..]), shapes.moment(&values[6..]));
            quote!(#kind { name: #name, family: #private::Family::#family, force: #force, point: #point, moment: #moment })
        });
        quote!([#(#loads),*])
    })
}

pub fn emit_implementations(outline: &Outline, bodies: &Bodies) -> TokenStream {
    let shapes = Shapes::of(outline);
    let mut tokens = emit_rigid_body(outline, &shapes, &bodies.acceleration);
    for output in &outline.outputs {
        tokens.extend(match output {
            Output::Energy => emit_energy(outline, &shapes, bodies),
            Output::Momentum => emit_momentum(outline, &shapes, bodies),
            Output::Balance => emit_balance(outline, &shapes, bodies),
        });
    }
    tokens
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

/// `time: f64, state: &State, input: &Input`, as far as they are read.
fn arguments(outline: &Outline, shapes: &Shapes, function: &Function) -> TokenStream {
    let (state, input) = (shapes.state(), input_type(outline));
    let [time, given, controls] = [
        (Source::Time, "time"),
        (Source::State, "state"),
        (Source::Input, "input"),
    ]
    .map(|(source, name)| function.argument(source, name));
    quote!(#time: f64, #given: &#state, #controls: &#input)
}

fn emit_rigid_body(outline: &Outline, shapes: &Shapes, function: &Function) -> TokenStream {
    let (name, private) = (&outline.name, &shapes.private);
    let (state, input, acceleration) = (
        shapes.state(),
        input_type(outline),
        shapes.acceleration_type(),
    );
    let (arguments, body) = (arguments(outline, shapes, function), &function.body);
    quote! {
        impl #private::RigidBody for #name {
            type Scalar = f64;
            type State = #state;
            type Input = #input;
            #[inline]
            #[allow(unused_doc_comments)]
            fn acceleration(&self, #arguments) -> #acceleration { #body }
        }
    }
}

fn emit_energy(outline: &Outline, shapes: &Shapes, bodies: &Bodies) -> TokenStream {
    let (name, private, state) = (&outline.name, &shapes.private, shapes.state());
    let (kinetic, potential) = (&bodies.kinetic_energy, &bodies.potential_energy);
    let given = kinetic.argument(Source::State, "state");
    let arguments = arguments(outline, shapes, potential);
    let (kinetic, potential) = (&kinetic.body, &potential.body);
    quote! {
        impl #private::Energy for #name {
            fn kinetic_energy(&self, #given: &#state) -> f64 { #kinetic }
            fn potential_energy(&self, #arguments) -> f64 { #potential }
        }
    }
}

fn emit_momentum(outline: &Outline, shapes: &Shapes, bodies: &Bodies) -> TokenStream {
    let (name, private, state) = (&outline.name, &shapes.private, shapes.state());
    let angular = shapes.moment_type();
    let linear = if outline.motion == Motion::Rotation {
        quote!(())
    } else {
        shapes.vector_type()
    };
    let argument = |function: &Function| function.argument(Source::State, "state");
    let [first, second, third] = [
        &bodies.linear_momentum,
        &bodies.angular_momentum,
        &bodies.angular_momentum_about_pole,
    ]
    .map(argument);
    let time = bodies
        .angular_momentum_about_pole
        .argument(Source::Time, "time");
    let [translation, rotation, about_pole] = [
        &bodies.linear_momentum,
        &bodies.angular_momentum,
        &bodies.angular_momentum_about_pole,
    ]
    .map(|function| &function.body);
    quote! {
        impl #private::Momentum for #name {
            type Linear = #linear;
            type Angular = #angular;
            fn linear_momentum(&self, #first: &#state) -> #linear { #translation }
            #[allow(unused_doc_comments)]
            fn angular_momentum(&self, #second: &#state) -> #angular { #rotation }
            #[allow(unused_doc_comments)]
            fn angular_momentum_about_pole(&self, #time: f64, #third: &#state) -> #angular { #about_pole }
        }
    }
}

fn emit_balance(outline: &Outline, shapes: &Shapes, bodies: &Bodies) -> TokenStream {
    let (name, private) = (&outline.name, &shapes.private);
    let (wrench, load, input, acceleration) = (
        shapes.wrench_type(),
        shapes.load_type(),
        input_type(outline),
        shapes.acceleration_type(),
    );
    let count = Literal::usize_unsuffixed(bodies.load_count);
    let of_applied = arguments(outline, shapes, &bodies.applied);
    let of_loads = arguments(outline, shapes, &bodies.loads);
    let residual = &bodies.residual;
    let state = shapes.state();
    let [time, given, rate, controls] = [
        (Source::Time, "time"),
        (Source::State, "state"),
        (Source::Acceleration, "acceleration"),
        (Source::Input, "input"),
    ]
    .map(|(source, name)| residual.argument(source, name));
    let (applied, residual, loads) = (&bodies.applied.body, &residual.body, &bodies.loads.body);
    quote! {
        impl #private::Balance for #name {
            type Wrench = #wrench;
            type Reactions = ();
            type Loads = [#load; #count];
            #[allow(unused_doc_comments)]
            fn applied(&self, #of_applied) -> #wrench { #applied }
            #[allow(unused_doc_comments)]
            fn residual(&self, #time: f64, #given: &#state, #rate: &#acceleration, _reactions: &(), #controls: &#input) -> #wrench { #residual }
            #[allow(unused_doc_comments)]
            fn loads(&self, #of_loads) -> [#load; #count] { #loads }
        }
    }
}
