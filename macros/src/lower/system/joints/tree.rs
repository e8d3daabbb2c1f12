//! Checks that the joints form a tree: each body is carried once, and all are carried by the
//! ground, directly or indirectly.

use proc_macro2::Ident;

use crate::errors::Errors;
use crate::lower::expressions::short;
use crate::model::Holds;
use crate::syntax::call;

use super::joint::ReadJoint;
use crate::lower::system::reading::reader::Reader;

impl Reader<'_> {
    /// The joints in an order in which each carrier precedes what it carries, and the joints that
    /// close loops. The first joint written for a body carries it.
    pub fn tree(
        &self,
        joints: &[Option<ReadJoint>],
        errors: &mut Errors,
    ) -> (Vec<usize>, Vec<usize>) {
        let bodies = &self.system.bodies;
        let is_lost = self.system.lost.joints || self.system.lost.bodies;
        let mut is_sound = joints.iter().all(Option::is_some) && !is_lost;
        let (carried_by, mut closing) = self.carriers(joints, &mut is_sound, errors);
        // a joint with an error may have been meant to carry the body
        if is_sound {
            for (body, _) in bodies
                .iter()
                .zip(&carried_by)
                .filter(|(_, by)| by.is_none())
            {
                is_sound = false;
                let name = &body.name;
                if self.check_order(name, joints, errors).is_none() {
                    // what seems to close a loop is meant to carry this body
                    closing.clear();
                    continue;
                }
                errors.push(
                    name.span(),
                    format!("nothing carries `{name}`: write a joint of it, such as `orbit = free({name})`"),
                );
            }
        }
        let (order, placed) = in_order(joints, &carried_by);
        if let Some(body) = placed
            .iter()
            .position(|placed| !placed)
            .filter(|_| is_sound)
        {
            let name = &bodies[body].name;
            let joint = carried_by[body].and_then(|index| joints[index].as_ref());
            let place = joint.map_or(name.span(), |joint| joint.name.span());
            errors.push(
                place,
                format!(
                    "the joints run in a circle, and nothing joins it to the ground: write a joint of one of its \
                     bodies on `world(..)`, or `free({name})`"
                ),
            );
        }
        (order, closing)
    }

    /// Reports the arguments of a joint in the wrong order: it is on a body that nothing carries,
    /// and carries one that another joint carries too.
    fn check_order(
        &self,
        name: &Ident,
        joints: &[Option<ReadJoint>],
        errors: &mut Errors,
    ) -> Option<()> {
        let bodies = &self.system.bodies;
        let found = || joints.iter().zip(&self.system.joints);
        let found = || found().filter_map(|(joint, written)| Some((joint.as_ref()?, written)));
        for (joint, written) in found() {
            let is_on = |carrier: usize| bodies[carrier].name == *name;
            let is_other =
                |other: &ReadJoint| other.carried == joint.carried && other.name != joint.name;
            let Some((other, _)) = found().find(|(other, _)| is_other(other)) else {
                continue;
            };
            if let (true, Some(((word, [first, second, ..]), _))) = (
                joint.carrier.is_some_and(is_on),
                written.value.as_ref().and_then(call),
            ) {
                let text = |end| short(end).unwrap_or_else(|| "..".to_owned());
                let more = if joint.kind.directions() > 0 {
                    ", .."
                } else {
                    ""
                };
                let message = format!(
                    "`{}` is carried by `{}` already; if `{}` carries `{name}`, write `{word}({}, {}{more})`",
                    bodies[joint.carried].name,
                    other.name,
                    joint.name,
                    text(second),
                    text(first),
                );
                return errors.report(first.extent.to(second.extent), message);
            }
        }
        Some(())
    }

    /// The joint that carries each body, and the joints that close loops.
    fn carriers(
        &self,
        joints: &[Option<ReadJoint>],
        is_sound: &mut bool,
        errors: &mut Errors,
    ) -> (Vec<Option<usize>>, Vec<usize>) {
        let bodies = &self.system.bodies;
        let mut carried_by: Vec<Option<usize>> = vec![None; bodies.len()];
        let mut closing = Vec::new();
        for (index, joint) in joints.iter().enumerate() {
            let Some(joint) = joint else { continue };
            let body = &bodies[joint.carried].name;
            match carried_by[joint.carried].and_then(|other| joints[other].as_ref()) {
                None => carried_by[joint.carried] = Some(index),
                Some(other) => match may_close(joint) {
                    Ok(()) => closing.push(index),
                    Err(reason) => {
                        *is_sound = false;
                        let other = &other.name;
                        let message =
                            format!("`{body}` is carried by `{other}` already, and {reason}");
                        errors.push(joint.mention, message);
                    }
                },
            }
        }
        (carried_by, closing)
    }
}

/// Whether a joint may close a loop; if not, why.
fn may_close(joint: &ReadJoint) -> Result<(), &'static str> {
    if joint.kind.holds == Holds::Center {
        Err(
            "a body that is joined to the ground by its G has no other joint: leave one of them out",
        )
    } else if joint.armature.is_some() {
        Err(
            "a joint that closes a loop has no coordinate with an armature: write it before the other one, \
             which then closes the loop",
        )
    } else if joint.driven.is_some() {
        Err(
            "a joint that closes a loop has no coordinates to prescribe: write it before the other one, \
             which then closes the loop",
        )
    } else {
        Ok(())
    }
}

/// Orders joints, with the bodies that they carry, so that each comes after the one that carries
/// its carrier.
fn in_order(joints: &[Option<ReadJoint>], carried_by: &[Option<usize>]) -> (Vec<usize>, Vec<bool>) {
    let mut order: Vec<usize> = Vec::new();
    let mut placed = vec![false; carried_by.len()];
    loop {
        let before = order.len();
        for (index, joint) in joints.iter().enumerate() {
            let Some(joint) = joint else { continue };
            let is_next = carried_by[joint.carried] == Some(index) && !placed[joint.carried];
            if is_next && joint.carrier.is_none_or(|carrier| placed[carrier]) {
                placed[joint.carried] = true;
                order.push(index);
            }
        }
        if order.len() == before {
            return (order, placed);
        }
    }
}
