//! The bodies of all functions that are generated for a body.

use proc_macro2::{Ident, Span, TokenStream};
use quote::{format_ident, quote};

use crate::families::Family;
use crate::families::LoadKind;
use crate::mechanics::{
    Balance, Equations, Momentum, Partial, ReactionExpressions, Resultant, Switch,
};
use crate::model::Model;
use crate::model::Outline;
use crate::model::Output;
use crate::model::Workspace;
use crate::symbolic::{Components, Cost, Id, Node, Stage};

use super::code::{Fields, Source, Writer};
use super::consistency::{write_check, write_project, write_violations};
use super::flow;
use super::lints::allow_constants;
use super::naming::local;
use super::paths::private;
use super::scalar::{Scalar, number_literal};
use super::shapes::{Shapes, Values};
use super::taylor::{Expansion, write_axes};

/// The generated functions; those that are not asked for are empty.
#[derive(Default)]
pub struct Functions {
    pub acceleration: Function,
    pub kinetic_energy: Function,
    pub potential_energy: Function,
    pub linear_momentum: Function,
    pub angular_momentum: Function,
    pub angular_momentum_about_pole: Function,
    pub applied: Function,
    pub residual: Function,
    pub loads: Function,
    pub reactions: Function,
    pub inverse: Function,
    pub path: Function,
    /// The type of the path.
    pub path_type: TokenStream,
    /// If there are times at which the equations change.
    pub switches: Option<Function>,
    /// If there are loads that may have no value.
    pub lost_load: Option<Function>,
    pub violations: Function,
    pub check: Function,
    pub project: Function,
    pub expand: Function,
    /// If they are not those of the body.
    pub axes: Option<Function>,
    /// Number of products of series.
    pub product_count: usize,
    /// Number of scalar constraints.
    pub constraint_count: usize,
}

/// The body of one function.
#[derive(Default)]
pub struct Function {
    pub body: TokenStream,
    pub cost: Cost,
    /// The statements as text, and then what is returned.
    pub text: Vec<String>,
    pub output_text: Vec<String>,
    pub reads: Vec<Source>,
    /// Whether there are states in which it would divide by nothing but rounding.
    pub has_pivots: bool,
    pub has_notes: bool,
    pub has_equality: bool,
}

