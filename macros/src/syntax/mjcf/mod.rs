//! `mjcf: "model.xml"`: bodies, joints, motors and gravity from a file (the format of `MuJoCo`).
//!
//! The content of the file becomes a description that a user could have written. Each body with
//! mass is a body composed of parts. Each body without mass is a frame, and so is each place
//! between two joints of one body. Each joint is a definition. All numbers keep their digits.

mod actuator;
mod body;
mod classes;
mod coupling;
mod describe;
mod equality;
mod geom;
mod joint;
mod length;
mod place;
mod settings;
mod tendon;

use proc_macro2::Span;
use roxmltree::Node;

use crate::errors::{Errors, Extent};

use super::xml::names::Names;
use super::xml::reader::Reader;
use super::xml::{Beside, Described, document};
use actuator::{ACTUATORS, Actuator, KINDS};
use body::{Body, Reading, massive, poses};
use classes::{Classes, Tags};
use coupling::Coupling;
use describe::Writer;
use equality::{Closing, EQUALITY};
use place::tuple;
use settings::Settings;
use tendon::Tendon;

const KNOWN: [&str; 7] = [
    "compiler",
    "option",
    "default",
    "worldbody",
    "actuator",
    "equality",
    "tendon",
];
const SKIPPED: [&str; 9] = [
    "contact",
    "sensor",
    "asset",
    "visual",
    "statistic",
    "size",
    "keyframe",
    "custom",
    "extension",
];

/// Reads a `<default>`, with the attributes that each of its elements may have.
fn read_classes(node: Node<'_, '_>, classes: &mut Classes, reader: &mut Reader<'_>) {
    let geom: [&[&str]; 3] = [&geom::GEOM, &geom::LOOKS, &place::PLACE];
    let joint: [&[&str]; 2] = [&joint::KNOWN, &joint::SKIPPED];
    let tendon: [&[&str]; 3] = [&tendon::KNOWN, &tendon::SKIPPED, &["width", "material"]];
    let equality: [&[&str]; 1] = [&EQUALITY];
    let kinds = KINDS.map(|(_, own)| [&actuator::KNOWN[..], &actuator::SKIPPED, own]);
    let mut known: Vec<(&str, &[&[&str]])> = vec![
        ("geom", &geom),
        ("joint", &joint),
        ("tendon", &tendon),
        ("equality", &equality),
    ];
    let tags = KINDS.iter().zip(&kinds);
    known.extend(tags.map(|((tag, _), names)| (*tag, &names[..])));
    let tags = Tags {
        known: &known,
        actuators: &ACTUATORS,
    };
    classes.read(node, &tags, reader);
}

/// The content of a file.
struct Model {
    bodies: Vec<Body>,
    tendons: Vec<Tendon>,
    actuators: Vec<Actuator>,
    closings: Vec<Closing>,
    couplings: Vec<Coupling>,
    settings: Settings,
    /// The place of the first element.
    extent: Extent,
}

/// Reads a text; `name` and `span` are those of the string that names the file.
pub fn read(
    (name, span): (&str, Span),
    text: &str,
    beside: Beside<'_>,
    errors: &mut Errors,
) -> Option<Described> {
    let before = errors.count();
    let document = document((name, span), text, errors)?;
    let mut reader = Reader::new(name, text, span, errors);
    let mut names = Names::default();
    let model = beside.model(&mut reader, &mut names, document.root_element())?;
    if reader.errors.count() > before {
        return None;
    }
    let mut described = model.describe(beside, &mut reader, &mut names);
    if reader.errors.count() > before {
        return None;
    }
    described.told.read_as.extend(names.changed);
    if !reader.skipped.is_empty() {
        let all = reader.skipped.join(">`, `<");
        let skipped = format!("`<{all}>` in {name}: no part of the motion, or not in this version");
        described.told.skipped.push(skipped);
    }
    Some(described)
}

