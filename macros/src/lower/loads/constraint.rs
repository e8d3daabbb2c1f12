//! Constraints: `name = expression`, which is kept at zero.

use std::collections::{BTreeMap, HashSet};

use proc_macro2::Ident;

use crate::lower::expressions::{Lowering, Value, difference};
use crate::lower::loads::link::is_link;
use crate::model::{AXES, Constraint, Declared, Dimension, Frame, Level, Meaning, Variable};
use crate::symbolic::Id;
use crate::syntax::{Definition, Description, Expression};

/// The place where a definition mentions a name, directly or in a local that it uses.
fn mention<'d>(
    written: &'d Definition,
    name: &str,
    description: &'d Description,
) -> Option<&'d Ident> {
    let mut pending = vec![written];
    let mut seen = HashSet::new();
    while let Some(definition) = pending.pop() {
        let names = definition.value.iter().flat_map(Expression::names);
        for found in names {
            if found == name {
                return Some(found);
            }
            let is_it = |local: &&Definition| local.name == *found;
            if let Some(local) = description.locals.iter().find(is_it)
                && seen.insert(local.name.to_string())
            {
                pending.push(local);
            }
        }
    }
    None
}

impl Lowering<'_> {
    /// The scalars of all constraints; their inputs must be `.moving`.
    pub fn constraints(
        &mut self,
        description: &Description,
        inputs: &[Declared],
    ) -> Option<Vec<Constraint>> {
        let mut all = Some(Vec::new());
        for written in &description.constraints {
            let found = self.constraint(written);
            let found = found.filter(|found| {
                self.check_inputs(written, found, description, inputs)
                    .is_some()
            });
            self.scope
                .define_constraints(&written.name.to_string(), found.as_deref());
            match (&mut all, found) {
                (Some(all), Some(found)) => all.extend(found),
                _ => all = None,
            }
        }
        all
    }

    /// The scalars of one constraint, each with its level.
    fn constraint(&mut self, written: &Definition) -> Option<Vec<Constraint>> {
        let (name, value) = (&written.name, written.value.as_ref()?);
        let extent = value.extent.underlining(name.span());
        let mut constraints = Vec::new();
        for (scalar, value) in self.kept_at_zero(written)? {
            let Some(level) = self.level(value) else {
                let message = if written.value.as_ref().is_some_and(is_link) {
                    format!(
                        "neither end of `{scalar}` moves by itself: nothing determines its tension; leave it out"
                    )
                } else {
                    format!(
                        "`{scalar}` does not depend on where the body is or how it moves: no load can keep it at \
                         zero"
                    )
                };
                return self.report(extent, message);
            };
            let own = self.own_states(&[value]).into_iter();
            let place = |state: Id| {
                written
                    .value
                    .as_ref()
                    .map(|value| self.dependent_name(value, &[state], &[]))
            };
            let states = own.filter_map(|state| Some((state, place(state)?)));
            constraints.push(Constraint {
                name: scalar,
                place: name.clone(),
                extent,
                level,
                value,
                states: states.collect(),
            });
        }
        Some(constraints)
    }

    /// The value of a constraint; for a link, the value that the link keeps at zero.
    pub fn constrained(&mut self, expression: &Expression) -> Option<Value> {
        match self.link(expression) {
            Some(link) => Some(Value::Scalar(link?, Dimension::LENGTH)),
            None => self.value(expression),
        }
    }

    /// The scalars of one constraint. A vector counts as its components, in world axes unless other
    /// axes are written.
    pub fn kept_at_zero(&mut self, written: &Definition) -> Option<Vec<(String, Id)>> {
        let expression = written.value.as_ref()?;
        let name = &written.name;
        let value = self.constrained(expression)?;
        let scalars = match value {
            Value::Scalar(id, _) => Some(vec![(name.to_string(), id)]),
            Value::Components(_, components, _) => Some(self.named_components(name, components)),
            Value::Vector(vector, _) => {
                let components = self.work.components(vector, Frame::WORLD);
                Some(self.named_components(name, components))
            }
            other => {
                let advice = difference(expression)
                    .map_or_else(String::new, |form| format!(": write `{form}`"));
                self.report(
                    expression.extent,
                    format!(
                        "a constraint is a scalar or a vector that is kept at zero, and this is {}{advice}",
                        other.kind()
                    ),
                )
            }
        }?;
        let values: Vec<Id> = scalars.iter().map(|(_, value)| *value).collect();
        self.check_no_acceleration(expression, &values, "a constraint")?;
        Some(scalars)
    }

    /// Reports inputs that are not `.moving`, because inputs in a constraint are differentiated
    /// with it.
    fn check_inputs(
        &mut self,
        written: &Definition,
        constraints: &[Constraint],
        description: &Description,
        inputs: &[Declared],
    ) -> Option<()> {
        let graph = &self.work.graph;
        let mut lacking: BTreeMap<usize, Level> = BTreeMap::new();
        for constraint in constraints {
            for part in graph.reachable(&[constraint.value], &|id| !graph.is_early(id)) {
                let Some(Meaning::Input(input, _)) = self.work.meaning(part) else {
                    continue;
                };
                if inputs[input].derivatives() < constraint.level.derivatives() {
                    lacking.insert(input, constraint.level);
                }
            }
        }
        for (input, level) in &lacking {
            let (input, name) = (&inputs[*input], &inputs[*input].name);
            let word = name.to_string();
            let place = mention(written, &word, description).unwrap_or(&written.name);
            let message = if input.moves || input.order > 0 {
                format!(
                    "a constraint of positions is differentiated twice, and `{word}` is given with fewer \
                     derivatives: write a constraint of velocities, or an input of its own that is `.moving`"
                )
            } else {
                let needed = match level {
                    Level::Position => "its rate and acceleration",
                    Level::Velocity => "its rate",
                };
                let unit = if input.dimension.is_known() {
                    input.dimension.unit()
                } else {
                    String::new()
                };
                let form = match input.frame {
                    None => format!("{name}{unit}"),
                    Some(frame) => {
                        let open = vec!["_"; self.motion.axes()].join(", ");
                        format!("{name} = {}({open}){unit}", frame.text())
                    }
                };
                format!(
                    "a constraint is differentiated in time, and nothing tells how the input `{word}` moves: \
                     write `{form}.moving` in `inputs`, which is given with {needed}, or a function of `t` here"
                )
            };
            self.errors.push(place.span(), message);
        }
        lacking.is_empty().then_some(())
    }

    fn named_components(&self, name: &Ident, components: [Id; 3]) -> Vec<(String, Id)> {
        let axes = self.motion.axes();
        let named = components.into_iter().zip(AXES).take(axes);
        named
            .map(|(id, axis)| (format!("{name}.{axis}"), id))
            .collect()
    }

    /// The level of a constraint; `None` if it depends on no part of the state.
    fn level(&self, value: Id) -> Option<Level> {
        use Variable::{Angle, AngularVelocity, Axis, AxisRate, Position, Quaternion, Velocity};
        let depends = |variables: &[Variable]| self.work.depend_on(&[value], variables);
        if depends(&[Velocity, AngularVelocity, AxisRate]) {
            return Some(Level::Velocity);
        }
        depends(&[Position, Angle, Quaternion, Axis]).then_some(Level::Position)
    }
}
