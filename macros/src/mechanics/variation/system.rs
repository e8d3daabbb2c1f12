//! Potentials of a system, as loads on its bodies and along its joints.

use crate::families::{Family, LoadKind};
use crate::model::{Along, Frame, Load, Point, System, Workspace};
use crate::symbolic::Id;

use super::potential::{Draw, derive_form};

/// The potentials of a system become loads on bodies, and drives of joints.
pub fn with_system_potentials(mut system: System, work: &mut Workspace) -> System {
    let Some(form) = system.potentials.forms.pop() else {
        return system;
    };
    for (number, derived) in derive_form(work, &form).into_iter().enumerate() {
        for (displaced, draw) in form.bodies.iter().zip(&derived.on) {
            draw_at(
                &mut system,
                work,
                number,
                displaced.body,
                draw,
                derived.energy,
            );
        }
        for (freedom, load) in form.along.iter().zip(&derived.along) {
            drive(&mut system, work, number, freedom, *load);
        }
        system.energies.push(derived.energy);
    }
    system
}

/// Puts a load on a body, at the point that its joint holds.
fn draw_at(
    system: &mut System,
    work: &mut Workspace,
    number: usize,
    frame: Frame,
    draw: &Draw,
    energy: Id,
) {
    if draw.force.is_zero() && work.graph.is_zero_vector(&draw.moment) {
        return;
    }
    let (mut bodies, joints) = (system.bodies.iter_mut(), &system.joints);
    let place = bodies.position(|body| body.state.body == frame);
    let Some((place, joint)) = place.and_then(|place| Some((place, joints.get(place)?))) else {
        return;
    };
    let body = &mut system.bodies[place];
    let name = system.potentials.list[number].name.clone();
    let in_world = work.part(draw.force, Frame::WORLD);
    let labels = &mut work.labels;
    labels.vector(&format!("{name}_force_on_{}", body.name), in_world);
    labels.vector_or_one(
        &format!("{name}_moment_on"),
        &body.name.to_string(),
        draw.moment,
    );
    let point = Point::Fixed(frame, joint.pin);
    let moment = work.vector(frame, draw.moment);
    body.loads.push(Load {
        moment,
        potential: Some(energy),
        ..Load::new(name, Family::Field, LoadKind::Force, draw.force, point)
    });
}

/// Adds a load along a freedom of a joint.
fn drive(system: &mut System, work: &mut Workspace, number: usize, along: &Along, load: Id) {
    if work.graph.is_zero(load) {
        return;
    }
    let name = &system.potentials.list[number].name;
    let joint = &mut system.joints[along.joint];
    let (is_negative, magnitude) = work.graph.split_sign(load);
    let minus = if is_negative { "minus_" } else { "" };
    let label = format!("{minus}{name}_on_{}", joint.name);
    work.labels.name(magnitude, label);
    let drive = &mut joint.drives[along.freedom];
    *drive = work.graph.add(*drive, load);
}
