//! `inverse`: the open drives that give the joints prescribed accelerations.

use proc_macro2::Ident;
use quote::quote;

use crate::emit::code::{Method, Site, Source};
use crate::emit::items::{Addition, Field, Record};
use crate::lower::{INVERSE, Offer, targets};
use crate::mechanics::derive_system_inverse;
use crate::model::{System, TreeJoint};
use crate::outputs::output::{Basis, Output};
use crate::symbolic::Id;

const OFFER: Offer = Offer {
    is_missed: |_| true,
    is_of_motion: true,
    ..Offer::new(INVERSE)
};

/// The error for joints without open drives.
fn without_drives(joints: &[&TreeJoint], is_planar: bool) -> String {
    let names: Vec<String> = joints.iter().map(|joint| joint.name.to_string()).collect();
    let drives = joints.iter().flat_map(|joint| {
        let open = joint.open.iter().enumerate();
        let undriven = open.filter(|(_, drive)| drive.is_none());
        let undriven: Vec<usize> = undriven.map(|(freedom, _)| freedom).collect();
        targets(joint, &undriven, is_planar)
    });
    let drives =
        drives.map(|target| format!("{}_drive = _.on({target})", target.replace('.', "_")));
    let drives: Vec<String> = drives.collect();
    let form = match drives.as_slice() {
        [drive] => drive.clone(),
        several => format!("drives: [{}]", several.join(", ")),
    };
    format!(
        "no open drive acts on `{}`, and `inverse` finds the drives that produce a given motion of all \
         joints: write `{form}`",
        names.join("`, `"),
    )
}

/// The open drives, each with its name and the loads along its freedoms.
#[derive(Default)]
pub struct Inverse(Option<Vec<(Ident, Vec<Id>)>>);

impl Output<System> for Inverse {
    fn offer(&self) -> Option<&'static Offer> {
        Some(&OFFER)
    }

    fn derive(&mut self, basis: &mut Basis<'_, System>) -> Option<()> {
        let system = basis.model;
        let open = || system.joints.iter().flat_map(|joint| &joint.open);
        let joints = system.joints.iter().filter(|joint| !joint.is_driven());
        if !system.is_tree() && open().all(Option::is_none) {
            let message =
                "no drive is open: write `motor = _.on(elbow)` for each that is to be found";
            return basis.errors.report(basis.outline.place(INVERSE)?, message);
        }
        // under constraints, some joints need no drive because they move with the others
        let undriven: Vec<&TreeJoint> = joints
            .filter(|joint| system.is_tree() && joint.open.iter().any(Option::is_none))
            .collect();
        if let Some(first) = undriven.first() {
            let place = match undriven.len() {
                1 => first.written,
                _ => basis.outline.place(INVERSE)?,
            };
            return basis
                .errors
                .report(place, without_drives(&undriven, system.is_planar));
        }
        let found = derive_system_inverse(system, basis.work, basis.equations, basis.errors);
        let mut drives: Vec<(Ident, Vec<Id>)> = Vec::new();
        for (name, load) in open().flatten().zip(found) {
            match drives.last_mut() {
                Some((last, loads)) if last == name => loads.push(load),
                _ => drives.push((name.clone(), vec![load])),
            }
        }
        self.0 = Some(drives);
        Some(())
    }

    fn roots(&self) -> Vec<Id> {
        loads(self.0.iter().flatten())
    }

    fn emit(&self, site: &Site<'_>) -> Addition {
        let (shapes, outline) = (&site.shapes, site.outline);
        let derived = self.0.iter().flatten();
        let derived = derived.map(|(name, loads)| (name, loads.len()));
        let stub = outline.open.iter().filter(|_| self.0.is_none());
        let stub = stub.map(|(name, count)| (name, *count));
        let drives: Vec<(&Ident, usize)> = derived.chain(stub).collect();
        let fields = drives.iter();
        let fields = fields.map(|(name, count)| Field::new(name, shapes.numbers_type(*count)));
        let by_name = Record {
            suffix: "Drives",
            doc: format!(
                " The open drives of [`{}`], in N * m or N. Several components are those of the rate of \
                 the coordinate, in its axes.",
                outline.name
            ),
            fields: fields.collect(),
            has_default: true,
        };
        let method = site.method(self.0.as_ref(), |writer, solved| {
            Method::write(writer, &loads(solved.iter()), |values| {
                by_name.filled(outline, values, |drive, values| {
                    let parts = values.take(drives[drive].1);
                    if drives[drive].1 == 1 {
                        quote!(#(#parts)*)
                    } else {
                        quote!(::core::convert::Into::into([#(#parts),*]))
                    }
                })
            })
        });
        let kind = site.own_type("Drives");
        let arguments = [
            Source::Time,
            Source::State,
            Source::Acceleration,
            Source::Input,
        ];
        let methods = [("inverse", &method, &arguments[..], &kind)];
        let types = quote!(type Drives = #kind;);
        let addition = Addition::implement(site, "Inverse", [types, quote!()], &methods);
        addition.with(outline, &by_name)
    }
}

fn loads<'d>(drives: impl Iterator<Item = &'d (Ident, Vec<Id>)>) -> Vec<Id> {
    drives.flat_map(|(_, loads)| loads).copied().collect()
}
