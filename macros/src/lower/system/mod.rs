//! A description of a system, read in order: what it declares, the points of its bodies, the
//! joints, and then all that depends on how it moves.

mod axes;
mod between;
mod body;
mod drives;
mod joints;
mod motion;
mod names;
mod outline;
mod tree;

use std::collections::HashSet;

use proc_macro2::Ident;

use crate::errors::Errors;
use crate::lower::definitions::{Definition, INVERSE, check_names, definition_order};
use crate::lower::expressions::{Lowering, Members, Scope, Value};
use crate::model::{
    Declared, Defaults, Frame, Meaning, Motion, Outline, PLANAR, SPATIAL, State, System, Vector,
    Workspace,
};
use crate::symbolic::{Id, Stage};
use crate::syntax;

use body::Draft;
use names::{check_members, check_own_names, declared, for_copy, late_locals, moving_locals};

pub use outline::outline_system;

/// What the parts of a system are read with.
struct Reader<'a> {
    system: &'a syntax::System,
    work: Workspace,
    scope: Scope,
    members: Members,
    motion: Motion,
    /// Whether drives are solved for.
    is_inverse: bool,
    /// For each body, whether its joints let it turn.
    turning: Vec<bool>,
    time: Id,
    defaults: Defaults,
}

/// Gives a description of a system its meaning. `None` if anything was wrong with it.
pub fn lower_system(
    system: &syntax::System,
    outline: &mut Outline,
    errors: &mut Errors,
) -> Option<(System, Workspace)> {
    let mut repeated = check_names(&system.top, errors);
    repeated.extend(check_members(system, errors));
    let mut work = Workspace::new();
    let time = work.symbol(Stage::State, Meaning::Time);
    let mut reader = Reader {
        system,
        work,
        scope: Scope::new(&system.top, repeated),
        members: Members {
            declared: declared(system),
            late: late_locals(system),
            ..Members::default()
        },
        is_inverse: outline.rank(INVERSE).is_some(),
        turning: vec![false; system.bodies.len()],
        motion: if system.is_planar { &PLANAR } else { &SPATIAL },
        time,
        defaults: Defaults::new(),
    };
    reader.defaults = reader.at_top(errors, |lowering| {
        lowering.declarations(&system.top, outline)
    });
    reader.locals(errors, false);
    let mut drafts: Vec<Draft<'_>> = Vec::new();
    let mut wrong = HashSet::new();
    for (number, body) in system.bodies.iter().enumerate() {
        let draft = for_copy(
            system.firsts[number],
            number,
            &mut wrong,
            errors,
            |errors| reader.points(body, errors),
        );
        drafts.push(draft);
    }
    let joints = reader.joints(errors);
    let order = reader.tree(&joints, errors);
    let joints = reader.motions(order, joints, &mut drafts);
    reader.members.are_moving = true;
    reader.locals(errors, true);
    let bodies = reader.bodies(&mut drafts, &mut wrong, errors);
    let joints = reader.drives(joints, errors);
    let loads = reader.loads_between(errors);
    outline.unused = reader.unused(&drafts);
    let (mut bodies, joints) = (bodies?, joints?);
    for (body, load) in loads? {
        bodies[body].loads.push(load);
    }
    let Reader {
        mut work, defaults, ..
    } = reader;
    let gravity = body::common_gravity(&mut work, &mut bodies, system.top.loads.len());
    // each body with its joint, carriers first
    let place = |body: usize| joints.iter().position(|joint| joint.carried == body);
    let mut numbered: Vec<_> = bodies.into_iter().enumerate().collect();
    numbered.sort_by_key(|(body, _)| place(*body));
    let old: Vec<usize> = numbered.iter().map(|(body, _)| *body).collect();
    let new = |body: usize| old.iter().position(|other| *other == body);
    let mut joints = joints;
    for joint in &mut joints {
        joint.carrier = joint.carrier.and_then(new);
        joint.carried = new(joint.carried)?;
    }
    for known in &mut outline.joints {
        let joint = joints.iter().find(|joint| joint.name == known.name);
        known.frame = joint.and_then(|joint| joint.frames.last().copied());
    }
    let system = System {
        is_planar: system.is_planar,
        bodies: numbered.into_iter().map(|(_, body)| body).collect(),
        joints,
        gravity,
        derivatives: outline.inputs.iter().map(Declared::derivatives).collect(),
        defaults,
    };
    if errors.is_empty() && outline.joints.is_empty() {
        let message = "nothing moves: all joints are welds";
        errors.push(outline.name.span(), message);
    }
    errors.is_empty().then_some((system, work))
}

