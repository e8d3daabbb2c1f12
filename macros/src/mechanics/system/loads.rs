//! The loads of joints, and the drives that produce given accelerations.

use std::iter::once;

use proc_macro2::Ident;

use crate::errors::Errors;
use crate::mechanics::tree::link::Tree;
use crate::mechanics::tree::{self, SpatialVector};
use crate::model::{AXES, System, TreeJoint, Workspace};
use crate::symbolic::{Components, Id, Undetermined};

use super::closed::{Closed, Spare, component, moved_in_world, release, solve_drives};
use super::equations::SystemEquations;

/// The open drives that produce the given accelerations, in the order of the joints. A drive that
/// others can replace is reported at its name.
pub fn derive_system_inverse(
    system: &System,
    work: &mut Workspace,
    equations: &SystemEquations,
    errors: &mut Errors,
) -> Vec<Id> {
    let needed = needed(system, work, equations);
    let joints = system.joints.iter().filter(|joint| !joint.is_driven());
    let named: Vec<&Option<Ident>> = joints.flat_map(|joint| &joint.open).collect();
    let open = named.iter().enumerate().filter(|(_, name)| name.is_some());
    let open: Vec<usize> = open.map(|(freedom, _)| freedom).collect();
    let drives: Vec<Id> = match &equations.closed {
        None => open.iter().map(|freedom| needed[*freedom]).collect(),
        Some(closed) => {
            let sides = (&needed[..], &system.constraints.loads[..]);
            let solved = solve_drives(work, closed, sides, &open);
            let names: Vec<&Ident> = open.iter().filter_map(|one| named[*one].as_ref()).collect();
            report_undetermined(&names, &solved.undetermined, errors);
            report_undriven(system, closed, &solved.spare, errors);
            solved.values.into_iter().take(open.len()).collect()
        }
    };
    let (folded, images) = work.graph.folded(&drives);
    work.labels.follow(&images);
    let results = folded.into_iter();
    results.map(|one| work.graph.result(one)).collect()
}

/// Reports drives that others can replace. If the undetermined unknown is the load of a constraint,
/// the drives that change with it are not determined.
fn report_undetermined(names: &[&Ident], unknowns: &[Undetermined], errors: &mut Errors) {
    let mut reported = Vec::new();
    for unknown in unknowns {
        let columns = once(&unknown.column).chain(&unknown.others).copied();
        let mut drives: Vec<usize> = columns
            .filter(|column| *column < names.len() && !reported.contains(column))
            .collect();
        drives.sort_unstable();
        let Some(last) = drives.pop() else {
            continue;
        };
        reported.push(last);
        let drive = names[last];
        let others = drives.iter().map(|other| names[*other]);
        let others = others.filter(|other| *other != drive);
        let mut others: Vec<String> = others.map(|other| format!("`{other}`")).collect();
        others.dedup();
        let others = if others.is_empty() {
            "what keeps the constraints".to_owned()
        } else {
            others.join(" and ")
        };
        let message =
            format!("`{drive}` is not determined: {others} can replace it; give its value");
        errors.push(drive.span(), message);
    }
}

/// Reports freedoms whose accelerations no open drive can produce: those whose balances are left
/// over. Constraints that are trivial on a branch leave such rows, too; then nothing is reported.
fn report_undriven(system: &System, closed: &Closed, spare: &[(usize, Id)], errors: &mut Errors) {
    if closed.rows().any(|row| row.activity.condition.is_some()) {
        return;
    }
    let joints = system.joints.iter().filter(|joint| !joint.is_driven());
    let mut by_freedom = joints.flat_map(|joint| joint.open.iter().map(move |_| &joint.name));
    if let Some(joint) = spare.iter().find_map(|(row, _)| by_freedom.nth(*row)) {
        let message = format!(
            "nothing drives `{joint}`, nor what moves with it: `inverse` gives the accelerations \
             of all joints, and needs as many open drives as the linkage has degrees of freedom"
        );
        errors.push(joint.span(), message);
    }
}

/// The load along each open freedom that produces the given acceleration, minus the known loads
/// there, joint by joint.
fn needed(system: &System, work: &mut Workspace, equations: &SystemEquations) -> Vec<Id> {
    let tree = moved_in_world(work, &equations.reduced);
    let given: Vec<Vec<Id>> = system.joints.iter().map(TreeJoint::accelerations).collect();
    lacking_with(work, equations, &tree, &given)
}

/// The same for a tree with these accelerations, joint by joint.
pub fn lacking_with(
    work: &mut Workspace,
    equations: &SystemEquations,
    tree: &Tree,
    given: &[Vec<Id>],
) -> Vec<Id> {
    let by_link = by_link(equations, tree, given);
    tree::lacking((&mut work.graph, &mut work.labels), tree, &by_link)
}

/// The load that the joint of every link transmits, with these accelerations, joint by joint.
fn loads(
    work: &mut Workspace,
    equations: &SystemEquations,
    tree: &Tree,
    accelerations: &[Vec<Id>],
) -> Vec<SpatialVector> {
    let by_link = by_link(equations, tree, accelerations);
    tree::joint_loads((&mut work.graph, &mut work.labels), tree, &by_link)
}

