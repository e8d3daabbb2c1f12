//! A description of a system, read in order: what it declares, the points of its bodies, the joints,
//! and then all that depends on how it moves.

mod body;
mod drives;
mod joints;
mod motion;
mod tree;

use std::collections::HashSet;

use proc_macro2::Ident;

use crate::errors::{Errors, similar};
use crate::lower::definitions::{
    Definition as Defined, INVERSE, check_distinct, check_names, definition_order,
};
use crate::lower::expressions::{Lowering, Members, Scope, Value};
use crate::model::{
    Declared, Defaults, Frame, JointKind, Jointed, Meaning, Motion, Outline, PLANAR, SPATIAL,
    State, System, Vector, Workspace,
};
use crate::symbolic::{Id, Stage};
use crate::syntax::{self, Definition, Expression, Kind};

use body::Draft;
use joints::kind_of;

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
    let gravity = body::common_gravity(&mut work, &mut bodies);
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

/// What the words of a system tell, whatever is wrong with it: the joints are the fields of its
/// state.
pub fn outline_system(system: &syntax::System, outline: &mut Outline) {
    outline.is_system = true;
    outline.body_keys.clone_from(&system.keys);
    let mut seen = HashSet::new();
    let joints = system.joints.iter();
    let joints = joints
        .filter(|joint| seen.insert(joint.name.to_string()))
        .filter_map(|joint| {
            Some(Jointed {
                name: joint.name.clone(),
                shape: likely_kind(joint, system.is_planar)?.shape?,
                frame: None,
            })
        });
    outline.joints = joints.collect();
    let open = system.drives.iter().filter(|drive| {
        let load = drive
            .value
            .as_ref()
            .and_then(|value| drives::behind(value, "on"));
        load.is_some_and(|(load, _)| matches!(load.kind, Kind::Placeholder))
    });
    let open = open.filter(|drive| seen.insert(format!("drive {}", drive.name)));
    outline.open = open.map(|drive| drive.name.clone()).collect();
}

/// The kind of a joint, or of one that cannot be read, what it may be.
fn likely_kind(joint: &Definition, is_planar: bool) -> Option<&'static JointKind> {
    let kinds = JointKind::all(is_planar);
    let Some(value) = &joint.value else {
        return kinds.first();
    };
    kind_of(value, is_planar)
        .or_else(|| kind_of(value, false))
        .or_else(|| {
            let word = joints::call(value).map(|(word, ..)| word.to_string());
            let meant = similar(
                &word.unwrap_or_default(),
                kinds.iter().map(|kind| kind.word),
            );
            let similar = kinds.iter().find(|kind| meant == Some(kind.word));
            similar.or_else(|| kinds.first())
        })
}

/// The names of all bodies, and then of all joints.
fn declared(system: &syntax::System) -> Vec<String> {
    let bodies = system.bodies.iter().map(|body| &body.name);
    let names = bodies.chain(system.joints.iter().map(|joint| &joint.name));
    names.map(ToString::to_string).collect()
}

/// Reads a body; what is wrong with one of several copies is said once.
fn for_copy<T>(
    first: usize,
    number: usize,
    wrong: &mut HashSet<usize>,
    errors: &mut Errors,
    read: impl FnOnce(&mut Errors) -> T,
) -> T {
    if first != number && wrong.contains(&first) {
        let mut repeated = Errors::default();
        let found = read(&mut repeated);
        let _ = repeated.finish();
        return found;
    }
    let before = errors.count();
    let found = read(errors);
    if errors.count() > before {
        wrong.insert(first);
    }
    found
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
    let fields = || top.loads.iter().map(|load| &load.name);
    let loads = system
        .forces
        .iter()
        .chain(&system.moments)
        .chain(&system.drives);
    check_distinct("load", fields().chain(loads.map(|load| &load.name)), errors);
    for body in system
        .bodies
        .iter()
        .enumerate()
        .filter(|(number, _)| system.firsts[*number] == *number)
    {
        let loads = body.1.loads.iter().map(|load| &load.name);
        let mut known = HashSet::new();
        let fields: HashSet<&Ident> = fields().collect();
        for load in loads.filter(|load| known.insert(*load) && fields.contains(load)) {
            let message = format!(
                "there is a load `{load}` already, which acts on all bodies: loads are told apart by their names"
            );
            errors.push(load.span(), message);
        }
    }
    repeated
}

/// Reports names of a body that mean something for the whole system, and returns them.
fn check_own_names(
    system: &syntax::System,
    body: &syntax::Description,
    errors: &mut Errors,
) -> HashSet<String> {
    let top = &system.top;
    let declared = top
        .params
        .iter()
        .chain(&top.inputs)
        .map(|one| (&one.name, "param or input"));
    let all: Vec<(&Ident, &str)> = declared
        .chain(top.locals.iter().map(|local| (&local.name, "local")))
        .collect();
    let mut repeated = HashSet::new();
    for own in body.points.iter().chain(&body.locals) {
        if let Some((name, what)) = all.iter().find(|(name, _)| **name == own.name) {
            let message = format!(
                "`{name}` is the name of a {what} of the system already: choose another name"
            );
            errors.push(own.name.span(), message);
            repeated.insert(name.to_string());
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
            let Defined::Local(index) = definition else {
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
            Some(_) => Some((name, None)),
        })
        .collect()
}
