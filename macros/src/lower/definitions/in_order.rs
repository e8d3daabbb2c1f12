//! Definitions: parameters, inputs, points, locals and the mass, in order of dependency.

use std::collections::HashMap;

use proc_macro2::Ident;

use crate::lower::expressions::{Lowering, Value};
use crate::model::{Defaults, Dimension, Frame, Mass, Outline, Point, Workspace, shown};
use crate::symbolic::{Graph, Id};
use crate::syntax::{Composition, Description, Expression, Kind};

use super::order::{Definition, check_circles, definition_order, split_at_axis, split_at_support};
use super::outline;

impl Lowering<'_> {
    pub fn declarations(&mut self, description: &Description, outline: &mut Outline) -> Defaults {
        let mut defaults = HashMap::new();
        self.foreign_definitions(description);
        for (index, param) in outline::distinct(&description.params).enumerate() {
            let value = self.param(index, param, &mut outline.params[index], &mut defaults);
            self.scope.define(&param.name.to_string(), value);
        }
        let mut is_lost = false;
        for (index, input) in outline::distinct(&description.inputs).enumerate() {
            // the rates of an input are declared with it: an error in the declaration is reported
            // once
            let value = if input.order > 0 && is_lost {
                None
            } else {
                self.input(index, input, &mut outline.inputs[index])
            };
            is_lost = value.is_none();
            self.scope.define(&input.name.to_string(), value);
        }
        for (index, state) in outline::distinct(&description.states).enumerate() {
            let value = self.state(index, state, &mut outline.states[index]);
            self.scope.define(&state.name.to_string(), value);
        }
        defaults
    }

    /// Points, locals and the mass, in order of dependency.
    pub fn definitions(&mut self, description: &Description, defaults: &Defaults) -> Mass {
        check_circles(description, |name| self.scope.is_lost(name), self.errors);
        let (order, circular) = definition_order(description);
        let mut mass = match description.mass {
            Some(_) => Mass::Reported,
            // a missing mass is reported elsewhere
            None if self.motion.knows_position() => Mass::Reported,
            None => Mass::Absent,
        };
        self.check_mass_key(
            description,
            crate::lower::expressions::written_motion(description).is_some()
                && !description.is_system(),
        );
        let order = if self.motion.is_line() {
            self.definitions_at_axis(description, defaults, &order, &mut mass)
        } else {
            order
        };
        let (first, rest) = split_at_support(description, &order);
        for definition in &first {
            self.definition(*definition, description, defaults, &mut mass);
        }
        if self.composed.is_some() {
            let is_point_or_local = |definition: &&Definition| **definition != Definition::Mass;
            for definition in first.iter().take_while(is_point_or_local) {
                self.read_again(*definition, description);
            }
        }
        if self.motion.is_supported() {
            self.support(description, defaults);
        }
        for definition in rest {
            self.definition(definition, description, defaults, &mut mass);
        }
        for definition in circular {
            self.scope.define(&definition.of(description).0, None);
            if definition == Definition::Mass {
                self.scope.define("G", None);
            }
        }
        mass
    }

    /// Reads the direction of a rod and the definitions that it needs. Returns the other
    /// definitions.
    fn definitions_at_axis(
        &mut self,
        description: &Description,
        defaults: &Defaults,
        order: &[Definition],
        mass: &mut Mass,
    ) -> Vec<Definition> {
        let (first, rest) = split_at_axis(description, order);
        for definition in &first {
            self.definition(*definition, description, defaults, mass);
        }
        self.axis(description, defaults);
        for definition in first {
            if definition != Definition::Mass {
                self.read_again(definition, description);
            }
        }
        rest
    }

    pub fn definition(
        &mut self,
        definition: Definition,
        description: &Description,
        defaults: &Defaults,
        mass: &mut Mass,
    ) {
        let (name, value) = definition.of(description);
        let value = if definition == Definition::Mass {
            let id = match &description.composition {
                None => self.mass(value, defaults),
                Some(parts) => self.mass_of_parts(parts, defaults),
            };
            let id = id.map(|id| self.work.weighed(id));
            *mass = id.map_or(Mass::Reported, Mass::Known);
            id.map(|id| Value::Scalar(id, Dimension::MASS))
        } else {
            self.read(definition, description)
        };
        self.scope.define(&name, value);
    }

    /// Reads definitions before the motion of the body is known. Returns those that depend on the
    /// motion; they have no value yet.
    pub fn fixed_definitions(
        &mut self,
        definitions: &[Definition],
        description: &Description,
        defaults: &Defaults,
        mass: &mut Mass,
    ) -> Vec<Definition> {
        let mut late: Vec<Definition> = Vec::new();
        for definition in definitions {
            let (name, value) = definition.of(description);
            let is_late = |name: &&Ident| late.iter().any(|one| **name == one.of(description).0);
            let follows = value.and_then(|value| value.names().into_iter().find(is_late));
            if let (Definition::Mass, Some(name)) = (definition, follows) {
                let message =
                    format!("this is fixed, and `{name}` follows from how the body moves");
                self.errors.push(name.span(), message);
                self.scope.define("mass", None);
                continue;
            }
            let reported = self.errors.count();
            if follows.is_none() {
                self.work.met_still = false;
                self.definition(*definition, description, defaults, mass);
            }
            let is_late = *definition != Definition::Mass && self.is_late(&name);
            if follows.is_some() || self.work.met_still || is_late {
                // errors for a body at rest may differ from those for a moving body, so they are
                // withdrawn
                self.errors.take_back(reported);
                self.scope.forget(&name);
                late.push(*definition);
            }
        }
        late
    }

    /// Whether the value of a name depends on the motion.
    fn is_late(&self, name: &str) -> bool {
        let graph = &self.work.graph;
        match self.scope.peek(name) {
            // time and user-defined states are known before the motion is
            Some(Value::Scalar(id, _)) => self.work.follows_motion(&[id]),
            Some(Value::Condition(id)) => !graph.is_early(id),
            Some(Value::Components(_, components, _)) => !graph.are_early(&components),
            Some(Value::Vector(vector, _) | Value::Point(Point::Moving(vector))) => {
                !graph.are_early(&self.work.entries(&[vector]))
            }
            _ => false,
        }
    }

    /// The value of a point or a local.
    fn read(&mut self, definition: Definition, description: &Description) -> Option<Value> {
        let (name, value) = definition.of(description);
        if let Definition::Point(_) = definition {
            return self.point(value?).map(Value::Point);
        }
        let value = self.value(value?)?;
        Some(self.named(value, &name))
    }

    /// Reads some definitions a second time: those that the parts refer to, once G is known; and
    /// those that the direction of a rod refers to, once the axis is known.
    fn read_again(&mut self, definition: Definition, description: &Description) {
        let (name, _) = definition.of(description);
        if self.scope.peek(&name).is_some() {
            let value = self.read(definition, description);
            self.scope.redefine(&name, value);
        }
    }

    /// The total mass of the parts. With it, G becomes known.
    fn mass_of_parts(&mut self, parts: &Composition, defaults: &Defaults) -> Option<Id> {
        self.composed = self.compose(parts, defaults);
        if self.composed.is_none() {
            self.scope.define("G", None);
        }
        self.composed.map(|composed| composed.mass)
    }

    /// Makes a local a statement of the code, under its own name.
    pub fn named(&mut self, value: Value, name: &str) -> Value {
        let Workspace { graph, labels, .. } = &mut *self.work;
        match value {
            Value::Scalar(id, dimension) => {
                let id = graph.quantity(id);
                labels.name(id, name);
                Value::Scalar(id, dimension)
            }
            Value::Vector(vector, dimension) => {
                let vector = self.work.map(vector, Graph::quantities);
                let parts = self.work.parts(vector).to_vec();
                let is_alone = parts.len() == 1;
                for (frame, part) in parts {
                    let labels = &mut self.work.labels;
                    if is_alone || frame == Frame::WORLD {
                        labels.vector(name, part);
                    } else {
                        labels.vector(&format!("{name}_{}", frame.word()), part);
                    }
                }
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
        self.check_course(value, &[mass], "the mass is constant")?;
        match self.known(mass, defaults) {
            Some(number) if !number.is_positive() => {
                let number = shown(&number);
                self.report(
                    value.extent,
                    format!("the mass of a body that moves is positive, and this is {number}"),
                )
            }
            Some(number) if !number.fits_f64() => {
                self.report(value.extent, "this mass is out of the range of `f64`")
            }
            _ => Some(self.work.graph.positive_quantity(mass)),
        }
    }

    /// Checks that a body that moves has a mass, and only one.
    pub fn check_mass_key(&mut self, description: &Description, motion_is_known: bool) {
        if description.composition.is_some() {
            if let Some(key) = description.keys.iter().find(|key| *key == "mass") {
                self.errors.push(
                    key.span(),
                    "the parts of `compose([..])` have the mass of the body: leave `mass` out",
                );
            }
            return;
        }
        if description.mass.is_some() || !self.motion.knows_position() {
            return;
        }
        self.scope.define("mass", None);
        // one that follows the inertia is reported there
        let inertia = description
            .inertia
            .as_ref()
            .and_then(|inertia| inertia.value.as_ref());
        let is_misplaced = inertia.is_some_and(
            |inertia| matches!(&inertia.kind, Kind::Method(_, method, _) if method == "mass"),
        );
        if motion_is_known && !is_misplaced {
            let name = &description.name;
            self.errors.push(
                name.span(),
                format!("`{name}` has no mass: write `mass: 1[kg]`"),
            );
        }
    }
}
