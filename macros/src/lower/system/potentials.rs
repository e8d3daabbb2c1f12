//! Potentials of a system and of its bodies, and uniform fields on the charges of bodies.

use proc_macro2::Ident;

use crate::errors::{Errors, every};
use crate::model::{Potential, Potentials, TreeJoint};
use crate::syntax::{Description, Load};

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
        let top = &self.system.top;
        let of_bodies = drafts.iter().flat_map(|draft| {
            let body = draft.description;
            let fields = on_charges(top, body).map(|load| &load.name);
            fields.chain(body.potentials.iter().map(|potential| &potential.name))
        });
        let of_system = top.potentials.iter().map(|potential| &potential.name);
        let names: Vec<Ident> = of_system.chain(of_bodies).cloned().collect();
        let list: Vec<Potential> = names
            .into_iter()
            .map(|name| Potential {
                name,
                place: 0,
                charges: None,
            })
            .collect();
        let mut forms = Vec::new();
        let is_known = self.members.bodies.iter().all(|body| body.motion.is_some());
        if !list.is_empty() && is_known {
            let form = self.apart(drafts, joints, |reader, drafts, rates| {
                reader.each_apart(drafts, errors, |lowering, description| {
                    let scalars = lowering.energies(description, rates);
                    if lowering.is_whole {
                        return scalars;
                    }
                    let fields = on_charges(top, description);
                    let fields = every(fields.map(|load| lowering.uniform_field(load)));
                    let energies = fields?.into_iter().map(|(energy, _)| energy);
                    Some(energies.chain(scalars?).collect())
                })
            });
            forms.push(form?);
        }
        Some(Potentials { list, forms })
    }
}

/// The uniform fields on the charges of a body.
fn on_charges<'a>(top: &'a Description, body: &'a Description) -> impl Iterator<Item = &'a Load> {
    let of_system = top.loads.iter().filter(|_| !body.is_frame);
    let all = of_system.chain(&body.loads);
    all.filter(|load| load.charges.is_some())
}
