//! Definitions: parameters, inputs, points, locals and the mass, each after those it refers to.

use std::collections::HashMap;

use crate::symbolic::Id;
use crate::syntax::{Description, Expression};

use super::dimension::Dimension;
use super::frame::{Frames, Vector};
use super::lower::Lowering;
use super::motion::Meanings;
use super::order::{Definition, definition_order, split_at_support};
use super::outline::{self, Outline};
use super::parameters::Defaults;
use super::value::{Value, shown};

/// The mass of a body.
#[derive(Clone, Copy, Debug)]
pub enum Mass {
    /// None was given.
    Absent,
    /// It was given, and what is wrong with it is reported.
    Reported,
    Known(Id),
}

impl Mass {
    pub fn known(self) -> Option<Id> {
        match self {
            Self::Known(mass) => Some(mass),
            Self::Absent | Self::Reported => None,
        }
    }
}

impl Lowering<'_> {
    pub fn declarations(
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

    /// Points, locals and the mass, each after those it refers to.
    pub fn definitions(&mut self, description: &Description, defaults: &Defaults) -> Mass {
        let (order, circular) = definition_order(description, self.errors);
        let mut mass = match description.mass {
            Some(_) => Mass::Reported,
            // that it is missing is reported
            None if self.motion.knows_position() => Mass::Reported,
            None => Mass::Absent,
        };
        self.check_mass_key(description, outline::written_motion(description).is_some());
        let (first, rest) = split_at_support(description, &order);
        for definition in first {
            self.definition(definition, description, defaults, &mut mass);
        }
        if self.motion.is_supported() {
            self.support(description);
        }
        for definition in rest {
            self.definition(definition, description, defaults, &mut mass);
        }
        for definition in circular {
            self.scope.define(&definition.of(description).0, None);
        }
        mass
    }

    fn definition(
        &mut self,
        definition: Definition,
        description: &Description,
        defaults: &Defaults,
        mass: &mut Mass,
    ) {
        let (name, value) = definition.of(description);
        let value = match definition {
            Definition::Mass => {
                let id = self.mass(value, defaults);
                *mass = id.map_or(Mass::Reported, Mass::Known);
                id.map(|id| Value::Scalar(id, Dimension::MASS))
            }
            Definition::Point(_) => value.and_then(|value| self.point(value)).map(Value::Point),
            Definition::Local(_) => {
                let value = value.and_then(|value| self.value(value));
                value.map(|value| self.named(value, &name))
            }
        };
        self.scope.define(&name, value);
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

    fn mass(&mut self, written: Option<&Expression>, defaults: &Defaults) -> Option<Id> {
        let value = written?;
        let mass = self.scalar(value, Dimension::MASS, "a mass")?;
        if !self.frames.graph.is_early(mass) {
            let place = self.late_name(value);
            return self.report(
                place,
                "the mass is constant: it cannot depend on the time, the state or an input",
            );
        }
        let graph = &mut self.frames.graph;
        let known = graph.substitute(&[mass], |id| defaults.get(&id).copied())[0];
        match graph.as_number(known) {
            Some(number) if !number.is_positive() => {
                let number = shown(number);
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

    /// A body that moves has a mass.
    fn check_mass_key(&mut self, description: &Description, motion_is_known: bool) {
        if description.mass.is_some() || !self.motion.knows_position() {
            return;
        }
        self.scope.define("mass", None);
        if motion_is_known {
            let name = &description.name;
            self.errors.push(
                name.span(),
                format!("`{name}` has no mass: write `mass: 1[kg]`"),
            );
        }
    }
}
