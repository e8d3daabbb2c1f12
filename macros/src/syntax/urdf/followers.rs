//! Joints that follow others, written as constraints.

use proc_macro2::Span;

use crate::errors::{Errors, hint};
use crate::syntax::Definition;
use crate::syntax::xml::written::{filled, name, written};

use super::mimic::Mimic;
use super::robot::{Joint, Motion, Robot};

impl Robot {
    /// The constraints of all followers, such as `b_mimic = b.angle - (2 * a.angle + 0.1)`.
    pub fn followers(&self, span: Span, errors: &mut Errors) -> Vec<Definition> {
        let joints = self.joints.iter().filter(|joint| joint.locked.is_none());
        let followers = joints.filter_map(|joint| Some((joint, joint.mimic.as_ref()?)));
        let all = followers.filter_map(|(joint, mimic)| self.follower(joint, mimic, span, errors));
        all.collect()
    }

    fn follower(
        &self,
        joint: &Joint,
        mimic: &Mimic,
        span: Span,
        errors: &mut Errors,
    ) -> Option<Definition> {
        let mut report = |message: String| {
            errors.push(mimic.extent, message);
            None
        };
        let Some(own) = coordinate(joint) else {
            return report("a joint of several coordinates follows no other".to_owned());
        };
        let mut joints = self.joints.iter();
        let leader = match joints.find(|other| other.name == mimic.leader) {
            Some(leader) if leader.name == joint.name => {
                return report("a joint does not follow itself".to_owned());
            }
            Some(leader) => leader,
            None => {
                let names = self.joints.iter().map(|joint| joint.name.as_str());
                let hint = hint(&mimic.leader, names);
                return report(format!("there is no joint `{}`{hint}", mimic.leader));
            }
        };
        let Some(other) = coordinate(leader) else {
            let name = &mimic.leader;
            return report(format!("`{name}` has no coordinate, or has several"));
        };
        // the coordinate of a locked joint is known
        let other = match leader.locked {
            Some(_) => "_".to_owned(),
            None => format!("{}.{other}", leader.ident),
        };
        let (multiplier, offset) = (mimic.multiplier.literal(), mimic.offset.literal());
        let led = match multiplier.as_str() {
            // without a factor, the coordinate keeps its unit
            "1" if joint.kind == leader.kind => other,
            factor => format!("({factor}) * {other}"),
        };
        let led = if mimic.offset.is_zero() {
            led
        } else {
            format!("({led} + ({offset}))")
        };
        let text = format!("{}.{own} - {led}", joint.ident);
        let value = written(&text, mimic.extent, span, errors)?;
        Some(Definition {
            name: name(&format!("{}_mimic", joint.ident), span),
            value: Some(match &leader.locked {
                Some(locked) => filled(value, locked),
                None => value,
            }),
        })
    }
}

/// The single coordinate of a joint.
fn coordinate(joint: &Joint) -> Option<&'static str> {
    match joint.kind {
        Motion::Turns => Some("angle"),
        Motion::Slides => Some("position"),
        _ => None,
    }
}
