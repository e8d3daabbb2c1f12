//! Checks that the joints form a tree: each body is carried once, and all are carried by the
//! ground, directly or indirectly.

use crate::errors::Errors;
use crate::model::Holds;

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
        let is_lost = self.system.has_lost_joints || self.system.has_lost_bodies;
        let mut is_sound = joints.iter().all(Option::is_some) && !is_lost;
        let (carried_by, closing) = self.carriers(joints, &mut is_sound, errors);
        // a joint with an error may have been meant to carry the body
        if is_sound {
            for (body, _) in bodies
                .iter()
                .zip(&carried_by)
                .filter(|(_, by)| by.is_none())
            {
                let name = &body.name;
                errors.push(
                    name.span(),
                    format!("nothing carries `{name}`: write a joint of it, such as `orbit = free({name})`"),
                );
                is_sound = false;
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
            let joint = joint.map_or(String::new(), |joint| joint.name.to_string());
            errors.push(
                name.span(),
                format!("`{name}` is carried by `{joint}` in a circle: one of the bodies in it is joined to the ground, or `free`"),
            );
        }
        (order, closing)
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
