//! The balances of each body of a system: the given loads, those of its joints, and those of its
//! motion.

use proc_macro2::Ident;

use crate::families::LoadKind;
use crate::mechanics::answers::{Balance, LoadExpressions, Resultant};
use crate::mechanics::tree::{self, LinkMotion};
use crate::mechanics::variation::derive_unit_loads;
use crate::model::{
    Connection, Frame, Load, Meaning, Member, System, TreeJoint, Vector, Workspace,
};
use crate::symbolic::{Id, Stage};

use super::equations::SystemEquations;
use super::loads::by_link;

/// The balances of all bodies, each after its carrier; `holding` are the joints whose loads are
/// given.
pub fn derive_system_balances(
    system: &System,
    work: &mut Workspace,
    equations: &SystemEquations,
    holding: &[Ident],
) -> Vec<Balance> {
    let given: Vec<Vec<Id>> = system.joints.iter().map(TreeJoint::accelerations).collect();
    let built = &equations.built;
    let by_link = by_link(equations, &built.tree, &given);
    let motions = tree::motions((&mut work.graph, &mut work.labels), &built.tree, &by_link);
    let carried = joint_loads(system, work, holding);
    let kept = loads_of_constraints(system, work);
    let values = equations.values();
    let bodies = system.bodies.iter().enumerate();
    let balances = bodies.map(|(number, body)| {
        let loads = || body.weights.iter().chain(&body.loads);
        let zeros = work.graph.zeros();
        let (force, moment) = tree::wrench(work, body, loads(), zeros);
        let given = [force, moment].map(|part| work.vector(body.state.body, part));
        let mut residual = given;
        for load in of_joints(system, work, &carried, number) {
            residual = summed(work, residual, load);
        }
        for load in of_constraints(system, work, &kept, number) {
            residual = summed(work, residual, load);
        }
        let moving = &motions[built.body(number)];
        let taken = taken(system, work, body, moving, number);
        let applied = in_world(work, given, &body.name);
        let inertial = taken.map(|part| work.negate(part));
        let residual = summed(work, residual, inertial);
        let at = |load: &Load| (load.point, load.moment);
        let listed = loads().map(|load| LoadExpressions::new(&body.state, work, load, at(load)));
        let loads = listed.collect();
        let mut balance = Balance {
            applied,
            residual: in_world(work, residual, &body.name),
            loads,
        };
        balance.put_solved(work, values);
        balance
    });
    balances.collect()
}

fn summed(work: &mut Workspace, whole: [Vector; 2], part: [Vector; 2]) -> [Vector; 2] {
    [work.add(whole[0], part[0]), work.add(whole[1], part[1])]
}

/// The loads of joints on a body; the moment is about its G.
fn of_joints(
    system: &System,
    work: &mut Workspace,
    carried: &[(&Connection, [Vector; 2])],
    number: usize,
) -> Vec<[Vector; 2]> {
    let body = &system.bodies[number];
    let at_body = |joint: &Connection| joint.carried == number || joint.carrier == Some(number);
    let loads = carried.iter().filter(|(joint, _)| at_body(joint));
    let loads = loads.map(|(joint, [force, moment])| {
        // the point at which the joint holds the carried body
        let other = &system.bodies[joint.carried];
        let pin = work.vector(other.state.body, joint.pin);
        let place = work.add(other.state.position, pin);
        let back = work.negate(body.state.position);
        let arm = work.add(place, back);
        let lever = work.cross(arm, *force);
        let whole = [*force, work.add(*moment, lever)];
        if joint.carried == number {
            whole
        } else {
            whole.map(|part| work.negate(part))
        }
    });
    loads.collect()
}

/// The loads of written constraints on a body; the moment is about its G.
fn of_constraints(
    system: &System,
    work: &mut Workspace,
    kept: &[Vec<[Vector; 2]>],
    number: usize,
) -> Vec<[Vector; 2]> {
    let pin = work.vector(system.bodies[number].state.body, system.joints[number].pin);
    let loads = kept.iter().filter_map(|on| on.get(number));
    let loads = loads.map(|[force, moment]| {
        let lever = work.cross(pin, *force);
        [*force, work.add(*moment, lever)]
    });
    loads.collect()
}

/// The given force and moment of each joint on the body that it carries, in world axes.
fn joint_loads<'a>(
    system: &'a System,
    work: &mut Workspace,
    holding: &[Ident],
) -> Vec<(&'a Connection, [Vector; 2])> {
    let loads = system.connections().filter_map(|joint| {
        let place = holding.iter().position(|name| *name == joint.name)?;
        let kinds = [(0, LoadKind::Force), (1, LoadKind::Moment)];
        let load = kinds.map(|(part, kind)| {
            let mut components = work.graph.zeros();
            for axis in kind.axes(system.is_planar) {
                let meaning = Meaning::Reaction(2 * place + part, axis);
                components[axis] = work.symbol(Stage::State, meaning);
            }
            work.vector(Frame::WORLD, components)
        });
        Some((joint, load))
    });
    loads.collect()
}

/// The loads of each written constraint on each body, from the given load of the constraint. They
/// act at the point that the joint of the body holds.
fn loads_of_constraints(system: &System, work: &mut Workspace) -> Vec<Vec<[Vector; 2]>> {
    let Some(form) = &system.constraints.form else {
        return Vec::new();
    };
    let levels = system.constraints.list.iter().map(|one| one.level);
    let units = derive_unit_loads(work, form, levels).into_iter();
    let units = units.zip(&system.constraints.loads).map(|(unit, load)| {
        let on = system.bodies.iter().map(|body| {
            let mut drawn = form.bodies.iter().zip(&unit.on);
            let found = drawn.find(|(displaced, _)| displaced.body == body.state.body);
            found.map_or([Vector::ZERO; 2], |(_, draw)| {
                let moment = work.vector(body.state.body, draw.moment);
                [draw.force, moment].map(|part| work.scale(*load, part))
            })
        });
        on.collect()
    });
    units.collect()
}

/// `m a_G` and `J w' + w x J w`: the loads that the motion of a body takes.
fn taken(
    system: &System,
    work: &mut Workspace,
    body: &Member,
    moving: &LinkMotion,
    number: usize,
) -> [Vector; 2] {
    let graph = &mut work.graph;
    // from the joint to G
    let back = graph.negate_vector(system.joints[number].pin);
    let swept = graph.transform(&moving.sweep, back);
    let acceleration = graph.add_vectors(moving.acceleration.linear, swept);
    let rate = moving.acceleration.angular;
    let change = body.inertia.change(graph, moving.w, rate);
    let falling = work.vector(body.state.body, acceleration);
    let gravity = work.vector(Frame::WORLD, system.gravity);
    let whole = work.add(falling, gravity);
    [
        work.scale(body.mass, whole),
        work.vector(body.state.body, change),
    ]
}

fn in_world(work: &mut Workspace, parts: [Vector; 2], body: &Ident) -> Resultant {
    let names = ["force", "moment"];
    let [force, moment] = [0, 1].map(|part| {
        let components = work.components(parts[part], Frame::WORLD);
        let components = work.graph.results(components);
        let name = format!("{}_{body}", names[part]);
        work.labels.vector(&name, components);
        components
    });
    Resultant { force, moment }
}
