//! What was meant: names resolved, frames and dimensions checked, loads and inertia in the graph.
//!
//! The [`Outline`] of a body always exists; its [`Model`] exists if nothing was wrong.

mod dimension;
mod frame;
mod functions;
mod inertia;
mod lower;
mod motion;
mod names;
mod outline;
mod parameters;
mod scope;
mod unit;
mod value;

use std::collections::HashMap;

use proc_macro2::Ident;

use crate::errors::{Errors, Extent};
use crate::symbolic::{Graph, Id};
use crate::syntax::{self, Description, Written};

pub use dimension::Dimension;
pub use frame::{Frame, Frames, Vector};
pub use inertia::Inertia;
pub use motion::{Meanings, Motion, State};
pub use names::{AXES, Labels, Meaning};
pub use outline::{Declared, Outline, Output, outline};
pub use syntax::{Family, LoadKind};
pub use value::Point;

use inertia::entries;
use lower::Lowering;
use parameters::Defaults;
use scope::{Definition, Scope, check_names, definition_order};
use value::Value;

/// A description, understood.
pub struct Model {
    pub motion: Motion,
    pub frames: Frames,
    pub meanings: Meanings,
    pub state: State,
    pub mass: Option<Id>,
    pub inertia: Inertia,
    pub loads: Vec<Load>,
    pub pole: Point,
    pub outputs: Vec<Output>,
    /// The values of the parameters that have a default.
    defaults: Defaults,
}

/// A given load: a force at a point, or a moment.
pub struct Load {
    pub name: Ident,
    pub family: Family,
    pub kind: LoadKind,
    pub vector: Vector,
    pub point: Point,
    /// What to underline if the load is at fault.
    pub extent: Extent,
}

impl Model {
    /// The entries xx, yy, zz, xy, yz, zx of the inertia, or the one of a planar body.
    pub fn inertia_entries(&self) -> Vec<Id> {
        match self.inertia {
            Inertia::Absent => Vec::new(),
            Inertia::Planar(moment) => vec![moment],
            Inertia::Spatial(rows) => entries(&self.frames.graph, &rows).to_vec(),
        }
    }
}

/// Gives a description its meaning. `None` if anything was wrong with it.
pub fn lower_description(
    description: &Description,
    outline: &mut Outline,
    errors: &mut Errors,
) -> Option<Model> {
    check_names(description, errors);
    let mut graph = Graph::default();
    let mut meanings = Meanings::default();
    let (state, attitude) = motion::state_symbols(outline.motion, &mut graph, &mut meanings);
    let mut frames = Frames {
        graph,
        labels: Labels::default(),
        attitude,
    };
    let mut scope = Scope::default();
    let mut lowering = Lowering {
        frames: &mut frames,
        scope: &mut scope,
        errors,
        motion: outline.motion,
        state: &state,
    };

    let defaults = lowering.declarations(description, outline, &mut meanings);
    let mass = lowering.definitions(description, &defaults);
    let known_mass = mass.flatten();
    let inertia = lowering.check_inertia_key(description, known_mass, &defaults);
    lowering.check_mass_key(description);
    let loads: Vec<Option<Load>> = description
        .loads
        .iter()
        .map(|load| lowering.load(load))
        .collect();
    let pole = lowering.pole(description.pole.as_ref());

    let declared = description
        .params
        .iter()
        .chain(&description.inputs)
        .map(|declaration| &declaration.name);
    let defined = description
        .points
        .iter()
        .chain(&description.locals)
        .map(|definition| &definition.name);
    outline.unused = declared
        .chain(defined)
        .filter(|name| !scope.is_used(name))
        .cloned()
        .collect();

    let (inertia, loads, pole) = (
        inertia?,
        loads.into_iter().collect::<Option<Vec<_>>>()?,
        pole?,
    );
    let (motion, outputs) = (outline.motion, outline.outputs.clone());
    Some(Model {
        motion,
        frames,
        meanings,
        state,
        mass: known_mass,
        inertia,
        loads,
        pole,
        outputs,
        defaults,
    })
}

