//! `urdf: "robot.urdf"`: bodies and joints from a file (the Unified Robot Description Format of
//! ROS).
//!
//! The content of the file becomes a description that a user could have written: each link is a
//! body, and each joint is a definition. All numbers keep their digits.

mod describe;
mod followers;
mod mimic;
mod robot;
mod tree;

use proc_macro2::{Ident, Span};
use roxmltree::Node;

use crate::errors::Errors;

use super::xml::names::Names;
use super::xml::reader::Reader;
use super::xml::{Beside, Described, LINKS, Told, document};
use robot::{Joint, Motion, Robot};

/// Reads a text; `name` and `span` are those of the string that names the file.
pub fn read(
    (name, span): (&str, Span),
    text: &str,
    beside: Beside<'_>,
    errors: &mut Errors,
) -> Option<Described> {
    let document = document((name, span), text, errors)?;
    let mut reader = Reader::new(name, text, span, errors);
    let mut names = Names::default();
    let robot = beside.robot(&mut reader, &mut names, document.root_element())?;
    let skipped = reader.skipped;
    if robot.is_lost {
        return None;
    }
    let mut told = tell(name, &robot, names.changed, &skipped);
    let constraints = robot.followers(span, errors);
    let (bodies, joints) = beside.describe(&robot, (name, span), &mut told, errors)?;
    Some(Described {
        bodies,
        joints,
        constraints,
        told,
        ..Described::default()
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
            let found = reader.named(*node, |name, span| names.link(name, span));
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
            let found = reader.named(*node, |name, span| names.joint(name, &links, span));
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
        robot.is_lost |= has_lost_names || reader.has_lost_names;
        Some(robot)
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
        errors.report(locked.name.span(), format!("`{}` {message}", locked.name))
    }
}

/// Lists what is read differently from the text of the file, and what is not used.
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
