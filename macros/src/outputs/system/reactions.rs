//! `reactions`, or `reactions(elbow)` for some joints only: the force and moment of a joint on what
//! it carries.

use proc_macro2::Ident;
use quote::quote;

use crate::emit::code::{COMMON, Method, Site};
use crate::emit::items::Addition;
use crate::errors::Extent;
use crate::lower::Offer;
use crate::mechanics::{
    derive_system_driving, derive_system_open, derive_system_reactions, derive_system_release,
};
use crate::model::System;
use crate::outputs::output::{Basis, Output};
use crate::symbolic::{Components, Id};

use crate::outputs::by_name::{driving_of, held, reactions_by_name};

const OFFER: Offer = Offer {
    is_missed: |_| true,
    ..Offer::new("reactions")
};

/// The loads that joints carry.
struct Carried {
    /// The force and the moment of each joint, with its name.
    wrenches: Vec<(Ident, [Components; 2])>,
    /// The loads along coordinates with prescribed motion, and those of written constraints, by
    /// name.
    scalars: Vec<(Ident, Id)>,
}

#[derive(Default)]
pub struct Reactions(Option<Carried>);

impl Output<System> for Reactions {
    fn offer(&self) -> Option<&'static Offer> {
        Some(&OFFER)
    }

    fn derive(&mut self, basis: &mut Basis<'_, System>) -> Option<()> {
        check_some(basis)?;
        check_determined(basis)?;
        let loads = derive_system_reactions(basis.model, basis.work, basis.equations);
        let held = held(basis.outline).filter_map(|name| {
            let mut all = loads.iter();
            all.find(|(joint, _)| joint == name).cloned()
        });
        let held: Vec<_> = held.collect();
        for (name, [force, moment]) in &held {
            let labels = &mut basis.work.labels;
            labels.vector(&format!("{name}_force"), *force);
            labels.vector(&format!("{name}_moment"), *moment);
        }
        let driving = derive_system_driving(basis.work, basis.equations);
        let joints = basis.model.joints.iter().zip(&driving);
        let drives = driving_of(basis.outline).filter_map(|(joint, name)| {
            let mut all = joints.clone();
            let (_, loads) = all.find(|(other, _)| other.name == *joint)?;
            let mut same = driving_of(basis.outline).filter(|(other, _)| other == joint);
            let number = same.position(|(_, other)| other == name)?;
            Some((name.clone(), *loads.get(number)?))
        });
        let loads = basis.equations.kept_loads().iter().copied();
        let kept = basis.outline.kept.iter().cloned().zip(loads);
        let kept = kept.filter(|(name, _)| basis.outline.is_held(name));
        let scalars: Vec<(Ident, Id)> = drives.chain(kept).collect();
        for (name, load) in &scalars {
            basis.work.labels.name(*load, name.to_string());
        }
        self.0 = Some(Carried {
            wrenches: held,
            scalars,
        });
        Some(())
    }

    fn roots(&self) -> Vec<Id> {
        let wrenches = self.0.iter().flat_map(|carried| &carried.wrenches);
        let scalars = self.0.iter().flat_map(|carried| &carried.scalars);
        let wrenches = wrenches.flat_map(|(_, pair)| pair.concat());
        wrenches.chain(scalars.map(|(_, load)| *load)).collect()
    }

    fn emit(&self, site: &Site<'_>) -> Addition {
        let (shapes, outline) = (&site.shapes, site.outline);
        let by_name = reactions_by_name(site);
        let count = held(outline).count();
        let method = site.method(self.0.as_ref(), |writer, carried| {
            let wrenches = carried.wrenches.iter();
            let parts = wrenches.flat_map(|(_, [force, moment])| shapes.wrench_part(force, moment));
            let scalars = carried.scalars.iter().map(|(_, load)| *load);
            let parts: Vec<Id> = parts.chain(scalars).collect();
            Method::write(writer, &parts, |values| {
                by_name.filled(outline, values, |field, values| {
                    if field < count {
                        shapes.wrench(values)
                    } else {
                        let value = values.next();
                        quote!(#value)
                    }
                })
            })
        });
        let kind = site.own_type("Reactions");
        let methods = [("reactions", &method, &COMMON[..], &kind)];
        let types = quote!(type Reactions = #kind;);
        let addition = Addition::implement(site, "Reactions", [types, quote!()], &methods);
        addition.with(outline, &by_name)
    }
}

/// Reports that no joint or constraint holds anything, if all reactions are requested.
fn check_some(basis: &mut Basis<'_, System>) -> Option<()> {
    let outline = basis.outline;
    let mut kept = outline.kept.iter().filter(|name| outline.is_held(name));
    let is_some = outline.held.is_some()
        || held(outline).next().is_some()
        || driving_of(outline).next().is_some()
        || kept.next().is_some();
    if is_some {
        return Some(());
    }
    let message = "there are no reactions: no joint holds what it carries";
    basis.errors.report(outline.place(OFFER.word)?, message)
}

/// Reports requested loads that are not determined, at the names of the requested joints.
fn check_determined(basis: &mut Basis<'_, System>) -> Option<()> {
    let (system, outline) = (basis.model, basis.outline);
    let open = derive_system_open(system, basis.work, basis.equations);
    let parts_of = |name: Option<&Ident>| -> Vec<&str> {
        let open = open.iter();
        let own = open.filter(|(other, _)| name.is_none_or(|name| name == other));
        own.map(|(_, part)| part.as_str()).collect()
    };
    let asked: Vec<(Extent, Vec<&str>)> = match &outline.held {
        None => vec![(outline.place(OFFER.word)?, parts_of(None))],
        Some(names) => names
            .iter()
            .map(|name| (name.span().into(), parts_of(Some(name))))
            .collect(),
    };
    let asked: Vec<_> = asked
        .iter()
        .filter(|(_, parts)| !parts.is_empty())
        .collect();
    if asked.is_empty() {
        return Some(());
    }
    let release = derive_system_release(system, basis.work, basis.equations);
    let mut against: Vec<String> = open.iter().map(|(name, _)| format!("`{name}`")).collect();
    against.dedup();
    // "`a`, `b` and `c`"
    if let [.., _, _] = against[..]
        && let Some(last) = against.pop()
        && let Some(other) = against.last_mut()
    {
        *other = format!("{other} and {last}");
    }
    for (place, parts) in asked {
        let message = format!(
            "the balances do not determine {}, because {} hold against each other: they are determined \
             {release}; or request only other reactions, `reactions(..)`",
            parts.join(", "),
            against.join(", "),
        );
        basis.errors.push(*place, message);
    }
    None
}
