//! `<actuator>`: motors, each an input and a drive.

use proc_macro2::Ident;
use roxmltree::Node;

use crate::errors::{Extent, hint};
use crate::syntax::Declaration;
use crate::syntax::xml::decimal::Decimal;
use crate::syntax::xml::reader::Reader;

use super::body::Body;
use super::describe::Writer;
use super::element::Classes;
use super::joint::{Joint, Motion};
use super::written::{definition, name, unit};

/// A motor at a joint.
pub struct Motor {
    pub name: String,
    joint: Ident,
    gear: String,
    kind: Motion,
    extent: Extent,
}

const KNOWN: [&str; 6] = ["name", "class", "joint", "jointinparent", "gear", "group"];
/// What says nothing of the motion without limits.
const SKIPPED: [&str; 9] = [
    "ctrllimited",
    "ctrlrange",
    "forcelimited",
    "forcerange",
    "actlimited",
    "actrange",
    "lengthrange",
    "user",
    "nsample",
];

impl Reader<'_> {
    pub fn motors(&mut self, node: Node<'_, '_>, classes: &Classes, bodies: &[Body]) -> Vec<Motor> {
        let mut found = Vec::new();
        for child in node.children().filter(Node::is_element) {
            let tag = child.tag_name().name();
            if tag != "motor" {
                let message = format!(
                    "only `<motor>` is read: write what `{tag}` does in `drives`, and leave it out"
                );
                self.report::<()>(child, message);
                continue;
            }
            found.extend(self.motor(child, found.len(), classes, bodies));
        }
        found
    }

    fn motor(
        &mut self,
        node: Node<'_, '_>,
        number: usize,
        classes: &Classes,
        bodies: &[Body],
    ) -> Option<Motor> {
        let element = classes.of(node, None, self);
        self.check_names(&element, &[&KNOWN, &SKIPPED]);
        let Some(word) = element.get("joint").or(element.get("jointinparent")) else {
            return self.report(node, "a motor is at a joint: it has no attribute `joint`");
        };
        let joints = || bodies.iter().flat_map(|body| &body.joints);
        let ident = crate::syntax::xml::names::word(word).unwrap_or_default();
        let alias = format!("{ident}_joint");
        let found = joints().find(|joint| joint.ident == ident.as_str());
        let found = found.or(joints().find(|joint| joint.ident == alias.as_str()));
        let Some(joint) = found else {
            let all: Vec<String> = joints().map(|joint| joint.ident.to_string()).collect();
            let hint = hint(word, all.iter().map(String::as_str));
            return self.report(node, format!("there is no joint `{word}`{hint}"));
        };
        if joint.is_held() {
            return None;
        }
        if !matches!(joint.kind, Motion::Hinge | Motion::Slide) {
            let message = format!("`{word}` has several coordinates: write its motor in `drives`");
            return self.report(node, message);
        }
        let gear = self.list(&element, "gear", 1..=6, "1 0 0 0 0 0");
        let Joint { ident, kind, .. } = joint;
        let given = node.attribute("name");
        Some(Motor {
            name: given.map_or_else(|| format!("motor_{}", number + 1), str::to_owned),
            joint: ident.clone(),
            gear: gear.first().map_or("1".to_owned(), Decimal::literal),
            kind: *kind,
            extent: self.at(node),
        })
    }
}

impl Writer<'_> {
    /// The input of a motor, and its drive.
    pub fn motor(&mut self, motor: &Motor, input: &Ident) {
        let (joint, gear, extent) = (&motor.joint, &motor.gear, motor.extent);
        let dimension = if motor.kind == Motion::Hinge {
            "0[N * m]"
        } else {
            "0[N]"
        };
        let unit = unit(dimension, extent, self.span, self.errors);
        self.described.inputs.push(Declaration {
            name: input.clone(),
            unit,
            value: None,
            moving: None,
            order: 0,
        });
        let drive = name(&format!("{input}_on_{joint}"), self.span);
        let force = if gear == "1" {
            format!("{input}")
        } else {
            format!("({gear} * {input})")
        };
        let drive = definition(drive, &format!("{force}.on({joint})"), extent, self.errors);
        self.described.drives.push(drive);
    }
}