/// Reports constants of the equations that no double can hold, with the defaults where parameters
/// have them.
pub fn check_range(model: &mut Model, outline: &Outline, roots: &[Id], errors: &mut Errors) {
    let graph = &mut model.frames.graph;
    let early: Vec<Id> = graph
        .reachable(roots, |id| !graph.is_early(id))
        .into_iter()
        .filter(|id| graph.is_early(*id))
        .collect();
    let values = graph.substitute(&early, |id| model.defaults.get(&id).copied());
    let out_of_range = |id: &Id| {
        graph.is_undefined(*id)
            || graph
                .as_number(*id)
                .is_some_and(|number| !number.fits_f64())
    };
    if values.iter().any(out_of_range) {
        let with = if outline.params.is_empty() {
            ""
        } else {
            " with the defaults of its parameters"
        };
        errors.push(outline.name.span(), format!("a constant in the equations of `{}` is out of the range of `f64`{with}: choose units nearer to one", outline.name));
    }
}

impl Lowering<'_> {
    fn declarations(
        &mut self,
        description: &Description,
        outline: &mut Outline,
        meanings: &mut Meanings,
    ) -> Defaults {
        let mut defaults = HashMap::new();
        for (index, param) in outline::distinct(&description.params).enumerate() {
            let value = self.param(
                index,
                param,
                &mut outline.params[index],
                meanings,
                &mut defaults,
            );
            self.scope.define(&param.name.to_string(), value);
        }
        for (index, input) in outline::distinct(&description.inputs).enumerate() {
            let value = self.input(index, input, &mut outline.inputs[index], meanings);
            self.scope.define(&input.name.to_string(), value);
        }
        defaults
    }

    /// Points, locals and the mass, each after those it refers to. The mass is `None` where there
    /// is none and `Some(None)` where it was reported.
    #[allow(clippy::option_option, reason = "outer: not given; inner: reported")]
    fn definitions(
        &mut self,
        description: &Description,
        defaults: &Defaults,
    ) -> Option<Option<Id>> {
        let (order, circular) = definition_order(description, self.errors);
        let mut mass = description.mass.as_ref().map(|_| None);
        for definition in order {
            match definition {
                Definition::Mass => {
                    let id = self.mass(description.mass.as_ref(), defaults);
                    mass = Some(id);
                    self.scope
                        .define("mass", id.map(|id| Value::Scalar(id, Dimension::MASS)));
                }
                Definition::Point(index) => {
                    let point = &description.points[index];
                    let value = point.value.as_ref().and_then(|value| self.point(value));
                    self.scope
                        .define(&point.name.to_string(), value.map(Value::Point));
                }
                Definition::Local(index) => {
                    let local = &description.locals[index];
                    let value = local.value.as_ref().and_then(|value| self.value(value));
                    let value = value.map(|value| self.named(value, &local.name.to_string()));
                    self.scope.define(&local.name.to_string(), value);
                }
            }
        }
        for definition in circular {
            let name = match definition {
                Definition::Mass => "mass".to_owned(),
                Definition::Point(index) => description.points[index].name.to_string(),
                Definition::Local(index) => description.locals[index].name.to_string(),
            };
            self.scope.define(&name, None);
        }
        mass
    }

    /// A local becomes a statement of the code, under its own name.
    fn named(&mut self, value: Value, name: &str) -> Value {
        let Frames { graph, labels, .. } = &mut *self.frames;
        match value {
            Value::Scalar(id, dimension) => {
                let id = graph.quantity(id);
                labels.name(graph.split_sign(id).1, name);
                Value::Scalar(id, dimension)
            }
            Value::Vector(vector, dimension) => {
                let vector = Vector {
                    body: graph.quantities(vector.body),
                    world: graph.quantities(vector.world),
                };
                labels.vector(
                    &if graph.is_zero_vector(&vector.world) {
                        name.to_owned()
                    } else {
                        format!("{name}_body")
                    },
                    vector.body,
                );
                labels.vector(name, vector.world);
                Value::Vector(vector, dimension)
            }
            Value::Components(frame, components, dimension) => {
                let components = graph.quantities(components);
                labels.vector(name, components);
                Value::Components(frame, components, dimension)
            }
            other => other,
        }
    }

    fn mass(&mut self, written: Option<&Written>, defaults: &Defaults) -> Option<Id> {
        let value = written?.value.as_ref()?;
        let mass = self.scalar(value, Dimension::MASS, "a mass")?;
        if !self.frames.graph.is_early(mass) {
            return self.report(
                value.extent,
                "the mass is constant: it cannot depend on the time, the state or an input",
            );
        }
        let graph = &mut self.frames.graph;
        let known = graph.substitute(&[mass], |id| defaults.get(&id).copied())[0];
        match graph.as_number(known) {
            Some(number) if !number.is_positive() => {
                let number = number.to_f64();
                self.report(
                    value.extent,
                    format!("the mass of a body that moves is positive, and this is {number}"),
                )
            }
            Some(number) if !number.fits_f64() => {
                self.report(value.extent, "this mass is out of the range of `f64`")
            }
            _ => Some(mass),
        }
    }

    fn check_mass_key(&mut self, description: &Description) {
        if description.mass.is_none()
            && self.motion.has_position()
            && !self.misspelt(description, "mass")
        {
            self.errors.push(
                description.name.span(),
                format!("`{}` has no mass: write `mass: 1[kg]`", description.name),
            );
        }
    }

    /// A key was written and refused, or is there under a wrong name: what is missing is said there.
    fn misspelt(&self, description: &Description, key: &str) -> bool {
        let known = |word: &str| crate::errors::similar(word, [key]).is_some();
        description
            .keys
            .iter()
            .any(|written| written != key && known(&written.to_string()))
            || description.refused.iter().any(|written| written == key)
    }

    fn check_inertia_key(
        &mut self,
        description: &Description,
        mass: Option<Id>,
        defaults: &Defaults,
    ) -> Option<Inertia> {
        let name = &description.name;
        match &description.inertia {
            _ if !self.motion.has_attitude() => {
                // what is written is still read, so that its mistakes are found
                if let Some(value) = description
                    .inertia
                    .as_ref()
                    .and_then(|written| written.value.as_ref())
                {
                    self.inertia(value, mass, |id| defaults.get(&id).copied())?;
                }
                Some(Inertia::Absent)
            }
            Some(written) => {
                let value = written.value.as_ref()?;
                let inertia = self.inertia(value, mass, |id| defaults.get(&id).copied())?;
                let ids = match inertia {
                    Inertia::Absent => Vec::new(),
                    Inertia::Planar(moment) => vec![moment],
                    Inertia::Spatial(rows) => rows.into_iter().flatten().collect(),
                };
                if ids.iter().any(|id| !self.frames.graph.is_early(*id)) {
                    return self.report(value.extent, "the inertia is constant in body axes: it cannot depend on the time, the state or an input");
                }
                Some(inertia)
            }
            None if self.misspelt(description, "inertia") => None,
            None => {
                let form = if self.motion.is_planar() {
                    "0.1[kg * m ^ 2]"
                } else {
                    "principal(1, 2, 3)[kg * m ^ 2]"
                };
                self.report(
                    name.span(),
                    format!("`{name}` turns and has no inertia: write `inertia: {form}`"),
                )
            }
        }
    }

    fn load(&mut self, written: &syntax::Load) -> Option<Load> {
        let value = written.vector.as_ref();
        let vector = value.and_then(|value| match written.kind {
            LoadKind::Force => self.vector(value, Dimension::FORCE, "a force"),
            LoadKind::Moment if self.motion.is_planar() => {
                let moment = self.scalar(value, Dimension::MOMENT, "a moment")?;
                let zero = self.frames.graph.zero();
                Some(self.frames.vector(Frame::Body, [zero, zero, moment]))
            }
            LoadKind::Moment => self.vector(value, Dimension::MOMENT, "a moment"),
        });
        let point = match &written.point {
            Some(point) => self.point(point).and_then(|found| match found {
                Point::World(_) if !self.motion.has_position() => {
                    self.report(point.extent, "a point in space is nowhere relative to a body under `motion: rotation`: the motion of G is not modelled")
                }
                found => Some(found),
            }),
            None => Some(Point::Body(self.frames.graph.zeros())),
        };
        Some(Load {
            name: written.name.clone(),
            family: written.family,
            kind: written.kind,
            vector: vector?,
            point: point?,
            extent: written.name.span().into(),
        })
    }

    fn pole(&mut self, written: Option<&Written>) -> Option<Point> {
        let Some(written) = written else {
            return Some(Point::Body(self.frames.graph.zeros()));
        };
        let value = written.value.as_ref()?;
        let point = self.point(value)?;
        let is_center = point == Point::Body(self.frames.graph.zeros());
        if !self.motion.has_position() && !is_center {
            return self.report(value.extent, "under `motion: rotation` the moment balance is written about G: the motion of G is not modelled");
        }
        Some(point)
    }
}
