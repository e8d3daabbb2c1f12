//! The names of a system: all of them, the ambiguous ones, and those of quantities that change.

use std::collections::HashSet;

use proc_macro2::Ident;

use crate::errors::{Errors, hint, silently};
use crate::lower::definitions::check_distinct;
use crate::lower::expressions::BUILT_IN;
use crate::model::{Constraint, Outline};
use crate::syntax::{self, Expression, joined};

/// The names of all bodies, followed by those of all joints.
pub fn declared(system: &syntax::System) -> Vec<String> {
    let bodies = system.bodies.iter().map(|body| &body.name);
    let names = bodies.chain(system.joints.iter().map(|joint| &joint.name));
    names.map(ToString::to_string).collect()
}

/// The names of quantities that a description declares, with what they are.
fn quantities(top: &syntax::Description) -> Vec<(&Ident, &'static str)> {
    let declared = top.params.iter().chain(&top.inputs);
    let declared = declared.map(|one| (&one.name, "param or input"));
    let states = top.states.iter().map(|state| (&state.name, "state"));
    let locals = top.locals.iter().map(|local| (&local.name, "local"));
    let given = declared.chain(states).chain(top.foreign());
    given.chain(locals).collect()
}

/// Reads a body. An error that all copies of a body share is reported once.
pub fn for_copy<T>(
    first: usize,
    number: usize,
    wrong: &mut HashSet<usize>,
    errors: &mut Errors,
    read: impl FnOnce(&mut Errors) -> T,
) -> T {
    if first != number && wrong.contains(&first) {
        return silently(read);
    }
    let before = errors.count();
    let found = read(errors);
    if errors.count() > before {
        wrong.insert(first);
    }
    found
}

/// Reports ambiguous and built-in names of bodies and joints, and returns them. Constraints that have
/// the same name are reported elsewhere.
pub fn check_members(system: &syntax::System, errors: &mut Errors) -> HashSet<String> {
    let mut repeated = HashSet::new();
    let top = &system.top;
    let mut seen = quantities(top);
    let bodies = system.bodies.iter().map(|body| (&body.name, "body"));
    let joints = system.joints.iter().map(|joint| (&joint.name, "joint"));
    let cables = system.cables.iter().map(|cable| (&cable.name, "cable"));
    // the loads of constraints are fields, as joints are
    let constraints = top.constraints.iter().map(|one| (&one.name, "constraint"));
    for (name, what) in bodies.chain(joints).chain(cables).chain(constraints) {
        if BUILT_IN.contains(&name.to_string().as_str()) {
            let message = format!("`{name}` is built in: choose another name for this {what}");
            errors.push(name.span(), message);
            repeated.insert(name.to_string());
        } else if let Some((_, first)) = seen.iter().find(|(other, _)| *other == name) {
            repeated.insert(name.to_string());
            if [*first, what] == ["constraint"; 2] {
                continue;
            }
            let message = format!(
                "`{name}` is already the name of a {first}: params, inputs, states, locals, bodies and joints need different names"
            );
            errors.push(name.span(), message);
        } else {
            seen.push((name, what));
        }
    }
    let fields = top.loads.iter().map(|load| &load.name);
    let lists = [&system.forces, &system.moments, &system.drives];
    let loads = lists.into_iter().flatten().chain(&top.potentials);
    check_distinct("load", fields.chain(loads.map(|load| &load.name)), errors);
    repeated
}

/// What to report of a name that stands where that of a joint is expected.
pub fn no_joint(system: &syntax::System, name: &Ident) -> String {
    let is_among = |list: &[syntax::Definition]| list.iter().any(|one| one.name == *name);
    if is_among(&system.cables) {
        return format!("`{name}` is a cable, not a joint");
    }
    if is_among(&system.top.constraints) {
        return format!("`{name}` is a constraint, not a joint");
    }
    let names = system.joints.iter().map(|joint| joint.name.to_string());
    let names: Vec<String> = names.collect();
    let hint = hint(&name.to_string(), names.iter().map(String::as_str));
    format!("there is no joint `{name}`{hint}")
}

/// Reports joints that have the name of the solved drive of another joint, because both would be
/// fields, and leaves out that drive.
pub fn check_driving(system: &syntax::System, outline: &mut Outline, errors: &mut Errors) {
    outline.driving.retain(|(driven, drive)| {
        let mut joints = system.joints.iter().map(|joint| &joint.name);
        let Some(joint) = joints.find(|joint| *joint == drive) else {
            return true;
        };
        let message = format!(
            "`{joint}` is the name of the drive of `{driven}` in the reactions: choose another name"
        );
        errors.push(joint.span(), message);
        false
    });
}

/// Reports loads of constraints that have the name of another field of the reactions, such as
/// `pin_x` of a constraint `pin` if there is a joint `pin_x`. Constraints of one list that have the same
/// name themselves are reported elsewhere.
pub fn check_loads(
    system: &syntax::System,
    outline: &Outline,
    constraints: &[Constraint],
    errors: &mut Errors,
) {
    let is_own = |load: &Ident| system.top.constraints.iter().any(|one| one.name == *load);
    let of_bodies = system.bodies.iter().map(|body| {
        let written = body.constraints.iter();
        written.map(|one| joined(&body.name, &one.name)).collect()
    });
    let of_top = system.top.constraints.iter().map(|one| one.name.clone());
    let lists: Vec<Vec<Ident>> = of_bodies.chain([of_top.collect()]).collect();
    let is_repeated = |place: &Ident| {
        let times = |list: &Vec<Ident>| list.iter().filter(|name| *name == place).count();
        lists.iter().any(|list| times(list) > 1)
    };
    let all: Vec<_> = outline.kept.iter().zip(constraints).collect();
    for (number, (load, constraint)) in all.iter().enumerate() {
        let mut drives = outline.driving.iter().map(|(_, drive)| drive);
        let mut before = all[..number].iter();
        let what = if outline.holding.contains(load) && !is_own(load) {
            "a joint"
        } else if drives.any(|drive| drive == *load) {
            "a drive"
        } else if before.any(|(other, of)| {
            other == load && !(of.place == constraint.place && is_repeated(&of.place))
        }) {
            "another load"
        } else {
            continue;
        };
        let message = format!(
            "the load of this constraint is `{load}` among the reactions, which is the name of {what} \
             there: choose another name"
        );
        errors.push(load.span(), message);
    }
}

/// Reports and returns names of a body that already have a meaning in the whole system.
pub fn check_own_names(
    system: &syntax::System,
    body: &syntax::Description,
    errors: &mut Errors,
) -> HashSet<String> {
    let all = quantities(&system.top);
    let mut repeated = HashSet::new();
    for own in body.points.iter().chain(&body.locals) {
        if let Some((name, what)) = all.iter().find(|(name, _)| **name == own.name) {
            let message = format!(
                "`{name}` is already the name of a {what} of the system: choose another name"
            );
            errors.push(own.name.span(), message);
            repeated.insert(name.to_string());
        }
    }
    repeated
}

/// The names that depend on the motion of the system: bodies, joints, and locals that use them.
pub fn moving_locals(system: &syntax::System) -> HashSet<String> {
    let bodies = system.bodies.iter().map(|body| body.name.to_string());
    let joints = system.joints.iter().map(|joint| joint.name.to_string());
    let mut moving: HashSet<String> = bodies.chain(joints).collect();
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

/// The locals among these, in their order.
pub fn late_locals(system: &syntax::System) -> Vec<String> {
    let moving = moving_locals(system);
    let locals = system.top.locals.iter().map(|local| local.name.to_string());
    locals.filter(|name| moving.contains(name)).collect()
}
