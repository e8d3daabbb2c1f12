//! A description of a system, read in order: its declarations, the points of its bodies, the
//! joints, and then everything that depends on its motion.

mod between_bodies;
mod constraints;
mod displaced_bodies;
mod drives;
mod fields;
mod frames;
mod joints;
mod load_methods;
mod outline;
mod output_arguments;
mod potentials;
mod read;
mod reading;
mod ties;

use std::collections::HashSet;

use proc_macro2::Ident;

use crate::errors::Errors;
use crate::lower::definitions::{FLOW, LINEARIZATION, check_changing, unused};
use crate::lower::loads::check_states;
use crate::model::{Connection, Constraint, Member, Outline, System, TreeJoint, Workspace};
use crate::symbolic::{Components, Id};
use crate::syntax;

use joints::armatures;
use reading::body::{Draft, common_gravity};
use reading::names::{check_loads, for_copy};
use reading::reader::Reader;

pub use drives::targets;
pub use outline::outline_system;
pub use read::read_system;

/// Gives a description of a system its meaning. `None` if there was any error.
fn lower_system(
    system: &syntax::System,
    outline: &mut Outline,
    work: Workspace,
    errors: &mut Errors,
) -> Option<(System, Workspace)> {
    let mut reader = Reader::new(system, outline, work, errors);
    fields::check_fields(system, errors);
    reader.fixed(outline, errors);
    let mut wrong = HashSet::new();
    let mut drafts = reader.drafts(&mut wrong, errors);
    let (joints, mut closings) = reader.tree_and_loops(&mut drafts, &outline.kept, errors);
    reader.late_points(&mut drafts, errors);
    reader.locals(errors, true);
    reader.top_constraints(&outline.inputs, errors);
    let mut bodies = reader.bodies(&mut drafts, &mut wrong, &outline.inputs, errors);
    if let Some(bodies) = &mut bodies {
        reader.felt(&mut drafts, bodies);
    }
    let potentials = reader.potentials(&mut drafts, &joints, errors);
    let constraints = reader.constraints_apart(&mut drafts, &joints, errors);
    let joints = reader.drives(joints, errors);
    let between = reader.loads_between(errors);
    let points = reader.asked_points(errors);
    let states = reader.at_top(errors, |lowering| {
        lowering.states(&system.top, &outline.states)
    });
    let checks = reader.checks(&outline.holding, errors);
    outline.unused = reader.unused(&drafts);
    check_substances(&reader.work, bodies.iter().flatten(), outline, errors);
    let (constraints, (links, lengths), states) = (constraints?, reader.links(errors)?, states?);
    let (mut work, derivatives) = (reader.work, reader.derivatives);
    check_states(&work, &constraints.list, &states, &derivatives, errors)?;
    let (mut bodies, mut points, between) = (bodies?, points?, between?);
    let (mut joints, on_free) = joints?;
    for (body, load) in between.loads.into_iter().chain(on_free) {
        bodies[body].loads.push(load);
    }
    let fields = system.top.loads.iter();
    let fields = fields.filter(|field| field.charges.is_none()).count();
    let gravity = common_gravity(&mut work, &mut bodies, fields);
    let bodies = carriers_first(bodies, &mut joints, &mut closings, &mut points)?;
    let written = tell_frames(outline, &joints);
    outline.kept = constraints.list.iter().map(load_of).collect();
    check_loads(system, outline, &constraints.list, errors);
    let mistakes = checks.mistakes;
    check_motion(outline, &work, (&bodies, &joints), (mistakes, errors));
    let armatures = armatures(&joints);
    let system = System {
        is_planar: system.is_planar,
        bodies,
        joints,
        closings,
        written,
        points,
        gravity,
        unweighed: None,
        states,
        constraints,
        potentials: potentials?,
        energies: between.energies,
        cables: between.cables,
        links,
        properties: [lengths, between.properties, armatures].concat(),
        derivatives,
        is_differentiated: outline.asks_for(&[LINEARIZATION, FLOW]),
        defaults: reader.defaults,
        checks,
    };
    (errors.count() == mistakes).then_some((system, work))
}

/// Checks outputs against masses and inertias that change.
fn check_substances<'b>(
    work: &Workspace,
    bodies: impl Iterator<Item = &'b Member>,
    outline: &Outline,
    errors: &mut Errors,
) {
    let made_of: Vec<Id> = bodies.flat_map(|body| body.substance().numbers()).collect();
    check_changing(work, &made_of, outline, errors);
}

/// Checks a system without other errors than the mistakes in its checks: massless bodies, and systems in which nothing moves.
fn check_motion(
    outline: &Outline,
    work: &Workspace,
    (bodies, joints): (&[Member], &[TreeJoint]),
    (mistakes, errors): (usize, &mut Errors),
) {
    // the check of a file may have reported the same
    if errors.count() == mistakes {
        frames::check_frames(work, bodies, joints, errors);
    }
    if errors.count() == mistakes && outline.is_still() {
        check_still(outline, errors);
    }
}