/// The accelerations of the joints, link by link.
pub fn by_link(
    equations: &SystemEquations,
    tree: &Tree,
    accelerations: &[Vec<Id>],
) -> Vec<Vec<Id>> {
    let mut by_link: Vec<Vec<Id>> = Vec::new();
    for (links, joint) in equations.built.links.iter().zip(accelerations) {
        let mut rest = joint.iter().copied();
        for link in links.clone() {
            let count = tree.links[link].open().count();
            by_link.push(rest.by_ref().take(count).collect());
        }
    }
    by_link
}

/// The names of all joints, including those that close loops, each with its force and moment on the
/// body that it carries, at its point on that body, in world axes. Drives are included.
pub fn derive_system_reactions(
    system: &System,
    work: &mut Workspace,
    equations: &SystemEquations,
) -> Vec<(Ident, [Components; 2])> {
    let tree = equations.loaded();
    let loads = loads(work, equations, tree, &equations.accelerations);
    let joints = (0..system.joints.len()).map(|body| {
        let link = equations.built.body(body);
        let load = tree::in_world(&mut work.graph, &tree.links, link, loads[link]);
        [load.linear, load.angular]
    });
    let joints: Vec<[Components; 2]> = joints.collect();
    let closed = equations.closed.iter().flat_map(|closed| &closed.wrenches);
    let closed = closed.map(|wrench| wrench.map(|part| part.map(|one| work.graph.result(one))));
    let closed: Vec<[Components; 2]> = closed.collect();
    named(system, &joints, &closed)
}

/// The symbols of the loads of joints that checks use, each with its expression. It has no value if
/// the balances do not determine a load of the joint.
pub fn derive_system_held(
    system: &System,
    work: &mut Workspace,
    equations: &SystemEquations,
) -> Vec<(Id, Id)> {
    let asked = &system.checks.held;
    if asked.is_empty() {
        return Vec::new();
    }
    let open = derive_system_open(system, work, equations);
    let found = derive_system_reactions(system, work, equations);
    let none = work.graph.undefined();
    let known = asked.iter().flat_map(|(joint, symbols)| {
        let found = found.iter().find(|(name, _)| name == joint);
        let is_open = open.iter().any(|(name, _)| name == joint);
        let found = found.filter(|_| !is_open).map(|(_, parts)| parts.concat());
        let found = found.unwrap_or_else(|| vec![none; 6]);
        symbols.concat().into_iter().zip(found)
    });
    known.collect()
}

/// The loads that the balances do not determine, in order: the name of the joint, link or
/// constraint, and the part of its load in words.
pub fn derive_system_open(
    system: &System,
    work: &Workspace,
    equations: &SystemEquations,
) -> Vec<(Ident, String)> {
    let closed = equations.closed.iter();
    let spare: Vec<&Spare> = closed
        .flat_map(|closed| &closed.undetermined.spare)
        .collect();
    let is_open = |part: &dyn Fn(&Spare) -> Id| {
        let mut parts = spare.iter().map(|spare| part(spare));
        parts.any(|part| !work.graph.vanishes(part))
    };
    let mut open = Vec::new();
    for (number, joint) in system.connections().enumerate() {
        let name = &joint.name;
        for (part, word) in ["force", "moment"].into_iter().enumerate() {
            for (axis, letter) in AXES.into_iter().enumerate() {
                if is_open(&|spare| spare.wrench(number)[part][axis]) {
                    let said = component(&name.to_string(), (word, letter), system.is_planar);
                    open.push((name.clone(), said));
                }
            }
        }
    }
    for (number, constraint) in system.constraints.list.iter().enumerate() {
        if is_open(&|spare| spare.loads[number]) {
            let name = constraint.name.replace('.', "_");
            let said = format!("`{name}`");
            open.push((Ident::new(&name, constraint.place.span()), said));
        }
    }
    open
}

/// Changes after which all loads are determined, in words.
pub fn derive_system_release(
    system: &System,
    work: &mut Workspace,
    equations: &SystemEquations,
) -> String {
    let closed = equations.closed.as_ref();
    closed.map_or_else(String::new, |closed| {
        release(system, work, &closed.undetermined)
    })
}

/// The known loads of the joints of the tree and of those that close loops, with their names.
fn named(
    system: &System,
    joints: &[[Components; 2]],
    closings: &[[Components; 2]],
) -> Vec<(Ident, [Components; 2])> {
    let all = system.connections().zip(joints.iter().chain(closings));
    all.map(|(joint, wrench)| (joint.name.clone(), *wrench))
        .collect()
}

/// The drives that produce prescribed motions: the load along each freedom whose motion is
/// prescribed, minus the other known loads there, joint by joint.
pub fn derive_system_driving(work: &mut Workspace, equations: &SystemEquations) -> Vec<Vec<Id>> {
    let tree = equations.loaded();
    let loads = loads(work, equations, tree, &equations.accelerations);
    let joints = equations.built.links.iter().map(|links| {
        let links = links.clone().map(|link| (&tree.links[link], loads[link]));
        let freedoms = links.flat_map(|(link, load)| {
            let driven = link.freedoms.iter().filter(|one| one.given.is_some());
            driven.filter_map(move |freedom| Some((freedom, load, freedom.given?)))
        });
        let drives = freedoms.map(|(freedom, load, given)| {
            let drive = tree::lacks(&mut work.graph, freedom, load, given);
            work.graph.result(drive)
        });
        drives.collect()
    });
    joints.collect()
}
