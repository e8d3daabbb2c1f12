//! Joints of a file: their kinds, and the loads along them.

use proc_macro2::Ident;
use roxmltree::Node;

use crate::errors::{Extent, hint_of_joint};
use crate::syntax::expression::Expression;
use crate::syntax::xml::decimal::Decimal;
use crate::syntax::xml::reader::Reader;

use super::classes::{Classes, Element};
use super::settings::Settings;

/// The kind of a joint.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Motion {
    Hinge,
    Slide,
    Ball,
    Free,
}

pub struct Joint {
    pub ident: Ident,
    pub kind: Motion,
    /// Its place, in the axes of the body, from the body's origin.
    pub place: [Decimal; 3],
    pub axis: [Decimal; 3],
    /// The coordinate in the drawn pose, if it is not zero.
    pub reference: Option<String>,
    /// The coordinate at which springs are at rest, if it is not zero.
    pub rest: Option<String>,
    pub damping: Option<String>,
    pub armature: Option<String>,
    pub stiffness: Option<String>,
    pub locked: Option<Expression>,
    pub extent: Extent,
}

const MOTIONS: [(&str, Motion); 4] = [
    ("hinge", Motion::Hinge),
    ("slide", Motion::Slide),
    ("ball", Motion::Ball),
    ("free", Motion::Free),
];
pub const KNOWN: [&str; 11] = [
    "name",
    "class",
    "type",
    "pos",
    "axis",
    "ref",
    "damping",
    "stiffness",
    "springref",
    "armature",
    "frictionloss",
];
/// Attributes that do not affect the motion, since limits are not modeled.
pub const SKIPPED: [&str; 13] = [
    "springdamper",
    "solreflimit",
    "solimplimit",
    "solreffriction",
    "solimpfriction",
    "limited",
    "range",
    "actuatorfrclimited",
    "actuatorfrcrange",
    "actuatorgravcomp",
    "margin",
    "group",
    "user",
];
const ARMATURE: &str = "an armature of several coordinates is not read: set it to 0, or give the rotor a body of its own";

impl Joint {
    /// Whether it holds its body rigidly.
    pub fn is_held(&self) -> bool {
        self.locked.is_some()
    }

    /// Whether it has more than one coordinate.
    pub fn has_several(&self) -> bool {
        matches!(self.kind, Motion::Ball | Motion::Free)
    }
}

impl Reader<'_> {
    pub fn jointed(
        &mut self,
        node: Node<'_, '_>,
        ident: Ident,
        locked: Option<Expression>,
        (classes, class): (&Classes, Option<&str>),
        settings: &Settings,
    ) -> Option<Joint> {
        let element = classes.of(node, class, self);
        let kind = if node.tag_name().name() == "freejoint" {
            self.check_names(&element, &[&["name", "class", "group", "align"]]);
            Motion::Free
        } else {
            self.check_names(&element, &[&KNOWN, &SKIPPED]);
            self.motion(&element)?
        };
        self.refuse_loads(&element, kind);
        let axis = self.triple(&element, "axis", "0 0 1");
        if matches!(kind, Motion::Hinge | Motion::Slide) {
            self.has_direction(&element, "axis", &axis);
        }
        let place = self.triple(&element, "pos", "0 0 0");
        let mut coordinate = |name: &str| {
            let value = self.single(&element, name, "0");
            match kind {
                Motion::Hinge => settings.angle(&value).map(|(text, _)| text),
                Motion::Slide => (!value.is_zero()).then(|| value.literal()),
                Motion::Ball | Motion::Free => None,
            }
        };
        let (reference, rest) = (coordinate("ref"), coordinate("springref"));
        let mut given = |name: &str| self.nonzero(&element, name);
        let (damping, stiffness) = (given("damping"), given("stiffness"));
        let armature = given("armature");
        Some(Joint {
            ident,
            kind,
            place,
            axis,
            reference,
            damping,
            armature,
            stiffness,
            rest,
            locked,
            extent: self.at(node),
        })
    }

    /// Reports loads along a joint that cannot be described.
    fn refuse_loads(&mut self, element: &Element<'_, '_>, kind: Motion) {
        let nothing = &["0"];
        let friction = "dry friction is not read: set it to 0, and write it in `drives`";
        let timed = "springs that are given by times are not read: write `stiffness` and `damping`";
        self.refuse(
            element,
            &[
                ("frictionloss", nothing, friction),
                ("springdamper", nothing, timed),
            ],
        );
        if kind == Motion::Ball || kind == Motion::Free {
            let why = "a spring of a joint of several coordinates is not read: set it to 0";
            self.refuse(
                element,
                &[("stiffness", nothing, why), ("armature", nothing, ARMATURE)],
            );
        }
        if kind == Motion::Free {
            let why = "damping of a free body is not read: set it to 0, and write it in `forces`";
            self.refuse(element, &[("damping", nothing, why)]);
        }
    }

    fn motion(&mut self, element: &Element<'_, '_>) -> Option<Motion> {
        let word = element.get("type").unwrap_or("hinge");
        let found = MOTIONS.iter().find(|(known, _)| *known == word);
        if found.is_none() {
            let all = MOTIONS.map(|(known, _)| known);
            let (hint, all) = (hint_of_joint(word, &all), all.join("`, `"));
            let message = format!("`type` is one of `{all}`, and this is `{word}`{hint}");
            self.report::<()>(element.node, message);
        }
        found.map(|(_, motion)| *motion)
    }
}
