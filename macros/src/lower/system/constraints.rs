//! Constraints of a system and of its bodies.

use std::collections::HashSet;

use proc_macro2::Ident;
use quote::format_ident;

use crate::errors::Errors;
use crate::lower::expressions::{Lowering, Value};
use crate::model::{Constraint, Declared, Dimension, Frame, Kept, Level, Meaning, TreeJoint};
use crate::symbolic::{Components, Id, Stage};
use crate::syntax::{Definition, Description};

use super::reading::body::Draft;
use super::reading::names::for_copy;
use super::reading::reader::Reader;

impl Reader<'_> {
    /// Reads the constraints that stand beside the bodies; loads may follow what keeps them.
    pub fn top_constraints(&mut self, inputs: &[Declared], errors: &mut Errors) {
        let top = &self.system.top;
        let first = self.first_load;
        let found = self.at_top(errors, |lowering| lowering.kept(top, inputs, first));
        self.keep(found, None);
    }

    /// Adds constraints, those of a body by names that begin with its own; `None` if they were reported.
    pub fn keep(&mut self, found: Option<Vec<(Constraint, Id)>>, body: Option<&Ident>) {
        let (Some(kept), Some(found)) = (&mut self.kept, found) else {
            self.kept = None;
            return;
        };
        for (mut constraint, load) in found {
            if let Some(body) = body {
                let place = &constraint.place;
                constraint.name = format!("{body}_{}", constraint.name);
                constraint.place = format_ident!("{body}_{place}", span = place.span());
            }
            kept.list.push(constraint);
            kept.loads.push(load);
        }
    }

    /// Adds to the constraints what they are as functions of each body by itself.
    pub fn constraints_apart(
        &mut self,
        drafts: &mut [Draft<'_>],
        joints: &[TreeJoint],
        errors: &mut Errors,
    ) -> Option<Kept> {
        let mut kept = self.kept.take()?;
        if kept.list.is_empty() {
            return Some(kept);
        }
        let form = self.apart(drafts, joints, |reader, drafts, _| {
            let top = &reader.system.top;
            let mut all = reader.at_top(errors, |lowering| {
                lowering.locals_apart(top);
                lowering.values_kept(top)
            })?;
            let mut wrong = HashSet::new();
            for (number, draft) in drafts.iter_mut().enumerate() {
                for local in &top.locals {
                    let name = local.name.to_string();
                    draft.scope.redefine(&name, reader.scope.peek(&name));
                }
                let (body, first) = (draft.description, reader.system.firsts[number]);
                let found = for_copy(first, number, &mut wrong, errors, |errors| {
                    reader.in_body(draft, errors, |lowering, _| {
                        lowering.locals_apart(body);
                        lowering.values_kept(body)
                    })
                });
                all.extend(found?);
            }
            Some(all)
        });
        kept.form = Some(form?);
        Some(kept)
    }
}

impl Lowering<'_> {
    /// Reads constraints, each with the symbol of the load that keeps it, and gives the names of these
    /// loads a meaning. `first` is the number of the first one.
    pub fn kept(
        &mut self,
        description: &Description,
        inputs: &[Declared],
        first: usize,
    ) -> Option<Vec<(Constraint, Id)>> {
        let constraints = self.constraints(description, inputs)?;
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

    /// What the load is of a constraint: a scalar, or a vector as the constraint is one. Its power is
    /// that of its product with the rate of what it keeps at zero.
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
        let value = written.value.as_ref()?;
        let of_link = self.link(value).flatten();
        let of_link = of_link.map(|id| Value::Scalar(id, Dimension::LENGTH));
        Some(match of_link.or_else(|| self.value(value))? {
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

    /// What constraints keep at zero, as it is read now.
    fn values_kept(&mut self, description: &Description) -> Option<Vec<Id>> {
        let mut all = Vec::new();
        for written in &description.constraints {
            let components = self.kept_at_zero(written)?;
            all.extend(components.into_iter().map(|(_, id)| id));
        }
        Some(all)
    }
}
