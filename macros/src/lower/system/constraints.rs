//! Constraints of a system and of its bodies.

use crate::errors::Errors;
use crate::model::{Constraints, Declared, TreeJoint};

use super::reading::body::Draft;
use super::reading::reader::Reader;

impl Reader<'_> {
    /// Reads the constraints written outside the bodies; loads may depend on their forces.
    pub fn top_constraints(&mut self, inputs: &[Declared], errors: &mut Errors) {
        let top = &self.system.top;
        let first = self.first_load;
        let found = self.at_top(errors, |lowering| lowering.kept(top, inputs, first));
        self.keep(found, None);
    }

    /// Adds to the constraints their form as functions of separately displaced bodies.
    pub fn constraints_apart(
        &mut self,
        drafts: &mut [Draft<'_>],
        joints: &[TreeJoint],
        errors: &mut Errors,
    ) -> Option<Constraints> {
        let mut kept = self.kept.take()?;
        if kept.list.is_empty() {
            return Some(kept);
        }
        let form = self.apart(drafts, joints, |reader, drafts, _| {
            reader.each_apart(drafts, errors, |lowering, description| {
                lowering.values_kept(description)
            })
        });
        kept.form = Some(form?);
        Some(kept)
    }
}