/// Reports outputs that have no meaning for a system in which nothing moves by itself.
fn check_still(outline: &Outline, errors: &mut Errors) {
    if outline.outputs.is_empty() {
        let message = "nothing moves by itself, because all joints are welds, or driven: ask for what there is \
                       without a motion, such as `outputs: [reactions]`";
        errors.push(outline.name.span(), message);
    }
    for asked in outline.outputs.iter().filter(|asked| asked.is_of_motion) {
        let message = format!(
            "nothing moves by itself, because all joints are welds, or driven, and `{}` describes a motion: \
             `reactions` has the drives of joints that are driven",
            asked.word
        );
        errors.push(asked.place, message);
    }
}

/// The name of the load that keeps a constraint.
fn load_of(constraint: &Constraint) -> Ident {
    let name = constraint.name.replace('.', "_");
    Ident::new(&name, constraint.place.span())
}

/// Records the frames of the bodies that joints carry, which identify their states. Returns the
/// indices of the moving joints, in the order of the state.
fn tell_frames(outline: &mut Outline, joints: &[TreeJoint]) -> Vec<usize> {
    let mut written = Vec::new();
    for known in &mut outline.joints {
        let place = joints.iter().position(|joint| joint.name == known.name);
        let joint = place.map(|place| &joints[place]);
        known.frame = joint.and_then(|joint| joint.frames.last().copied());
        written.extend(place);
    }
    written
}

/// Each body with the joint that carries it, sorted so that carriers come first. Requested points
/// are renumbered with their bodies.
fn carriers_first(
    bodies: Vec<Member>,
    joints: &mut [TreeJoint],
    closings: &mut [Connection],
    points: &mut [(usize, Components)],
) -> Option<Vec<Member>> {
    let place = |body: usize| joints.iter().position(|joint| joint.carried == body);
    let mut numbered: Vec<_> = bodies.into_iter().enumerate().collect();
    numbered.sort_by_key(|(body, _)| place(*body));
    let old: Vec<usize> = numbered.iter().map(|(body, _)| *body).collect();
    let new = |body: usize| old.iter().position(|other| *other == body);
    let joints = joints.iter_mut().map(|joint| &mut joint.connection);
    for connection in joints.chain(closings) {
        connection.carrier = connection.carrier.and_then(new);
        connection.carried = new(connection.carried)?;
    }
    for (body, _) in points {
        *body = new(*body)?;
    }
    Some(numbered.into_iter().map(|(_, body)| body).collect())
}

impl<'a> Reader<'a> {
    /// Reads the joints, which give each body its motion. Returns those of the tree and those that
    /// close loops.
    fn tree_and_loops(
        &mut self,
        drafts: &mut [Draft<'a>],
        kept: &[Ident],
        errors: &mut Errors,
    ) -> (Vec<TreeJoint>, Vec<Connection>) {
        let joints = self.joints(errors);
        self.check_held(&joints, kept, errors);
        let (order, closing) = self.tree(&joints, errors);
        let (closings, joints) = self.closings(&closing, joints, errors);
        let joints = self.motions(order, joints, drafts);
        self.members.are_moving = true;
        (joints, closings)
    }

    /// All bodies, with their points. Bodies with errors are added to `wrong`.
    fn drafts(&mut self, wrong: &mut HashSet<usize>, errors: &mut Errors) -> Vec<Draft<'a>> {
        let system = self.system;
        let bodies = system.bodies.iter().enumerate();
        let drafts = bodies.map(|(number, body)| {
            let first = system.firsts[number];
            for_copy(first, number, wrong, errors, |errors| {
                self.points(number, body, errors)
            })
        });
        drafts.collect()
    }

    /// The names of the system that nothing refers to.
    fn unused(&self, drafts: &[Draft<'_>]) -> Vec<Ident> {
        let mut unused = unused(&self.system.top, &self.scope);
        unused.extend(self.unused_of_bodies(drafts));
        unused
    }

    /// The points and locals of bodies that nothing refers to. Those of copied bodies count as used
    /// if any copy uses them.
    fn unused_of_bodies(&self, drafts: &[Draft<'_>]) -> Vec<Ident> {
        let used = self.members.used.borrow();
        let is_used = |number: usize, name: &Ident| {
            let of_others = used.contains(&(number, name.to_string()));
            of_others || drafts[number].scope.is_used(name)
        };
        let mut unused = Vec::new();
        for (first, draft) in drafts.iter().enumerate() {
            if self.system.firsts[first] != first {
                continue;
            }
            let copies: Vec<usize> = (0..drafts.len())
                .filter(|number| self.system.firsts[*number] == first)
                .collect();
            let own = draft
                .description
                .points
                .iter()
                .chain(&draft.description.locals);
            let own = own.map(|definition| &definition.name);
            let given = &draft.description.given;
            let own = own.filter(|name| !given.contains(&name.to_string()));
            let left = own.filter(|name| !copies.iter().any(|copy| is_used(*copy, name)));
            unused.extend(left.cloned());
        }
        unused
    }
}
