//! `<actuator>`: motors, and linear springs and dampers that act towards an input.

use proc_macro2::Ident;
use roxmltree::Node;

use crate::errors::Extent;
use crate::syntax::Declaration;
use crate::syntax::xml::decimal::Decimal;
use crate::syntax::xml::reader::Reader;
use crate::syntax::xml::written::unit;

use super::body::Body;
use super::describe::Writer;
use super::element::{Classes, Element};
use super::joint::Motion;
use super::length::{Length, Term};
use super::tendon::Tendon;

/// An input u, and a force along a length: `(g0 + g1 length + g2 rate) u + b0 + b1 length + b2
/// rate`.
pub struct Actuator {
    pub name: String,
    length: Length,
    gear: Decimal,
    gain: [Decimal; 3],
    bias: [Decimal; 3],
    /// The unit of its input; `None` if that is unknown.
    unit: Option<&'static str>,
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
            let element = classes.of(child, None, self);
            self.check_names(&element, &[&KNOWN, &SKIPPED, own]);
            self.check_classes(child, classes);
            found.extend(self.actuator(&element, number, (bodies, tendons)));
        }
    }

    /// In `MuJoCo`, all actuators share one set of defaults. So what a class says of another kind
    /// counts too, except for what an actuator says itself: a motor and a damper say all that they
    /// do.
    fn check_classes(&mut self, node: Node<'_, '_>, classes: &Classes) {
        let tag = node.tag_name().name();
        let says = |all: &[&str]| all.iter().all(|name| node.has_attribute(*name));
        let says_all = match tag {
            "motor" | "damper" => true,
            "position" => says(&["kp", "kv"]),
            "velocity" => says(&["kv"]),
            _ => false,
        };
        for kind in ACTUATORS.iter().filter(|kind| **kind != tag) {
            let Some(all) = classes.given(node, kind) else {
                continue;
            };
            let law = KINDS.iter().find(|(known, _)| known == kind);
            let has_law = match law {
                // a motor leaves gains as they are by default
                Some((_, law)) if tag != "general" || *kind == "motor" => {
                    law.iter().any(|name| all.contains(name))
                }
                _ => true,
            };
            let shared = ["gear", "armature", "damping", "delay"];
            let mut shared = shared.iter().filter(|name| all.contains(name));
            if has_law && !says_all {
                let message = format!(
                    "its class sets attributes of `<{kind}>`, which `MuJoCo` applies to all actuators: give it another class"
                );
                self.report::<()>(node, message);
            } else if let Some(word) = shared.find(|name| !node.has_attribute(**name)) {
                let message = format!(
                    "its class sets `{word}` of `<{kind}>`, which `MuJoCo` applies to all actuators: write it here"
                );
                self.report::<()>(node, message);
            }
        }
    }

    fn actuator(
        &mut self,
        element: &Element<'_, '_>,
        number: usize,
        (bodies, tendons): (&[Body], &[Tendon]),
    ) -> Option<Actuator> {
        let node = element.node;
        let slow = "actuators with a state of their own are not read";
        let relative = "damping by a ratio is not read: write `kv`";
        let late = "inputs that act later are not read: give the input at the time when it acts";
        let added = "what an actuator adds to its joint is not read: write it at the joint";
        self.refuse(
            element,
            &[
                ("dyntype", &["none"], slow),
                ("timeconst", &["0"], slow),
                ("dampratio", &["0"], relative),
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
        let (gain, bias) = self.law(element, tag)?;
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
            length,
            gear,
            gain,
            bias,
            extent: self.at(node),
        })
    }

    /// Gain and bias of an actuator of a kind.
    fn law(
        &mut self,
        element: &Element<'_, '_>,
        tag: &str,
    ) -> Option<([Decimal; 3], [Decimal; 3])> {
        let extent = self.at(element.node);
        let (zero, one) = (|| Decimal::zero(extent), Decimal::one(extent));
        let none = || [zero(), zero(), zero()];
        Some(match tag {
            "position" => {
                let stiffness = self.single(element, "kp", "1");
                let damping = self.single(element, "kv", "0");
                let bias = [zero(), stiffness.negated(), damping.negated()];
                ([stiffness, zero(), zero()], bias)
            }
            "velocity" => {
                let damping = self.single(element, "kv", "1");
                let bias = [zero(), zero(), damping.negated()];
                ([damping, zero(), zero()], bias)
            }
            "damper" => {
                if !element.has("kv") {
                    return self.report(element.node, "it has no attribute `kv`");
                }
                let damping = self.single(element, "kv", "1");
                ([zero(), zero(), damping.negated()], none())
            }
            "general" => (
                self.terms(element, ("gaintype", "fixed", "gainprm"), "1 0 0")?,
                self.terms(element, ("biastype", "none", "biasprm"), "0 0 0")?,
            ),
            _ => ([one, zero(), zero()], none()),
        })
    }

    /// The parameters of a gain or a bias. If it is not affine, only those that count.
    fn terms(
        &mut self,
        element: &Element<'_, '_>,
        (kind, simple, numbers): (&str, &str, &str),
        default: &str,
    ) -> Option<[Decimal; 3]> {
        let word = element.get(kind).unwrap_or(simple).to_owned();
        if word != simple && word != "affine" {
            let message =
                format!("`{kind}`: `{simple}` and `affine` are read, and this is `{word}`");
            return self.report(element.node, message);
        }
        let extent = self.at(element.node);
        let given = self.list(element, numbers, 1..=10, default);
        let count = match (word.as_str(), simple) {
            ("affine", _) => 3,
            (_, "fixed") => 1,
            _ => 0,
        };
        let mut given = given.into_iter().take(count);
        let mut next = || given.next().unwrap_or(Decimal::zero(extent));
        Some([next(), next(), next()])
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
        let (gain, mut terms) = (sum(&self.gain), sum(&self.bias));
        match gain.as_slice() {
            [] => {}
            [one] if one == "1" => terms.insert(0, input.to_string()),
            _ => terms.insert(0, format!("({}) * {input}", gain.join(" + "))),
        }
        match terms.as_slice() {
            [] => "0".to_owned(),
            [one] if one == &input.to_string() && gear == "1" => one.clone(),
            all if gear == "1" => format!("({})", all.join(" + ")),
            all => format!("(({gear}) * ({}))", all.join(" + ")),
        }
    }
}
