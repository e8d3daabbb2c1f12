//! The outputs of a system, each what the one of the same name is for a body alone.

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use crate::emit::code::{COMMON, Method, Shapes, Site, Source};
use crate::emit::items::{Addition, lints};
use crate::errors::Errors;
use crate::families::Family;
use crate::lower::Offer;
use crate::mechanics::{
    Energy, Momentum, Report, SystemEquations, derive_system_energy, derive_system_inverse,
    derive_system_momentum, derive_system_reactions, uniform_field,
};
use crate::model::{Outline, System, Workspace};
use crate::symbolic::{Components, Id};

use super::energy::without_potential;

/// What a system may be asked for.
const OFFERS: [Offer; 4] = [
    Offer::new("energy"),
    Offer::new("momentum"),
    Offer::new("reactions"),
    Offer::new("inverse"),
];

pub fn system_offers() -> Vec<&'static Offer> {
    OFFERS.iter().collect()
}

/// What was asked for, and derived.
#[derive(Default)]
pub struct SystemOutputs {
    energy: Option<Energy>,
    /// What is to be said of fields that the energy does not have.
    left_out: Vec<String>,
    momentum: Option<Momentum>,
    /// Force and moment of each joint, by name.
    reactions: Vec<(Ident, [Components; 2])>,
    /// The open drives, by name.
    drives: Vec<(Ident, Id)>,
}

/// Derives what a system is asked for.
pub fn derive_system_outputs(
    outline: &Outline,
    system: &System,
    work: &mut Workspace,
    equations: &SystemEquations,
    errors: &mut Errors,
) -> Option<SystemOutputs> {
    let mut outputs = SystemOutputs::default();
    let is_asked = |word: &str| outline.rank(word).is_some();
    outputs.energy = is_asked("energy").then(|| derive_system_energy(system, work));
    if is_asked("energy") {
        for body in &system.bodies {
            let fields = body
                .loads
                .iter()
                .filter(|load| load.family == Family::Field && load.potential.is_none());
            for load in fields {
                let line = without_potential(load);
                let has_energy = uniform_field(work, body.state.body, true, load).is_some();
                if !has_energy && !outputs.left_out.contains(&line) {
                    outputs.left_out.push(line);
                }
            }
        }
    }
    outputs.momentum = is_asked("momentum").then(|| derive_system_momentum(system, work));
    if is_asked("reactions") {
        let loads = derive_system_reactions(work, equations);
        let joints = system.joints.iter().zip(loads);
        let held =
            joints.filter(|(joint, _)| !joint.kind.is_free() && outline.is_held(&joint.name));
        outputs.reactions = held
            .map(|(joint, load)| (joint.name.clone(), load))
            .collect();
        for (name, [force, moment]) in &outputs.reactions {
            work.labels.vector(&format!("{name}_force"), *force);
            work.labels.vector(&format!("{name}_moment"), *moment);
        }
    }
    if is_asked("inverse") {
        outputs.drives = derive_drives(system, work, equations, errors)?;
    }
    Some(outputs)
}

/// The open drives of all joints; each joint without one is an error.
fn derive_drives(
    system: &System,
    work: &mut Workspace,
    equations: &SystemEquations,
    errors: &mut Errors,
) -> Option<Vec<(Ident, Id)>> {
    let loads = derive_system_inverse(system, work, equations);
    let (mut drives, mut is_sound) = (Vec::new(), true);
    for (joint, loads) in system.joints.iter().zip(loads) {
        let found = joint.open.iter().zip(loads);
        drives.extend(found.filter_map(|(open, load)| Some((open.clone()?, load))));
        if joint.open.iter().any(Option::is_none) {
            let name = &joint.name;
            let message = format!(
                "nothing drives `{name}`, and inverse dynamics finds the drives that make all joints \
                 move as is given: write `motor = _.on({name})` for each coordinate"
            );
            errors.push(name.span(), message);
            is_sound = false;
        }
    }
    is_sound.then_some(drives)
}

