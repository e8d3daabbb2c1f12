//! Sums of joint coordinates, for actuators, tendons and equalities.

use proc_macro2::Ident;
use roxmltree::Node;

use crate::syntax::xml::decimal::Decimal;
use crate::syntax::xml::names::{extended, word};
use crate::syntax::xml::reader::Reader;

use super::body::Body;
use super::joint::{Joint, Motion};

/// A sum of coordinates with factors: `(2) * lift.angle + slip.position`.
#[derive(Clone)]
pub struct Length(pub Vec<Term>);

#[derive(Clone)]
pub struct Term {
    /// The factor of the coordinate, also if it is one: a number has no unit, so its product fits
    /// other coordinates. `None` for a joint alone.
    pub factor: Option<String>,
    pub joint: Ident,
    pub kind: Motion,
    /// The coordinate in the drawn pose, if it is not zero.
    reference: Option<String>,
    /// The coordinate at which springs are at rest, if it is not zero.
    rest: Option<String>,
}

impl Term {
    pub fn new(joint: &Joint, factor: Option<&Decimal>) -> Self {
        Self {
            factor: factor.map(Decimal::literal),
            joint: joint.ident.clone(),
            kind: joint.kind,
            reference: joint.reference.clone(),
            rest: joint.rest.clone(),
        }
    }

    fn of(&self, text: &str) -> String {
        match &self.factor {
            Some(factor) => format!("({factor}) * {text}"),
            None => text.to_owned(),
        }
    }
}

impl Length {
    fn sum(&self, part: impl Fn(&Term) -> Option<String>) -> Option<String> {
        let parts: Vec<String> = self.0.iter().filter_map(part).collect();
        match parts.as_slice() {
            [] => None,
            [one] => Some(one.clone()),
            _ => Some(format!("({})", parts.join(" + "))),
        }
    }

    pub fn text(&self) -> String {
        let text = self.sum(|term| {
            let word = match term.kind {
                Motion::Slide => "position",
                _ => "angle",
            };
            Some(term.of(&format!("{}.{word}", term.joint)))
        });
        text.unwrap_or_default()
    }

    /// Its rate.
    pub fn rate(&self) -> String {
        let text = self.sum(|term| {
            let word = match term.kind {
                Motion::Slide => "velocity",
                _ => "angular_velocity",
            };
            Some(term.of(&format!("{}.{word}", term.joint)))
        });
        text.unwrap_or_default()
    }

    /// The kind of the joint that it is the coordinate of, with its unit; `None` for a sum with
    /// factors, which has any unit.
    pub fn kind(&self) -> Option<Motion> {
        match self.0.as_slice() {
            [one] if one.factor.is_none() => Some(one.kind),
            _ => None,
        }
    }

    /// Its value in the drawn pose, if it is not zero.
    pub fn reference(&self) -> Option<String> {
        self.sum(|term| Some(term.of(&format!("({})", term.reference.as_ref()?))))
    }

    /// Its value where the springs of its joints are at rest, if it is not zero.
    pub fn rest(&self) -> Option<String> {
        self.sum(|term| Some(term.of(&format!("({})", term.rest.as_ref()?))))
    }

    /// Its difference from the drawn pose.
    pub fn change(&self) -> String {
        match self.reference() {
            Some(reference) => format!("({} - {reference})", self.text()),
            None => self.text(),
        }
    }
}

impl Reader<'_> {
    /// A joint by its name in the file.
    pub fn joint_named<'b>(
        &mut self,
        node: Node<'_, '_>,
        name: &str,
        bodies: &'b [Body],
    ) -> Option<&'b Joint> {
        let joints = || bodies.iter().flat_map(|body| &body.joints);
        let ident = word(name).unwrap_or_default();
        let alias = extended(&ident, "joint");
        let found = joints().find(|joint| joint.ident == ident.as_str());
        let found = found.or(joints().find(|joint| joint.ident == alias.as_str()));
        let Some(joint) = found else {
            let all: Vec<String> = joints().map(|joint| joint.ident.to_string()).collect();
            return self.no_such(node, ("joint", name), all.iter().map(String::as_str));
        };
        if !matches!(joint.kind, Motion::Hinge | Motion::Slide) {
            let message =
                format!("`{name}` has several coordinates: write what acts on them in `drives`");
            return self.report(node, message);
        }
        Some(joint)
    }

    /// Reports joints of which some are locked and some are not. `None` if all are locked.
    pub fn check_free(&mut self, node: Node<'_, '_>, joints: &[&Joint]) -> Option<()> {
        let held = joints.iter().find(|joint| joint.is_held());
        let Some(held) = held else { return Some(()) };
        if joints.iter().all(|joint| joint.is_held()) {
            return None;
        }
        let message = format!(
            "`{}` is locked, and what moves with it is not: lock that, too",
            held.ident
        );
        self.report(node, message)
    }
}
