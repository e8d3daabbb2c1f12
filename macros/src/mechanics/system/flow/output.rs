//! The motion of a system in closed form, or what prevents it.

use proc_macro2::Ident;

use crate::errors::{Errors, Extent};
use crate::model::{Member, Shape, System, Workspace};

use super::course::{Course, SolvedJoint};
use super::obstacles::{CHANGING, CLOSED, Obstacles};
use crate::mechanics::system::equations::SystemEquations;

/// The motion of a system in closed form: the motion of each joint, in the order of the state.
pub struct SystemFlow {
    pub joints: Vec<(Ident, &'static Shape, Course)>,
}

/// The closed form. Obstacles are reported where it is requested, one for everything that a joint
/// to the ground carries.
pub fn derive_system_flow(
    system: &System,
    work: &mut Workspace,
    place: Extent,
    equations: &SystemEquations,
    errors: &mut Errors,
) -> Option<SystemFlow> {
    if !system.is_tree() {
        return errors.report(place, CLOSED);
    }
    let substances = system.bodies.iter().map(Member::substance);
    let known = substances.flat_map(|substance| substance.numbers());
    if !work.graph.are_early(&known.collect::<Vec<_>>()) {
        return errors.report(place, CHANGING);
    }
    let mut courses = courses(system, work, equations);
    let mut obstacles = Obstacles {
        system,
        equations,
        work,
        failing: system
            .written
            .iter()
            .filter(|number| courses[**number].is_none())
            .copied()
            .collect(),
    };
    let mut sound = Some(());
    for obstacle in obstacles.all() {
        sound = errors.report(
            place,
            format!("no closed form: {obstacle}; leave out `flow`, and the motion is integrated"),
        );
    }
    sound?;
    let joints = system.written.iter().map(|number| {
        let joint = &system.joints[*number];
        Some((
            joint.name.clone(),
            joint.kind.shape?,
            courses[*number].take()?,
        ))
    });
    Some(SystemFlow {
        joints: joints.collect::<Option<_>>()?,
    })
}

/// The motion of each joint, if all have a closed form. A joint is tried by itself first, and then
/// together with one of the pendulums.
fn courses(
    system: &System,
    work: &mut Workspace,
    equations: &SystemEquations,
) -> Vec<Option<Course>> {
    let mut courses: Vec<Option<Course>> = (0..system.joints.len()).map(|_| None).collect();
    let moving = |number: usize| SolvedJoint {
        system,
        equations,
        number,
    };
    for number in &system.written {
        courses[*number] = moving(*number).course(work);
    }
    for number in &system.written {
        if courses[*number].is_none() {
            let counter = moving(*number).counter(work, &courses);
            courses[*number] = counter.map(Course::Counter);
        }
    }
    courses
}

impl SystemFlow {
    /// The kinds of motion, in words, line by line.
    pub fn describe(&self) -> Vec<String> {
        let lines = self.joints.iter().map(|(name, _, course)| {
            let motion = match course {
                Course::Uniform(_) => "at constant acceleration".to_owned(),
                Course::Counter(_) => {
                    "its angle and that of a pendulum together are quadratic in time".to_owned()
                }
                Course::Turning(rotation, center) => {
                    let center = center.as_ref();
                    let center = center.map(|_| "the center of mass moves on a parabola");
                    let parts: Vec<&str> = center.into_iter().chain(rotation.describe()).collect();
                    parts.join(", ")
                }
            };
            format!("`{name}`: {motion}")
        });
        lines.collect()
    }
}