impl SystemOutputs {
    /// Adds to a report what the energy does not have, and which of them were not asked for.
    pub fn describe(&self, outline: &Outline, report: &mut Report) {
        report.skipped.extend(self.left_out.iter().cloned());
        let missed = OFFERS
            .iter()
            .filter(|offer| outline.rank(offer.word).is_none());
        let missed: Vec<&str> = missed.map(|offer| offer.word).collect();
        if !missed.is_empty() {
            report
                .skipped
                .push(format!("{}: not in `outputs`", missed.join(", ")));
        }
    }

    /// The expressions that code is generated for.
    pub fn roots(&self) -> Vec<Id> {
        let energy = self.energy.iter();
        let energy = energy.flat_map(|energy| [energy.kinetic, energy.potential]);
        let momentum = self.momentum.iter();
        let momentum = momentum.flat_map(|one| [one.linear, one.angular, one.about_pole].concat());
        let reactions = self.reactions.iter().flat_map(|(_, pair)| pair.concat());
        let drives = self.drives.iter().map(|(_, load)| *load);
        energy
            .chain(momentum)
            .chain(reactions)
            .chain(drives)
            .collect()
    }

    /// In the order in which they were asked for; `is_sound` is false for a description with mistakes.
    pub fn emit(&self, site: &Site<'_>, is_sound: bool) -> Addition {
        let mut all = Addition::default();
        for asked in &site.outline.outputs {
            let addition = match asked.word {
                "energy" => self.emit_energy(site),
                "momentum" => self.emit_momentum(site),
                "reactions" => self.emit_reactions(site, is_sound),
                _ => self.emit_inverse(site, is_sound),
            };
            all.implementations.extend(addition.implementations);
            all.costs.extend(addition.costs);
        }
        all
    }

