//! Constraints while they are read, and their loads.

use proc_macro2::Ident;

use crate::lower::expressions::{Lowering, Value};
use crate::model::{Constraint, Declared, Dimension, Frame, Level, Meaning};
use crate::symbolic::{Components, Id, Stage};
use crate::syntax::{Definition, Description, joined};

use super::reader::Reader;

impl Reader<'_> {
    /// Adds constraints; those of a body get its name as a prefix. `None` if errors were reported.
    pub fn keep(&mut self, found: Option<Vec<(Constraint, Id)>>, body: Option<&Ident>) {
        let (Some(kept), Some(found)) = (&mut self.kept, found) else {
            self.kept = None;
            return;
        };
        for (mut constraint, load) in found {
            if let Some(body) = body {
                let place = &constraint.place;
                constraint.name = format!("{body}_{}", constraint.name);
                constraint.place = joined(body, place);
            }
            kept.list.push(constraint);
            kept.loads.push(load);
        }
    }
}

impl Lowering<'_> {
    /// Reads constraints, each with the symbol of its load, and defines the names of these loads.
    /// `first` is the index of the first one.
    pub fn kept(
        &mut self,
        description: &Description,
        inputs: &[Declared],
        first: usize,
    ) -> Option<Vec<(Constraint, Id)>> {
        let Some(constraints) = self.constraints(description, inputs) else {
            let names = description.constraints.iter().map(|written| &written.name);
            names.for_each(|name| self.scope.define(&name.to_string(), None));
            return None;
        };
        let mut loads = Vec::new();
        for number in first..first + constraints.len() {
            let meaning = Meaning::Reaction(number, 0);
            loads.push(self.work.symbol(Stage::State, meaning));
        }
        for written in &description.constraints {
            let of_it = || {
                let all = constraints.iter().zip(&loads);
                all.filter(|(constraint, _)| constraint.place == written.name)
            };
            let symbols: Vec<Id> = of_it().map(|(_, load)| *load).collect();
            let level = of_it().next().map(|(constraint, _)| constraint.level);
            let value = self.load_that_keeps(written, level?, &symbols);
            self.scope.define(&written.name.to_string(), value);
        }
        Some(constraints.into_iter().zip(loads).collect())
    }

    /// The load of a constraint: a scalar or a vector, like the constraint. Its product with the
    /// rate of a constraint of positions, or with a constraint of velocities itself, is a power.
    fn load_that_keeps(
        &mut self,
        written: &Definition,
        level: Level,
        symbols: &[Id],
    ) -> Option<Value> {
        let per = |dimension: Dimension| {
            let energy = match level {
                Level::Position => Some(Dimension::MOMENT),
                Level::Velocity => Dimension::MOMENT.times(Dimension::FREQUENCY),
            };
            energy?.over(dimension)
        };
        let mut components: Components = self.work.graph.zeros();
        for (component, symbol) in components.iter_mut().zip(symbols) {
            *component = *symbol;
        }
        Some(match self.constrained(written.value.as_ref()?)? {
            Value::Scalar(_, dimension) => Value::Scalar(components[0], per(dimension)?),
            Value::Components(frame, _, dimension) => {
                Value::Components(frame, components, per(dimension)?)
            }
            Value::Vector(_, dimension) => {
                let vector = self.work.vector(Frame::WORLD, components);
                Value::Vector(vector, per(dimension)?)
            }
            _ => return None,
        })
    }

    /// The values of constraints, as they are read now.
    pub fn values_kept(&mut self, description: &Description) -> Option<Vec<Id>> {
        let mut all = Vec::new();
        for written in &description.constraints {
            let components = self.kept_at_zero(written)?;
            all.extend(components.into_iter().map(|(_, id)| id));
        }
        Some(all)
    }
}
