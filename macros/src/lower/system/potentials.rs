//! Potentials of a system and of its bodies.

use crate::errors::Errors;
use crate::model::{Potential, Potentials, TreeJoint};

use super::reading::body::Draft;
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
                reader.each_apart(drafts, errors, |lowering, description| {
                    lowering.energies(description, rates)
                })
            });
            forms.push(form?);
        }
        Some(Potentials { list, forms })
    }
}
