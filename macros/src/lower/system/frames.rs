//! Massless bodies, which move with bodies that have mass.

use crate::errors::Errors;
use crate::model::{Member, TreeJoint, Workspace};

/// Checks that a body that moves by itself carries mass. Each joint has the index of the body that
/// it carries, and comes after the joint of its carrier.
pub fn check_frames(
    work: &Workspace,
    bodies: &[Member],
    joints: &[TreeJoint],
    errors: &mut Errors,
) {
    let mut has_mass: Vec<bool> = bodies
        .iter()
        .map(|body| !work.graph.is_zero(body.mass))
        .collect();
    for (number, joint) in joints.iter().enumerate().rev() {
        if let Some(carrier) = joint.carrier.filter(|_| has_mass[number]) {
            has_mass[carrier] = true;
        }
        let moves = !joint.coordinates.0.is_empty() && !joint.is_driven();
        if moves && !has_mass[number] {
            let (body, name) = (&bodies[number].name, &joint.name);
            let message = format!(
                "`{name}` moves `{body}`, which has no mass and carries none: write `mass: 1[kg]`, \
                 or hold it with a `weld`"
            );
            errors.push(body.span(), message);
        }
    }
}