impl Function {
    /// Computes `outputs` and returns what `fill` makes of their values.
    pub fn write(
        writer: &Writer<'_>,
        outputs: &[Id],
        fill: impl FnOnce(&mut Values<'_>) -> TokenStream,
    ) -> Self {
        let code = writer.function(outputs);
        let (statements, value) = (&code.statements, fill(&mut code.outputs.iter()));
        Self {
            body: quote!(#statements #value),
            cost: code.cost,
            text: code.text,
            output_text: code.output_text,
            reads: code.reads,
            has_pivots: code.has_pivots,
            has_notes: code.has_notes,
            has_equality: code.has_equality,
        }
    }

    /// An argument, with a leading underscore if it is not read.
    pub fn argument(&self, source: Source, name: &str) -> Ident {
        let underscore = if self.reads.contains(&source) {
            ""
        } else {
            "_"
        };
        Ident::new(&format!("{underscore}{name}"), Span::mixed_site())
    }

    /// Statements carry notes, which the compiler has no use for, and descriptions may compare for
    /// equality and have numbers that have names elsewhere.
    pub fn lints(&self) -> TokenStream {
        let notes = self
            .has_notes
            .then(|| quote!(#[allow(unused_doc_comments)]));
        let equality = self
            .has_equality
            .then(|| quote!(#[allow(clippy::float_cmp)]));
        let constants = allow_constants(&self.body);
        quote!(#notes #equality #constants)
    }
}

impl Functions {
    pub fn write(
        outline: &Outline,
        (model, work): (&Model, &Workspace),
        equations: &Equations,
        fields: &Fields,
    ) -> Self {
        let shapes = Shapes::of(outline);
        let none = Fields::default();
        let writer = Writer {
            model,
            work,
            outline,
            fields,
            targets: &none,
            stage: Stage::State,
            is_fallible: false,
            is_whole: false,
            has_state: true,
            scalar: Scalar::of(outline),
            private: private(outline),
        };
        let mut functions = Self {
            acceleration: write_acceleration(&writer, &shapes, equations),
            ..Self::default()
        };
        let (partial, switches) = (&equations.partial, &equations.switches);
        functions.lost_load = (!partial.is_empty()).then(|| write_lost_load(&writer, partial));
        functions.switches = (!switches.is_empty()).then(|| write_switches(&writer, switches));
        if let Some(energy) = &equations.energy {
            let scalar = |id: Id| Function::write(&writer, &[id], |values| quote!(#(#values)*));
            functions.kinetic_energy = scalar(energy.kinetic);
            functions.potential_energy = scalar(energy.potential);
        }
        if let Some(momentum) = &equations.momentum {
            functions.write_momentum(&writer, &shapes, momentum);
        }
        if let Some(balance) = &equations.balance {
            let wrench = |resultant: &Resultant| {
                let outputs = shapes.wrench_part(&resultant.force, &resultant.moment);
                Function::write(&writer, &outputs, |values| shapes.wrench(values))
            };
            functions.applied = wrench(&balance.applied);
            functions.residual = wrench(&balance.residual);
            functions.loads = write_loads(&writer, &shapes, balance);
        }
        let double = Writer {
            scalar: Scalar::double(outline),
            private: private(outline),
            ..writer
        };
        let double_shapes = Shapes::double(outline);
        if let Some(taylor) = &equations.taylor {
            let expansion = Expansion::write(&double, taylor);
            functions.product_count = expansion.width;
            functions.expand = expansion.function;
            functions.axes = taylor.axes.as_ref().map(|axes| write_axes(&double, axes));
        }
        if outline.is_constrained {
            functions.violations = write_violations(&double, &double_shapes, equations);
            functions.check = write_check(&double, &double_shapes, equations);
            functions.project = write_project(&double, &double_shapes, equations);
            functions.constraint_count = equations.constraints.len();
        }
        if outline.outputs.contains(&Output::Reactions) {
            let (open, solved) = (&outline.reactions, &equations.reactions);
            functions.reactions = if outline.is_constrained {
                let fallible = Writer {
                    is_fallible: true,
                    scalar: Scalar::of(outline),
                    private: private(outline),
                    ..writer
                };
                write_open(&fallible, &shapes, "Reactions", open, solved)
            } else {
                write_open(&writer, &shapes, "Reactions", open, solved)
            };
        }
        if outline.outputs.contains(&Output::Inverse) {
            functions.inverse = write_inverse(&writer, &shapes, &equations.drives);
        }
        if let Some(flow) = &equations.flow {
            functions.path = flow::write_path(&double, &double_shapes, flow);
            functions.path_type = flow::path_type(&double_shapes, &flow.turning);
        }
        functions
    }

    fn write_momentum(&mut self, writer: &Writer<'_>, shapes: &Shapes, momentum: &Momentum) {
        let moment = |components: &Components| {
            Function::write(writer, shapes.moment_part(components), |values| {
                shapes.moment(values)
            })
        };
        self.angular_momentum = moment(&momentum.angular);
        self.angular_momentum_about_pole = moment(&momentum.about_pole);
        if writer.model.motion.knows_position {
            let linear = shapes.vector_part(&momentum.linear);
            self.linear_momentum = Function::write(writer, linear, |values| shapes.vector(values));
        }
    }

    /// Functions that are never run.
    pub fn stub(outline: &Outline) -> Self {
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
            reactions: never(),
            inverse: Function {
                has_pivots: outline.has_turning_drive,
                ..never()
            },
            path: never(),
            path_type: flow::any_path(outline),
            switches: None,
            lost_load: None,
            violations: never(),
            check: never(),
            project: never(),
            expand: never(),
            axes: None,
            product_count: 0,
            constraint_count: 0,
        }
    }

    /// The functions that are there, by name.
    pub fn by_name(&self, outline: &Outline) -> Vec<(&'static str, &Function)> {
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
                Output::Reactions => functions.push(("reactions", &self.reactions)),
                Output::Inverse => functions.push(("inverse", &self.inverse)),
                // their operations are those of the runtime, as many as the order asks for
                Output::Flow | Output::Taylor => {}
                Output::Balance => functions.extend([
                    ("applied", &self.applied),
                    ("residual", &self.residual),
                    ("loads", &self.loads),
                ]),
            }
        }
        if outline.is_constrained {
            functions.extend([
                ("violations", &self.violations),
                ("check", &self.check),
                ("project", &self.project),
            ]);
        }
        functions
    }
}

fn write_acceleration(writer: &Writer<'_>, shapes: &Shapes, equations: &Equations) -> Function {
    let outputs = shapes.pair_part(&equations.linear, &equations.angular);
    let mut function = Function::write(writer, &outputs, |values| shapes.acceleration(values));
    // what is known early is no statement, and stands in the text all the same
    let results = shapes.pair_names().into_iter().zip(&function.output_text);
    let stated = results.filter(|(name, value)| name != *value);
    let text: Vec<String> = stated
        .map(|(name, value)| format!("{name} = {value}"))
        .collect();
    function.text.extend(text);
    function
}

/// `lost_load(&[("drag", &[drag_x, drag_y]), ..])`
fn write_lost_load(writer: &Writer<'_>, partial: &[Partial]) -> Function {
    let outputs: Vec<Id> = partial.iter().flat_map(|load| load.parts.clone()).collect();
    let outline = writer.outline;
    let writer = Writer {
        is_whole: true,
        scalar: Scalar::of(outline),
        private: private(outline),
        ..*writer
    };
    let private = &writer.private;
    Function::write(&writer, &outputs, |values| {
        let loads = partial.iter().map(|load| {
            let (name, parts) = (&load.name, values.take(load.parts.len()));
            quote!((#name, &[#(#parts),*]))
        });
        let loads: Vec<TokenStream> = loads.collect();
        quote!(#private::lost_load(&[#(#loads),*]))
    })
}

/// `times.at(50.0); times.every(self.start, self.period);`
fn write_switches(writer: &Writer<'_>, switches: &[Switch]) -> Function {
    // numbers need no scalar to be made of
    let graph = &writer.work.graph;
    let number = |id: &Id| {
        graph
            .as_number(*id)
            .map(|number| number_literal(number.to_f64()))
    };
    let outputs: Vec<Id> = switches.iter().flat_map(Switch::roots).collect();
    let open: Vec<Id> = outputs
        .iter()
        .copied()
        .filter(|id| number(id).is_none())
        .collect();
    let (times, outline) = (local("times"), writer.outline);
    let writer = Writer {
        has_state: false,
        scalar: Scalar::of(outline),
        private: private(outline),
        ..*writer
    };
    Function::write(&writer, &open, |values| {
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

/// `BodyReactions { pin: .., guide: .. }`
fn write_open(
    writer: &Writer<'_>,
    shapes: &Shapes,
    suffix: &str,
    open: &[(Ident, LoadKind)],
    solved: &[ReactionExpressions],
) -> Function {
    let reactions = || open.iter().zip(solved);
    let part = |(kind, vector): (LoadKind, &'_ Components)| match kind {
        LoadKind::Force => shapes.vector_part(vector).to_vec(),
        LoadKind::Moment => shapes.moment_part(vector).to_vec(),
    };
    let outputs: Vec<Id> = reactions()
        .flat_map(|((_, kind), reaction)| part((*kind, &reaction.vector)))
        .collect();
    let name = format_ident!("{}{suffix}", writer.outline.name);
    Function::write(writer, &outputs, |values| {
        let fields = reactions().map(|((field, kind), _)| {
            let value = match kind {
                LoadKind::Force => shapes.vector(values),
                LoadKind::Moment => shapes.moment(values),
            };
            quote!(#field: #value)
        });
        let reactions = quote!(#name { #(#fields),* });
        if writer.is_fallible {
            quote!(::core::result::Result::Ok(#reactions))
        } else {
            reactions
        }
    })
}

/// A `Result` where the configuration may leave drives undetermined.
fn write_inverse(writer: &Writer<'_>, shapes: &Shapes, solved: &[ReactionExpressions]) -> Function {
    let Writer { outline, work, .. } = *writer;
    let roots: Vec<Id> = solved.iter().flat_map(|drive| drive.vector).collect();
    let graph = &work.graph;
    let is_pivot = |id: &Id| matches!(graph.node(*id), Node::Pivot(..));
    let guarded = Writer {
        is_fallible: graph.reachable(&roots, |_| true).iter().any(is_pivot),
        scalar: Scalar::of(outline),
        private: private(outline),
        ..*writer
    };
    write_open(&guarded, shapes, "Drives", &outline.drives, solved)
}

/// `[Load { name, family, force, point, moment }, ..]`
fn write_loads(writer: &Writer<'_>, shapes: &Shapes, balance: &Balance) -> Function {
    let parts = |load: &crate::mechanics::LoadExpressions| {
        let (force, point, moment) = (
            shapes.vector_part(&load.force),
            shapes.vector_part(&load.point),
            shapes.moment_part(&load.moment),
        );
        [force, point, moment].concat()
    };
    let outputs: Vec<Id> = balance.loads.iter().flat_map(parts).collect();
    let (private, kind) = (&shapes.private, shapes.load_type());
    Function::write(writer, &outputs, |values| {
        let loads = balance.loads.iter().map(|load| {
            let name = &load.name;
            let family = match load.family {
                Family::Reaction => quote!(Reaction),
                Family::Joint => quote!(Joint),
                Family::External => quote!(External),
                Family::Field => quote!(Field),
            };
            let (force, point, moment) = (shapes.vector(values), shapes.vector(values), shapes.moment(values));
            quote!(#kind { name: #name, family: #private::Family::#family, force: #force, point: #point, moment: #moment })
        });
        quote!([#(#loads),*])
    })
}
