//! `<actuator>`: motors, and linear springs and dampers that act towards an input.

use proc_macro2::Ident;
use roxmltree::Node;

use crate::errors::Extent;
use crate::syntax::Declaration;
use crate::syntax::xml::decimal::Decimal;
use crate::syntax::xml::reader::Reader;
use crate::syntax::xml::written::unit;

use super::body::Body;
use super::classes::{Classes, Element, Law};
use super::describe::Writer;
use super::joint::Motion;
use super::length::{Length, Term};
use super::tendon::Tendon;

/// An input, and a force along a length: its gain times the input, plus its bias.
pub struct Actuator {
    pub name: String,
    length: Length,
    gear: Decimal,
    law: Law,
    /// The unit of its input; `None` if that is unknown.
    unit: Option<&'static str>,
    /// Whether its input has the unit of the force.
    is_force: bool,
    extent: Extent,
}

pub const KNOWN: [&str; 10] = [
    "name",
    "class",
    "joint",
    "jointinparent",
    "tendon",
    "gear",
    "group",
    "armature",
    "damping",
    "delay",
];
/// Attributes that do not affect the motion, since limits are not modeled.
pub const SKIPPED: [&str; 14] = [
    "ctrllimited",
    "ctrlrange",
    "forcelimited",
    "forcerange",
    "actlimited",
    "actrange",
    "lengthrange",
    "inheritrange",
    "user",
    "nsample",
    "actdim",
    "actearly",
    "cranklength",
    "interp",
];
/// The supported kinds, with their attributes.
pub const KINDS: [(&str, &[&str]); 5] = [
    ("motor", &[]),
    ("position", &["kp", "kv", "dampratio", "timeconst"]),
    ("velocity", &["kv"]),
    ("damper", &["kv"]),
    (
        "general",
        &[
            "gaintype", "gainprm", "biastype", "biasprm", "dyntype", "dynprm",
        ],
    ),
];
/// The tags of all kinds.
pub const ACTUATORS: [&str; 13] = [
    "motor",
    "position",
    "velocity",
    "damper",
    "general",
    "intvelocity",
    "orientation",
    "pid",
    "cylinder",
    "muscle",
    "adhesion",
    "dcmotor",
    "plugin",
];

impl Reader<'_> {
    pub fn actuators(
        &mut self,
        node: Node<'_, '_>,
        classes: &Classes,
        (bodies, tendons): (&[Body], &[Tendon]),
        found: &mut Vec<Actuator>,
    ) {
        for child in node.children().filter(Node::is_element) {
            let tag = child.tag_name().name();
            let Some((_, own)) = KINDS.iter().find(|(kind, _)| *kind == tag) else {
                let all = KINDS.map(|(kind, _)| format!("`<{kind}>`")).join(", ");
                let message = format!(
                    "only {all} are read: write what `{tag}` does in `drives`, and leave it out"
                );
                self.report::<()>(child, message);
                continue;
            };
            let number = found.len() + 1;
            let (element, steps) = classes.actuator(child, self);
            self.check_names(&element, &[&KNOWN, &SKIPPED, own]);
            let law = self.law(child, &steps);
            found.extend(self.actuator(&element, law, number, (bodies, tendons)));
        }
    }

    fn actuator(
        &mut self,
        element: &Element<'_, '_>,
        law: Option<Law>,
        number: usize,
        (bodies, tendons): (&[Body], &[Tendon]),
    ) -> Option<Actuator> {
        let node = element.node;
        let late = "inputs that act later are not read: give the input at the time when it acts";
        let added = "what an actuator adds to its joint is not read: write it at the joint";
        self.refuse(
            element,
            &[
                ("delay", &["0"], late),
                ("armature", &["0"], added),
                ("damping", &["0"], added),
            ],
        );
        let joint = element.get("joint").or(element.get("jointinparent"));
        let length = match (joint, element.get("tendon")) {
            (Some(name), None) => {
                let joint = self.joint_named(node, name, bodies)?;
                if joint.is_held() {
                    return None;
                }
                Length(vec![Term::new(joint, None)])
            }
            (None, Some(name)) => self.tendon_named(node, name, tendons)?.length.clone(),
            _ => {
                let message = "an actuator is at a joint or a tendon: it has no attribute `joint`";
                return self.report(node, message);
            }
        };
        let tag = node.tag_name().name();
        let gear = self
            .list(element, "gear", 1..=6, "1 0 0 0 0 0")
            .into_iter()
            .next()?;
        let slides = length.0.iter().any(|term| term.kind == Motion::Slide) || length.0.len() > 1;
        let given = node.attribute("name");
        Some(Actuator {
            name: given.map_or_else(|| format!("{tag}_{number}"), str::to_owned),
            unit: match (tag, slides) {
                ("motor", false) => Some("0[N * m]"),
                ("motor", true) => Some("0[N]"),
                ("position", true) if length.0.len() == 1 => Some("0[m]"),
                ("velocity", true) if length.0.len() == 1 => Some("0[m / s]"),
                ("velocity", false) => Some("0[rad / s]"),
                _ => None,
            },
            is_force: tag == "motor",
            length,
            gear,
            law: law?,
            extent: self.at(node),
        })
    }
}

impl Writer<'_> {
    /// The input of an actuator, and its drives.
    pub fn actuator(&mut self, actuator: &Actuator, input: &Ident) {
        let extent = actuator.extent;
        let text = actuator.unit;
        let unit = text.and_then(|text| unit(text, extent, self.span, self.errors));
        self.described.inputs.push(Declaration {
            name: input.clone(),
            unit,
            value: None,
            moving: None,
            order: 0,
        });
        let force = actuator.force(input);
        self.along(&input.to_string(), &force, &actuator.length, extent);
    }
}

impl Actuator {
    /// The force along the length, times the gear.
    fn force(&self, input: &Ident) -> String {
        let gear = self.gear.literal();
        let geared = |text: String| match gear.as_str() {
            "1" => text,
            gear => format!("({gear}) * {text}"),
        };
        let variables = [
            None,
            Some(geared(self.length.text())),
            Some(geared(self.length.rate())),
        ];
        let sum = |factors: &[Decimal; 3]| {
            let terms = factors.iter().zip(&variables);
            let terms = terms.filter(|(factor, _)| !factor.is_zero());
            let terms = terms.map(|(factor, variable)| match variable {
                Some(variable) => format!("({}) * {variable}", factor.literal()),
                None => factor.literal(),
            });
            terms.collect::<Vec<String>>()
        };
        let (gain, bias) = self.law.terms();
        let gain = match sum(&gain).as_slice() {
            [] => "0".to_owned(),
            terms => terms.join(" + "),
        };
        let mut terms = sum(&bias);
        // without a factor, the input keeps its unit
        let given = match gain.as_str() {
            "1" if self.is_force => input.to_string(),
            gain => format!("({gain}) * {input}"),
        };
        terms.insert(0, given);
        match terms.as_slice() {
            [one] if one == &input.to_string() && gear == "1" => one.clone(),
            all if gear == "1" => format!("({})", all.join(" + ")),
            all => format!("(({gear}) * ({}))", all.join(" + ")),
        }
    }
}
