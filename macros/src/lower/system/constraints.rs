//! Constraints of a system and of its bodies.

use std::collections::HashSet;

use crate::errors::Errors;
use crate::model::{Declared, Kept, TreeJoint};

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