    fn emit_energy(&self, site: &Site<'_>) -> Addition {
        let method = |of: fn(&Energy) -> Id| {
            site.method(self.energy.as_ref(), |writer, energy| {
                Method::write(writer, &[of(energy)], |values| quote!(#(#values)*))
            })
        };
        let (kinetic, potential) = (method(|one| one.kinetic), method(|one| one.potential));
        let scalar = site.shapes.scalar.kind();
        let methods = [
            ("kinetic_energy", &kinetic, &[Source::State][..], &scalar),
            ("potential_energy", &potential, &COMMON, &scalar),
        ];
        Addition::implement(site, "Energy", [quote!(), quote!()], &methods)
    }

    fn emit_momentum(&self, site: &Site<'_>) -> Addition {
        let shapes = &site.shapes;
        let moment = |of: fn(&Momentum) -> &Components| {
            site.method(self.momentum.as_ref(), |writer, momentum| {
                Method::write(writer, shapes.moment_part(of(momentum)), |values| {
                    shapes.moment(values)
                })
            })
        };
        let linear = site.method(self.momentum.as_ref(), |writer, momentum| {
            Method::write(writer, shapes.vector_part(&momentum.linear), |values| {
                shapes.vector(values)
            })
        });
        let (angular, about_pole) = (moment(|one| &one.angular), moment(|one| &one.about_pole));
        let (of_linear, of_angular) = (shapes.vector_type(), shapes.moment_type());
        let (state, both) = (&[Source::State][..], [Source::Time, Source::State]);
        let methods = [
            ("linear_momentum", &linear, state, &of_linear),
            ("angular_momentum", &angular, state, &of_angular),
            (
                "angular_momentum_about_pole",
                &about_pole,
                &both,
                &of_angular,
            ),
        ];
        let types = quote!(type Linear = #of_linear; type Angular = #of_angular;);
        Addition::implement(site, "Momentum", [types, quote!()], &methods)
    }

    /// A struct with a wrench for each joint.
    fn emit_reactions(&self, site: &Site<'_>, is_sound: bool) -> Addition {
        let (shapes, outline) = (&site.shapes, site.outline);
        let names: Vec<Ident> = if is_sound {
            self.reactions
                .iter()
                .map(|(name, _)| name.clone())
                .collect()
        } else {
            let joints = outline.joints.iter().map(|joint| joint.name.clone());
            joints.filter(|name| outline.is_held(name)).collect()
        };
        let kind = site.own_type("Reactions");
        let name = format_ident!("{}Reactions", outline.name);
        let fields: Vec<(&Ident, TokenStream)> = names
            .iter()
            .map(|name| (name, shapes.wrench_type()))
            .collect();
        let doc = format!(
            " What the joints of [`{}`] do to the bodies that they carry, at their points there, world axes; drives included.",
            outline.name
        );
        let items = emit_struct(shapes, &name, &doc, &fields);
        let method = site.method(is_sound.then_some(self), |writer, outputs| {
            let parts = outputs.reactions.iter();
            let parts = parts.flat_map(|(_, [force, moment])| shapes.wrench_part(force, moment));
            let parts: Vec<Id> = parts.collect();
            Method::write(writer, &parts, |values| {
                let fields = names.iter().map(|joint| {
                    let wrench = shapes.wrench(values);
                    quote!(#joint: #wrench)
                });
                quote!(#name { #(#fields),* })
            })
        });
        let methods = [("reactions", &method, &COMMON[..], &kind)];
        let mut addition = Addition::implement(
            site,
            "Reactions",
            [quote!(type Reactions = #kind;), quote!()],
            &methods,
        );
        addition.implementations.extend(items);
        addition
    }

    /// A struct with a number for each open drive.
    fn emit_inverse(&self, site: &Site<'_>, is_sound: bool) -> Addition {
        let (shapes, outline) = (&site.shapes, site.outline);
        let kind = site.own_type("Drives");
        let name = format_ident!("{}Drives", outline.name);
        let scalar = shapes.scalar.kind();
        let open = self.drives.iter().map(|(name, _)| name);
        let names: Vec<&Ident> = if is_sound {
            open.collect()
        } else {
            outline.open.iter().collect()
        };
        let fields: Vec<(&Ident, TokenStream)> =
            names.iter().map(|name| (*name, scalar.clone())).collect();
        let doc = format!(" The open drives of [`{}`], in N * m or N.", outline.name);
        let items = emit_struct(shapes, &name, &doc, &fields);
        let method = site.method(is_sound.then_some(self), |writer, outputs| {
            let loads: Vec<Id> = outputs.drives.iter().map(|(_, load)| *load).collect();
            Method::write(writer, &loads, |values| {
                let fields = names.iter().map(|name| {
                    let value = values.next();
                    quote!(#name: #value)
                });
                quote!(#name { #(#fields),* })
            })
        });
        let arguments = [
            Source::Time,
            Source::State,
            Source::Acceleration,
            Source::Input,
        ];
        let methods = [("inverse", &method, &arguments[..], &kind)];
        let mut addition = Addition::implement(
            site,
            "Inverse",
            [quote!(type Drives = #kind;), quote!()],
            &methods,
        );
        addition.implementations.extend(items);
        addition
    }
}

fn emit_struct(
    shapes: &Shapes,
    name: &Ident,
    doc: &str,
    fields: &[(&Ident, TokenStream)],
) -> TokenStream {
    let declared = shapes.scalar.declared();
    let lints = lints(fields.iter().map(|(name, _)| *name));
    let fields = fields.iter().map(|(name, kind)| {
        let doc = format!(" `{name}`");
        quote!(#[doc = #doc] pub #name: #kind)
    });
    quote! {
        #[doc = #doc]
        #lints
        #[derive(Clone, Copy, Debug, Default, PartialEq)]
        pub struct #name #declared { #(#fields),* }
    }
}
