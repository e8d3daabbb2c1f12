//! Potentials of a system, as loads on its bodies and along its joints.

use proc_macro2::Ident;

use crate::families::{Family, LoadKind};
use crate::model::{Along, Frame, Load, Point, Potential, System, Workspace};
use crate::symbolic::Id;

use super::potential::{Draw, derive_form};

/// Turns the potentials of a system into loads on bodies, and drives of joints.
pub fn with_system_potentials(mut system: System, work: &mut Workspace) -> System {
    let (mut on_bodies, mut along_joints) = (Vec::new(), Vec::new());
    for form in &system.potentials.forms {
        let potentials = &system.potentials.list;
        for (Potential { name, .. }, derived) in potentials.iter().zip(derive_form(work, form)) {
            for (displaced, draw) in form.bodies.iter().zip(&derived.on) {
                let place = place_of(&system, displaced.body, draw, work);
                on_bodies.extend(place.map(|body| {
                    let load = load_on(&system, work, (body, name), draw, derived.energy);
                    (body, load)
                }));
            }
            for (freedom, load) in form.along.iter().zip(derived.along) {
                if !work.graph.is_zero(load) {
                    name_drive(work, name, &system.joints[freedom.joint].name, load);
                    along_joints.push((freedom.clone(), load));
                }
            }
            system.energies.push(derived.energy);
        }
    }
    for (body, load) in on_bodies {
        system.bodies[body].loads.push(load);
    }
    for (Along { joint, freedom, .. }, load) in along_joints {
        let drive = &mut system.joints[joint].drives[freedom];
        *drive = work.graph.add(*drive, load);
    }
    system
}

/// The index of the body on which a load acts; `None` if there is no load.
fn place_of(system: &System, frame: Frame, draw: &Draw, work: &Workspace) -> Option<usize> {
    if draw.force.is_zero() && work.graph.is_zero_vector(&draw.moment) {
        return None;
    }
    let mut bodies = system.bodies.iter();
    bodies.position(|body| body.state.body == frame)
}

/// The load on a body, at the point that its joint holds.
fn load_on(
    system: &System,
    work: &mut Workspace,
    (body, potential): (usize, &Ident),
    draw: &Draw,
    energy: Id,
) -> Load {
    let (pin, body) = (system.joints[body].pin, &system.bodies[body]);
    let in_world = work.part(draw.force, Frame::WORLD);
    let labels = &mut work.labels;
    labels.vector(&format!("{potential}_force_on_{}", body.name), in_world);
    labels.vector_or_one(
        &format!("{potential}_moment_on"),
        &body.name.to_string(),
        draw.moment,
    );
    let frame = body.state.body;
    let (name, point) = (potential.clone(), Point::Fixed(frame, pin));
    Load {
        moment: work.vector(frame, draw.moment),
        potential: Some(energy),
        ..Load::new(name, Family::Field, LoadKind::Force, draw.force, point)
    }
}

/// Names the load of a potential along a freedom of a joint.
fn name_drive(work: &mut Workspace, potential: &Ident, joint: &Ident, load: Id) {
    let (is_negative, magnitude) = work.graph.split_sign(load);
    let minus = if is_negative { "minus_" } else { "" };
    let label = format!("{minus}{potential}_on_{joint}");
    work.labels.name(magnitude, label);
}
