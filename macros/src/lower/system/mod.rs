//! A description of a system, read in order: what it declares, the points of its bodies, the joints,
//! and then all that depends on how it moves.

mod body;
mod drives;
mod joints;
mod motion;
mod tree;

use std::collections::HashSet;

use proc_macro2::Ident;

use crate::errors::Errors;
use crate::lower::definitions::check_names;
use crate::lower::expressions::{Lowering, Members, Scope, Value};
use crate::model::{
    Declared, Defaults, Frame, Jointed, Meaning, Motion, Outline, PLANAR, SPATIAL, State, System,
    Vector, Workspace,
};
use crate::symbolic::{Id, Stage};
use crate::syntax::{self, Definition, Expression};

use body::Draft;
use joints::kind_of;

/// What the parts of a system are read with.
struct Reader<'a> {
    system: &'a syntax::System,
    work: Workspace,
    scope: Scope,
    members: Members,
    motion: Motion,
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
        members: Members::default(),
        motion: if system.is_planar { &PLANAR } else { &SPATIAL },
        time,
        defaults: Defaults::new(),
    };
    reader.defaults = reader.at_top(errors, |lowering| {
        lowering.declarations(&system.top, outline)
    });
    reader.locals(errors, false);
    let mut drafts: Vec<Draft<'_>> = Vec::new();
    for body in &system.bodies {
        let draft = reader.points(body, errors);
        drafts.push(draft);
    }
    let joints = reader.joints(errors);
    let order = reader.tree(&joints, errors);
    let joints = reader.motions(order, joints, &mut drafts);
    reader.locals(errors, true);
    let bodies = reader.bodies(drafts, errors);
    let joints = reader.drives(joints, errors);
    let loads = reader.loads_between(errors);
    outline.unused = reader.unused();
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
    errors.is_empty().then_some((system, work))
}

/// The joints of a system as far as their words tell: the fields of its state.
pub fn outline_joints(system: &syntax::System) -> Vec<Jointed> {
    let mut seen = HashSet::new();
    let joints = system.joints.iter();
    joints
        .filter(|joint| seen.insert(joint.name.to_string()))
        .filter_map(|joint| {
            let kind = kind_of(joint.value.as_ref()?, system.is_planar)?;
            Some(Jointed {
                name: joint.name.clone(),
                shape: kind.shape?,
                frame: None,
            })
        })
        .collect()
}

/// Reports names of bodies and joints that mean two things, and returns them.
fn check_members(system: &syntax::System, errors: &mut Errors) -> HashSet<String> {
    let mut repeated = HashSet::new();
    let mut seen: Vec<(&Ident, &str)> = Vec::new();
    let top = &system.top;
    let declared = top.params.iter().chain(&top.inputs);
    let declared = declared.map(|declaration| (&declaration.name, "param or input"));
    let locals = top.locals.iter().map(|local| (&local.name, "local"));
    seen.extend(declared.chain(locals));
    let bodies = system.bodies.iter().map(|body| (&body.name, "body"));
    let joints = system.joints.iter().map(|joint| (&joint.name, "joint"));
    for (name, what) in bodies.chain(joints) {
        if crate::lower::expressions::BUILT_IN.contains(&name.to_string().as_str()) {
            let message = format!("`{name}` is built in: choose another name for this {what}");
            errors.push(name.span(), message);
        } else if let Some((_, first)) = seen.iter().find(|(other, _)| *other == name) {
            let message = format!(
                "`{name}` is the name of a {first} already: params, inputs, locals, bodies and joints need different names"
            );
            errors.push(name.span(), message);
            repeated.insert(name.to_string());
        } else {
            seen.push((name, what));
        }
    }
    repeated
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
        // each after those it refers to; what is left goes in a circle
        let mut left: Vec<&Definition> = locals
            .iter()
            .filter(|local| moves.contains(&local.name.to_string()) == is_late)
            .collect();
        while !left.is_empty() {
            let waits = |local: &Definition, left: &[&Definition]| {
                let names = local.value.iter().flat_map(Expression::names);
                names
                    .into_iter()
                    .any(|name| left.iter().any(|other| other.name == *name))
            };
            let ready = left.iter().position(|local| !waits(local, &left));
            let Some(ready) = ready else {
                for local in left {
                    let message = format!("`{}` is defined in a circle", local.name);
                    errors.push(local.name.span(), message);
                    self.scope.define(&local.name.to_string(), None);
                }
                return;
            };
            let local = left.remove(ready);
            let name = local.name.to_string();
            let value = self.at_top(errors, |lowering| {
                let value = lowering.value(local.value.as_ref()?)?;
                Some(lowering.named(value, &name))
            });
            self.scope.define(&name, value);
        }
    }

    /// The names of the system that nothing refers to.
    fn unused(&self) -> Vec<Ident> {
        let top = &self.system.top;
        let inputs = top.inputs.iter().filter(|input| input.order == 0);
        let declared = top.params.iter().chain(inputs).map(|one| &one.name);
        let names = declared.chain(top.locals.iter().map(|local| &local.name));
        names
            .filter(|name| !self.scope.is_used(name))
            .cloned()
            .collect()
    }
}

/// The locals that depend on how the system moves.
fn moving_locals(system: &syntax::System) -> HashSet<String> {
    let bodies = system.bodies.iter().map(|body| body.name.to_string());
    let joints = system.joints.iter().map(|joint| joint.name.to_string());
    let mut moving: HashSet<String> = bodies.chain(joints).chain(["t".to_owned()]).collect();
    loop {
        let before = moving.len();
        for local in &system.top.locals {
            let names = local.value.iter().flat_map(Expression::names);
            if names
                .into_iter()
                .any(|name| moving.contains(&name.to_string()))
            {
                moving.insert(local.name.to_string());
            }
        }
        if moving.len() == before {
            return moving;
        }
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
            None => Some((name, None)),
            Some(_) => None,
        })
        .collect()
}
