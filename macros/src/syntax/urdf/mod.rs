//! `urdf: "robot.urdf"`: bodies and joints from a file (the Unified Robot Description Format of ROS).
//!
//! What the file says becomes what could have been written: a description of each link, and a
//! definition of each joint. All numbers keep their digits.

mod decimal;
mod describe;
mod names;
mod robot;
mod tree;
mod xml;

use proc_macro2::{Ident, Span, TokenStream};
use roxmltree::Node;

use crate::errors::{Errors, hint};

use super::expression::{Expression, Kind};
use super::{Definition, Description};
use names::{Names, Refused};
use robot::{Joint, Motion, Robot};
use xml::Reader;

/// What is written beside a file, as far as it matters to it.
#[derive(Clone, Copy)]
pub struct Beside<'a> {
    pub runtime: &'a TokenStream,
    pub bodies: &'a [Description],
    pub joints: &'a [Definition],
    /// Joints of the file that are held at a coordinate.
    pub locked: &'a [Definition],
}

/// What a file describes.
pub struct Described {
    pub bodies: Vec<Description>,
    pub joints: Vec<Definition>,
    pub told: Told,
}

/// What is told of a file.
#[derive(Default)]
pub struct Told {
    /// What is read otherwise than it stands there.
    pub read_as: Vec<String>,
    /// What is not used.
    pub skipped: Vec<String>,
}

/// Characters that a file may have, and links: stated limits instead of minutes of waiting.
const LENGTH: usize = 4_000_000;
const LINKS: usize = 1_000;

/// Reads a text; its name and place are those of the string that names the file.
pub fn read(
    (name, span): (&str, Span),
    text: &str,
    beside: Beside<'_>,
    errors: &mut Errors,
) -> Option<Described> {
    if text.len() > LENGTH {
        errors.push(span, format!("`{name}` has more than {LENGTH} bytes"));
        return None;
    }
    let document = match xml::parse(text) {
        Ok(document) => document,
        Err((line, message)) => {
            errors.push(span, format!("{name}:{line}, no XML: {message}"));
            return None;
        }
    };
    let mut reader = Reader::new(name, text, span, errors);
    let mut names = Names::default();
    let robot = beside.robot(&mut reader, &mut names, document.root_element())?;
    let skipped = reader.skipped;
    if robot.is_lost {
        return None;
    }
    let mut told = tell(name, &robot, names.changed, &skipped);
    let (bodies, joints) = beside.describe(&robot, (name, span), &mut told, errors)?;
    Some(Described {
        bodies,
        joints,
        told,
    })
}