impl Reader<'_> {
    /// Reads what stands beside the bodies.
    fn at_top<T>(&mut self, errors: &mut Errors, read: impl FnOnce(&mut Lowering<'_>) -> T) -> T {
        let mut state = still(Frame::WORLD, self.time);
        read(&mut Lowering {
            work: &mut self.work,
            scope: &mut self.scope,
            errors,
            motion: self.motion,
            state: &mut state,
            reactions: Vec::new(),
            is_constrained: false,
            composed: None,
            has_parts: false,
            members: &self.members,
            is_whole: true,
        })
    }

    /// The locals of the system: those that mention no body, joint or time, and later the others.
    fn locals(&mut self, errors: &mut Errors, is_late: bool) {
        let locals = &self.system.top.locals;
        let moves = moving_locals(self.system);
        let mut circles = Errors::default();
        let (order, circular) = definition_order(
            &self.system.top,
            if is_late { errors } else { &mut circles },
        );
        let _ = circles.finish();
        for definition in circular {
            self.scope.define(&definition.of(&self.system.top).0, None);
        }
        for definition in order {
            let Definition::Local(index) = definition else {
                continue;
            };
            let local = &locals[index];
            let name = local.name.to_string();
            if moves.contains(&name) != is_late {
                continue;
            }
            let value = self.at_top(errors, |lowering| {
                let value = lowering.value(local.value.as_ref()?)?;
                Some(lowering.named(value, &name))
            });
            self.scope.define(&name, value);
        }
    }

    /// The names of the system that nothing refers to.
    fn unused(&self, drafts: &[Draft<'_>]) -> Vec<Ident> {
        let top = &self.system.top;
        let inputs = top.inputs.iter().filter(|input| input.order == 0);
        let declared = top.params.iter().chain(inputs).map(|one| &one.name);
        let names = declared.chain(top.locals.iter().map(|local| &local.name));
        let unused = names.filter(|name| !self.scope.is_used(name)).cloned();
        unused.chain(self.unused_of_bodies(drafts)).collect()
    }

    /// The points and locals of bodies that nothing refers to, of copies no copy.
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
            let left = own.filter(|name| !copies.iter().any(|copy| is_used(*copy, name)));
            unused.extend(left.cloned());
        }
        unused
    }
}

/// A body of which no motion is known.
fn still(body: Frame, time: Id) -> State {
    let zeros = Workspace::default().graph.zeros();
    State {
        body,
        axes: body,
        time,
        position: Vector::ZERO,
        velocity: Vector::ZERO,
        acceleration: Vector::ZERO,
        angle: None,
        angular_velocity: zeros,
        angular_acceleration: zeros,
        axis: None,
        support: None,
    }
}

/// The points that names stand for, as others see them.
fn points(
    scope: &Scope,
    body: &syntax::Description,
    frame: Frame,
) -> Vec<(String, Option<crate::symbolic::Components>)> {
    let names = body.points.iter().map(|point| point.name.to_string());
    names
        .filter_map(|name| match scope.peek(&name) {
            Some(Value::Point(point)) => point.offset(frame).map(|offset| (name, Some(offset))),
            _ => Some((name, None)),
        })
        .collect()
}
