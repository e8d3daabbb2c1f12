//! Potentials of a system and of its bodies.

use std::collections::HashSet;

use crate::errors::Errors;
use crate::model::{Potential, Potentials, TreeJoint};
use crate::symbolic::Id;
use crate::syntax::Definition;

use super::reading::body::Draft;
use super::reading::names::for_copy;
use super::reading::reader::Reader;

impl Reader<'_> {
    /// Reads the potentials of the system and of its bodies.
    pub fn potentials(
        &mut self,
        drafts: &mut [Draft<'_>],
        joints: &[TreeJoint],
        errors: &mut Errors,
    ) -> Option<Potentials> {
        let of_bodies = drafts
            .iter()
            .flat_map(|draft| &draft.description.potentials);
        let written = self.system.top.potentials.iter().chain(of_bodies);
        let list: Vec<Potential> = written
            .map(|potential| Potential {
                name: potential.name.clone(),
                place: 0,
                charges: None,
            })
            .collect();
        let mut forms = Vec::new();
        let is_known = self.members.bodies.iter().all(|body| body.motion.is_some());
        if !list.is_empty() && is_known {
            let form = self.apart(drafts, joints, |reader, drafts, rates| {
                reader.energies(drafts, rates, errors)
            });
            forms.push(form?);
        }
        Some(Potentials { list, forms })
    }

    /// The energies, as functions of what is kept apart.
    fn energies(
        &mut self,
        drafts: &mut [Draft<'_>],
        rates: &[Id],
        errors: &mut Errors,
    ) -> Option<Vec<Id>> {
        let top = &self.system.top;
        let mut energies: Vec<Option<Id>> = self.at_top(errors, |lowering| {
            lowering.locals_apart(top);
            let read = |potential: &Definition| lowering.potential(potential.value.as_ref(), rates);
            top.potentials.iter().map(read).collect()
        });
        let mut wrong = HashSet::new();
        for (number, draft) in drafts.iter_mut().enumerate() {
            for local in &top.locals {
                let name = local.name.to_string();
                draft.scope.redefine(&name, self.scope.peek(&name));
            }
            let body = draft.description;
            let first = self.system.firsts[number];
            let of_body = for_copy(first, number, &mut wrong, errors, |errors| {
                self.in_body(draft, errors, |lowering, _| {
                    lowering.locals_apart(body);
                    let read = |potential: &Definition| {
                        lowering.potential(potential.value.as_ref(), rates)
                    };
                    body.potentials.iter().map(read).collect::<Vec<_>>()
                })
            });
            energies.extend(of_body);
        }
        energies.into_iter().collect()
    }
}
