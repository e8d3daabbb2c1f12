//! Constraints of a system and of its bodies.

use std::collections::HashSet;

use proc_macro2::Ident;
use quote::format_ident;

use crate::errors::Errors;
use crate::lower::expressions::Lowering;
use crate::model::{Constraint, Declared, Kept, TreeJoint};
use crate::symbolic::Id;
use crate::syntax::Description;

use super::reading::body::Draft;
use super::reading::names::for_copy;
use super::reading::reader::Reader;

impl Reader<'_> {
    /// Reads the constraints of the system and of its bodies: as functions of its state, and of each
    /// body by itself.
    pub fn constraints(
        &mut self,
        drafts: &mut [Draft<'_>],
        joints: &[TreeJoint],
        inputs: &[Declared],
        errors: &mut Errors,
    ) -> Option<Kept> {
        let list = self.constraints_of_all(drafts, errors, |lowering, description, body| {
            let mut found = lowering.constraints(description, inputs)?;
            if let Some(body) = body {
                for one in &mut found {
                    one.name = format!("{body}_{}", one.name);
                    one.place = format_ident!("{body}_{}", one.place, span = one.place.span());
                }
            }
            Some(found)
        });
        let list: Vec<Constraint> = list?;
        if list.is_empty() {
            return Some(Kept { list, form: None });
        }
        let form = self.apart(drafts, joints, |reader, drafts, _| {
            let top = &reader.system.top;
            reader.at_top(errors, |lowering| lowering.locals_apart(top));
            for draft in drafts.iter_mut() {
                for local in &top.locals {
                    let name = local.name.to_string();
                    draft.scope.redefine(&name, reader.scope.peek(&name));
                }
            }
            reader.constraints_of_all(drafts, errors, |lowering, description, body| {
                if body.is_some() {
                    lowering.locals_apart(description);
                }
                let written = description.constraints.iter();
                let values = written.map(|written| lowering.kept_at_zero(written));
                let values: Vec<Vec<(String, Id)>> = values.collect::<Option<_>>()?;
                Some(values.into_iter().flatten().map(|(_, id)| id).collect())
            })
        });
        Some(Kept {
            list,
            form: Some(form?),
        })
    }

    /// Reads something of the constraints of the system, and then of each body.
    fn constraints_of_all<T>(
        &mut self,
        drafts: &mut [Draft<'_>],
        errors: &mut Errors,
        mut read: impl FnMut(&mut Lowering<'_>, &Description, Option<&Ident>) -> Option<Vec<T>>,
    ) -> Option<Vec<T>> {
        let top = &self.system.top;
        let mut all = self.at_top(errors, |lowering| read(lowering, top, None));
        let mut wrong = HashSet::new();
        for (number, draft) in drafts.iter_mut().enumerate() {
            let body = draft.description;
            if body.constraints.is_empty() {
                continue;
            }
            let first = self.system.firsts[number];
            let found = for_copy(first, number, &mut wrong, errors, |errors| {
                self.in_body(draft, errors, |lowering, _| {
                    read(lowering, body, Some(&body.name))
                })
            });
            match (&mut all, found) {
                (Some(all), Some(found)) => all.extend(found),
                _ => all = None,
            }
        }
        all
    }
}