impl Beside<'_> {
    /// `<robot>`
    fn robot(
        self,
        reader: &mut Reader<'_>,
        names: &mut Names,
        root: Node<'_, '_>,
    ) -> Option<Robot> {
        let tag = root.tag_name().name();
        if tag != "robot" {
            return reader.report(
                root,
                "the first element of a file of this kind is `<robot>`",
            );
        }
        let skipped = ["material", "transmission", "gazebo"];
        let children = reader.children(root, &["link", "joint"], &skipped);
        let is = |node: &&Node<'_, '_>, tag: &str| node.tag_name().name() == tag;
        let mut robot = Robot::default();
        for node in children.iter().filter(|node| is(node, "link")) {
            let found = named(reader, *node, |name, span| names.link(name, span));
            if let Some((ident, name)) = found {
                reader.link(*node, ident, name, &mut robot);
            } else {
                robot.is_lost = true;
                robot.lost.extend(node.attribute("name").map(str::to_owned));
            }
        }
        let (mut known, mut has_lost_names) = (Vec::new(), false);
        for node in children.iter().filter(|node| is(node, "joint")) {
            let links: Vec<&Ident> = robot.links.iter().map(|link| &link.ident).collect();
            let found = named(reader, *node, |name, span| names.joint(name, &links, span));
            let Some((ident, name)) = found else {
                has_lost_names = true;
                continue;
            };
            known.push(ident.to_string());
            let locked = self.locked(&ident);
            match reader.joint(*node, (ident, name), locked, &mut robot) {
                Some(joint) => {
                    robot.is_lost |= self.check_locked(&joint, reader.errors).is_none();
                    robot.joints.push(joint);
                }
                None => robot.is_lost = true,
            }
        }
        reader.owner.clear();
        if robot.links.len() > LINKS {
            reader.report::<()>(root, format!("it has more than {LINKS} links"));
            robot.is_lost = true;
        }
        if robot.links.is_empty() && !robot.is_lost {
            reader.report::<()>(root, "it has no `<link>`");
            robot.is_lost = true;
        }
        self.check_all_locked(&known, has_lost_names, reader.errors);
        robot.is_lost |= has_lost_names;
        Some(robot)
    }

    /// The coordinate at which a joint is held.
    fn locked(self, joint: &Ident) -> Option<Expression> {
        let found = self.locked.iter().find(|locked| locked.name == *joint)?;
        let lost = || Expression {
            kind: Kind::Poisoned,
            extent: found.name.span().into(),
        };
        Some(found.value.clone().unwrap_or_else(lost))
    }

    fn check_locked(self, joint: &Joint, errors: &mut Errors) -> Option<()> {
        let mut all = self.locked.iter();
        let Some(locked) = all.find(|locked| locked.name == joint.ident) else {
            return Some(());
        };
        let message = match joint.kind {
            Motion::Turns | Motion::Slides => return Some(()),
            Motion::Fixed => "is fixed in the file: leave it out",
            Motion::Plane | Motion::Free => {
                "has more than one coordinate: only hinges and slides are locked"
            }
        };
        errors.push(locked.name.span(), format!("`{}` {message}", locked.name));
        None
    }

    /// Reports what is locked and no joint, or locked twice.
    fn check_all_locked(self, known: &[String], is_lost: bool, errors: &mut Errors) {
        let mut seen: Vec<&Ident> = Vec::new();
        for name in self.locked.iter().map(|locked| &locked.name) {
            if seen.contains(&name) {
                errors.push(name.span(), format!("`{name}` is locked twice"));
            } else if !known.contains(&name.to_string()) && !is_lost {
                let hint = hint(&name.to_string(), known.iter().map(String::as_str));
                let message = format!("there is no joint `{name}` in the file{hint}");
                errors.push(name.span(), message);
            }
            seen.push(name);
        }
    }
}

/// What is read otherwise than it stands in the file, and what is not used.
fn tell(name: &str, robot: &Robot, changed: Vec<String>, skipped: &[String]) -> Told {
    let mut told = Told {
        read_as: changed,
        skipped: Vec::new(),
    };
    told.read_as
        .extend(robot.notes.right_angles.iter().cloned());
    let joints = |count: usize| {
        let plural = if count == 1 { "" } else { "s" };
        format!("of {count} joint{plural} in {name}")
    };
    if robot.notes.limited > 0 {
        let of = joints(robot.notes.limited);
        told.skipped
            .push(format!("`<limit>` {of}: nothing stops a joint"));
    }
    if robot.notes.damped > 0 {
        let of = joints(robot.notes.damped);
        told.skipped.push(format!(
            "`<dynamics>` {of}: damping and friction are not applied, write them in `drives`"
        ));
    }
    if !skipped.is_empty() {
        let all = skipped.join(">`, `<");
        told.skipped
            .push(format!("`<{all}>` in {name}: no part of the motion"));
    }
    told
}

/// The name of a link or a joint, as it is used here, and as it stands in the file.
fn named<'n>(
    reader: &mut Reader<'_>,
    node: Node<'n, '_>,
    take: impl FnOnce(&str, Span) -> Result<Ident, Refused>,
) -> Option<(Ident, &'n str)> {
    reader.owner.clear();
    let name = reader.attribute(node, "name")?;
    match take(name, reader.span) {
        Ok(ident) => Some((ident, name)),
        Err(Refused::Empty) => reader.report(
            node,
            format!("`{name}` is no name: it has no letter and no digit of ASCII"),
        ),
        Err(Refused::Taken(word)) => {
            let becomes = if word == name {
                String::new()
            } else {
                format!(", as `{name}` is written here,")
            };
            reader.report(node, format!("the name `{word}`{becomes} is taken already"))
        }
    }
}