impl Beside<'_> {
    /// `<mujoco>`
    fn model(
        self,
        reader: &mut Reader<'_>,
        names: &mut Names,
        root: Node<'_, '_>,
    ) -> Option<Model> {
        if root.tag_name().name() != "mujoco" {
            let message = "the first element of a file of this kind is `<mujoco>`";
            return reader.report(root, message);
        }
        let sections = reader.parts(root, &KNOWN, &SKIPPED);
        let of = |tag: &'static str| {
            let all = sections.iter();
            all.filter(move |node| node.tag_name().name() == tag)
                .copied()
        };
        let (mut settings, mut classes) = (Settings::default(), Classes::default());
        of("compiler").for_each(|node| reader.compiler(node, &mut settings));
        of("option").for_each(|node| reader.option(node, &mut settings));
        of("default").for_each(|node| read_classes(node, &mut classes, reader));
        let mut reading = Reading {
            beside: self,
            classes: &classes,
            settings: &settings,
            names,
            idents: Vec::new(),
            bodies: Vec::new(),
        };
        of("worldbody").for_each(|node| reading.world(node, reader));
        let bodies = reading.bodies;
        if bodies.is_empty() && reader.has_lost_names {
            return None;
        }
        if bodies.is_empty() {
            return reader.report(root, "it has no `<body>`");
        }
        let (mut tendons, mut actuators) = (Vec::new(), Vec::new());
        of("tendon").for_each(|node| reader.tendons(node, &classes, &bodies, &mut tendons));
        let known = (&bodies[..], &tendons[..]);
        of("actuator").for_each(|node| reader.actuators(node, &classes, known, &mut actuators));
        let mut couplings = Vec::new();
        of("equality").for_each(|node| reader.couplings(node, &classes, known, &mut couplings));
        let (poses, mut closings) = (poses(&bodies), Vec::new());
        let drawn = (&bodies[..], &poses[..]);
        of("equality").for_each(|node| reader.closings(node, &classes, drawn, &mut closings));
        // after an error, bodies may lack mass only because their mass properties could not be read
        if reader.errors.is_empty() {
            self.check(&bodies, reader.errors);
        }
        let extent = reader.at(root);
        Some(Model {
            bodies,
            tendons,
            actuators,
            closings,
            couplings,
            settings,
            extent,
        })
    }

    /// Checks that moving bodies have mass, and that locked joints can be locked.
    fn check(self, bodies: &[Body], errors: &mut Errors) {
        let massive = massive(bodies, self);
        let moves = |body: &Body| body.joints.iter().any(|joint| !joint.is_held());
        let idle = bodies
            .iter()
            .zip(massive)
            .filter(|(body, has_mass)| moves(body) && !has_mass);
        for (body, _) in idle {
            let message =
                "it moves, and neither it nor what it carries has mass: write its `<inertial>`";
            errors.push(body.extent, message);
        }
        let joints = || bodies.iter().flat_map(|body| &body.joints);
        let known: Vec<String> = joints().map(|joint| joint.ident.to_string()).collect();
        self.check_all_locked(&known, false, errors);
        let many = joints().filter(|joint| joint.is_held() && joint.has_several());
        for joint in many {
            let found = self.locked.iter().find(|locked| locked.name == joint.ident);
            let message = "has more than one coordinate: only hinges and slides are locked";
            if let Some(locked) = found {
                errors.push(locked.name.span(), format!("`{}` {message}", locked.name));
            }
        }
    }
}

impl Model {
    fn describe(self, beside: Beside<'_>, reader: &mut Reader<'_>, names: &mut Names) -> Described {
        let span = reader.span;
        let mut writer = Writer {
            span,
            runtime: beside.runtime,
            errors: reader.errors,
            described: Described::default(),
        };
        let mut numbers: Vec<usize> = Vec::new();
        for body in &self.bodies {
            let parent = body.parent.map(|parent| numbers[parent]);
            let number = writer.body(body, parent, names);
            numbers.push(number);
        }
        let mut fresh = |word: &str| names.fresh(word, "closing", span);
        writer.close(&self.closings, &numbers, &mut fresh);
        for coupling in &self.couplings {
            let word = names.fresh(&coupling.name, "coupling", span);
            writer.couple(coupling, &word);
        }
        for tendon in &self.tendons {
            let word = names.fresh(&tendon.name, "tendon", span);
            writer.tendon(tendon, &word);
        }
        for actuator in &self.actuators {
            let input = names.fresh(&actuator.name, "motor", span);
            writer.actuator(actuator, &input);
        }
        if self.settings.has_gravity {
            let text = self.settings.gravity.as_ref();
            let text = text.map_or("(0, 0, -9.81)".to_owned(), |gravity| tuple(gravity));
            writer.gravity(&text, beside, self.extent);
        }
        writer.described
    }
}
