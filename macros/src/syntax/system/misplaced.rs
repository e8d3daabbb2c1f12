//! Keys in a wrong place: those of bodies beside them, and the reverse. They are reported, and read as
//! what they are, so that what refers to them causes no further errors.

use proc_macro2::{Ident, TokenStream, TokenTree};

use crate::errors::Errors;
use crate::syntax::entries::{key_meant, parse_description, parse_key};
use crate::syntax::{Declaration, Definition, Description, Motion, Written};

use super::System;

/// Reports that a system has no pole, in the braces of a body or beside them.
pub(super) fn no_pole(key: &Ident, errors: &mut Errors) {
    let message = "the balances of the bodies of a system are about G: leave `pole` out";
    errors.push(key.span(), message);
}

/// Keys without which nothing is a body.
const OF_ONE_BODY: [&str; 2] = ["mass", "inertia"];

impl System {
    /// Reports and keeps a key of a body that stands beside the bodies.
    pub(super) fn parse_key_of_bodies(
        &mut self,
        key: &Ident,
        entry: &[TokenTree],
        errors: &mut Errors,
    ) {
        if key == "pole" {
            no_pole(key, errors);
            return;
        }
        let message =
            format!("`{key}` belongs to a body: write it in the braces of one, in `bodies`");
        errors.push(key.span(), message);
        self.keep_misplaced(key, entry, errors);
    }

    /// Reports and keeps a key of the system that stands in the braces of a body.
    pub(super) fn parse_key_in_a_body(
        &mut self,
        key: &Ident,
        entry: &[TokenTree],
        errors: &mut Errors,
    ) {
        let message =
            format!("`{key}` belongs to the system: write it outside of the braces of its bodies");
        errors.push(key.span(), message);
        if key == "joints" {
            self.lost.joints = true;
        } else if key == "bodies" {
            self.lost.bodies = true;
        } else if key_meant(&key.to_string()).is_some() && key != "doc" {
            self.keep_misplaced(key, entry, errors);
        }
    }

    fn keep_misplaced(&mut self, key: &Ident, entry: &[TokenTree], errors: &mut Errors) {
        self.misplaced.keys.retain(|other| other != key);
        parse_key(&mut self.misplaced, entry, errors);
    }

    /// Puts what stands in a wrong place where it belongs. A body without mass, inertia or a point
    /// that stands beside it has these, without values.
    pub(super) fn place_misplaced(&mut self) {
        let misplaced = &mut self.misplaced;
        for body in &mut self.bodies {
            let is_composed = body.composition.is_some();
            let lost = |written: &Option<Written>| {
                let is_lost = written.is_some() && !is_composed;
                is_lost.then_some(Written { value: None })
            };
            body.mass = body.mass.take().or_else(|| lost(&misplaced.mass));
            body.inertia = body.inertia.take().or_else(|| lost(&misplaced.inertia));
            for point in &misplaced.points {
                if !body.points.iter().any(|own| own.name == point.name) {
                    body.points.push(Definition {
                        name: point.name.clone(),
                        value: None,
                    });
                }
            }
        }
        let points = misplaced.points.iter().map(|point| point.name.to_string());
        self.top.lost.extend(points.chain(misplaced.lost.drain(..)));
        add(&mut self.top.params, misplaced.params.drain(..));
        add(&mut self.top.inputs, misplaced.inputs.drain(..));
        let known = |name: &Ident| self.top.rates.iter().any(|rate| rate.name == *name);
        misplaced.rates.retain(|rate| !known(&rate.name));
        self.top.rates.append(&mut misplaced.rates);
        let has_rate = |name: &Ident| self.top.rates.iter().any(|rate| rate.name == *name);
        let states = misplaced.states.drain(..);
        let (known, lost): (Vec<_>, Vec<_>) = states.partition(|state| has_rate(&state.name));
        self.top
            .lost
            .extend(lost.iter().map(|state| state.name.to_string()));
        add(&mut self.top.states, known);
        self.top.constants.append(&mut misplaced.constants);
        self.top.functions.append(&mut misplaced.functions);
    }

    /// The key that makes this a single body, described as a system: it belongs to a body, and there
    /// are no bodies and no joints.
    pub(super) fn key_of_lone_body(&self) -> Option<Ident> {
        let is_system = !self.bodies.is_empty()
            || !self.joints.is_empty()
            || self.lost.bodies
            || self.lost.joints
            || self.file.is_some();
        let mut keys = self.misplaced.keys.iter();
        let key = keys.find(|key| OF_ONE_BODY.iter().any(|word| *key == word));
        key.filter(|_| !is_system).cloned()
    }
}

/// Reads a single body that is described as a system, which is reported instead of all errors.
pub fn parse_lone_body(
    system: &System,
    tokens: TokenStream,
    errors: &mut Errors,
) -> Option<Description> {
    let key = system.lone.as_ref()?;
    errors.take_back(0);
    let message = format!(
        "`{key}` belongs to a body: for a single body write `rigid_body!`; the bodies of a system belong in \
         `bodies: [arm {{ .. }}]`"
    );
    errors.push(key.span(), message);
    let mut body = parse_description(tokens, errors)?;
    // a system in space has no motion
    let place = body.name.span();
    body.motion.get_or_insert_with(|| Motion {
        word: Ident::new("spatial", place),
        support: None,
    });
    Some(body)
}

/// Moves declarations whose names are new.
fn add(to: &mut Vec<Declaration>, from: impl IntoIterator<Item = Declaration>) {
    for declaration in from {
        if !to.iter().any(|known| known.name == declaration.name) {
            to.push(declaration);
        }
    }
}
