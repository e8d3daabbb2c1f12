//! The balances of each body of a system as they are written: given loads, those of its joints, and
//! what its motion takes.

use proc_macro2::Ident;

use crate::mechanics::answers::{LoadExpressions, Resultant};
use crate::mechanics::tree::{self, Moving};
use crate::mechanics::variation::derive_unit_loads;
use crate::model::{Frame, Load, Meaning, Member, System, Vector, Workspace};
use crate::symbolic::{Components, Id, Stage};

use super::equations::SystemEquations;
use super::loads::{by_link, given_accelerations};

/// The expressions of `outputs: [balance]` of one body, world axes.
pub struct BodyBalance {
    /// Given loads, weight among them; moment about G.
    pub applied: Resultant,
    /// (1.3) and (1.4) about G, with the loads of all joints: zero on a true motion.
    pub residual: Resultant,
    pub loads: Vec<LoadExpressions>,
}

impl BodyBalance {
    pub fn roots(&self) -> Vec<Id> {
        let wrenches = [&self.applied, &self.residual].into_iter();
        let resultants = wrenches.flat_map(|wrench| [wrench.force, wrench.moment]);
        let loads = self.loads.iter();
        let loads = loads.flat_map(|load| [load.force, load.point, load.moment]);
        resultants.chain(loads).flatten().collect()
    }
}

/// The balances of all bodies, each after its carrier; `holding` are the joints whose loads are given.
pub fn derive_system_balances(
    system: &System,
    work: &mut Workspace,
    equations: &SystemEquations,
    holding: &[Ident],
) -> Vec<BodyBalance> {
    let given: Vec<Vec<Id>> = system.joints.iter().map(given_accelerations).collect();
    let built = &equations.built;
    let by_link = by_link(equations, &built.tree, &given);
    let motions = tree::motions(&mut work.graph, &built.tree, &by_link);
    let carried = joint_loads(system, work, holding);
    let kept = loads_of_constraints(system, work, 2 * holding.len());
    let mut all: Vec<BodyBalance> = Vec::new();
    for (number, body) in system.bodies.iter().enumerate() {
        let loads = || body.weights.iter().chain(&body.loads);
        let zeros = work.graph.zeros();
        let (force, moment) = tree::wrench(work, body, loads(), zeros);
        let [force, moment] = [force, moment].map(|part| work.vector(body.state.body, part));
        let mut sums = [force, moment];
        for (joint, [force, moment]) in &carried {
            let (on_it, is_carrier) = (joint.carried == number, joint.carrier == Some(number));
            if !on_it && !is_carrier {
                continue;
            }
            // where the joint holds what it carries
            let other = &system.bodies[joint.carried];
            let pin = work.vector(other.state.body, joint.pin);
            let place = work.add(other.state.position, pin);
            let back = work.negate(body.state.position);
            let arm = work.add(place, back);
            let lever = work.cross(arm, *force);
            let whole = work.add(*moment, lever);
            for (sum, part) in sums.iter_mut().zip([*force, whole]) {
                let part = if on_it { part } else { work.negate(part) };
                *sum = work.add(*sum, part);
            }
        }
        let pin = work.vector(body.state.body, system.joints[number].pin);
        for [force, moment] in kept.iter().filter_map(|on| on.get(number)) {
            let lever = work.cross(pin, *force);
            let whole = work.add(*moment, lever);
            sums = [work.add(sums[0], *force), work.add(sums[1], whole)];
        }
        let [taken_force, taken_moment] =
            taken(system, work, body, &motions[built.body(number)], number);
        let given = in_world(work, [force, moment], &body.name);
        let applied = applied(work, equations, &given);
        let [less_force, less_moment] = [taken_force, taken_moment].map(|part| work.negate(part));
        let residual = [
            work.add(sums[0], less_force),
            work.add(sums[1], less_moment),
        ];
        all.push(BodyBalance {
            applied,
            residual: in_world(work, residual, &body.name),
            loads: loads()
                .map(|load| listed(work, equations, body, load))
                .collect(),
        });
    }
    all
}

/// Which bodies a joint is between, and where it is on the one that it carries.
struct Between<'a> {
    name: &'a Ident,
    carrier: Option<usize>,
    carried: usize,
    pin: Components,
}

/// Force and moment of each joint on what it carries, as they are given, world axes.
fn joint_loads<'a>(
    system: &'a System,
    work: &mut Workspace,
    holding: &[Ident],
) -> Vec<(Between<'a>, [Vector; 2])> {
    let joints = system.joints.iter().map(|joint| Between {
        name: &joint.name,
        carrier: joint.carrier,
        carried: joint.carried,
        pin: joint.pin,
    });
    let closings = system.closings.iter().map(|joint| Between {
        name: &joint.name,
        carrier: joint.carrier,
        carried: joint.carried,
        pin: joint.pin,
    });
    let loads = joints.chain(closings).filter_map(|joint| {
        let place = holding.iter().position(|name| name == joint.name)?;
        let load = [0, 1].map(|part| {
            let axes = match (part, system.is_planar) {
                (0, true) => 0..2,
                (_, true) => 2..3,
                (_, false) => 0..3,
            };
            let mut components = work.graph.zeros();
            for axis in axes {
                let meaning = Meaning::Reaction(2 * place + part, axis);
                components[axis] = work.symbol(Stage::State, meaning);
            }
            work.vector(Frame::WORLD, components)
        });
        Some((joint, load))
    });
    loads.collect()
}

/// What each written constraint does to each body, at the point that its joint holds, as its load is
/// given; the first one has this number among the parts of the reactions.
fn loads_of_constraints(
    system: &System,
    work: &mut Workspace,
    first: usize,
) -> Vec<Vec<[Vector; 2]>> {
    let Some(form) = &system.constraints.form else {
        return Vec::new();
    };
    let levels = system.constraints.list.iter().map(|one| one.level);
    let units = derive_unit_loads(work, form, levels).into_iter();
    let units = units.enumerate().map(|(number, unit)| {
        let load = work.symbol(Stage::State, Meaning::Reaction(first + number, 0));
        let on = system.bodies.iter().map(|body| {
            let mut drawn = form.bodies.iter().zip(&unit.on);
            let found = drawn.find(|(displaced, _)| displaced.body == body.state.body);
            found.map_or([Vector::ZERO; 2], |(_, draw)| {
                let moment = work.vector(body.state.body, draw.moment);
                [draw.force, moment].map(|part| work.scale(load, part))
            })
        });
        on.collect()
    });
    units.collect()
}

/// `m a_G` and `J w' + w x J w`: what its motion takes.
fn taken(
    system: &System,
    work: &mut Workspace,
    body: &Member,
    moving: &Moving,
    number: usize,
) -> [Vector; 2] {
    let graph = &mut work.graph;
    // from the joint to G
    let back = graph.negate_vector(system.joints[number].pin);
    let swept = graph.transform(&moving.sweep, back);
    let acceleration = graph.add_vectors(moving.acceleration.linear, swept);
    let rows = body.inertia.rows(graph);
    let momentum = graph.transform(&rows, moving.w);
    let gyroscopic = graph.cross(moving.w, momentum);
    let change = graph.transform(&rows, moving.acceleration.angular);
    let change = graph.add_vectors(change, gyroscopic);
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

/// With what is found where loads follow those of constraints.
fn applied(work: &mut Workspace, equations: &SystemEquations, given: &Resultant) -> Resultant {
    let [force, moment] = [given.force, given.moment].map(|part| with_loads(work, equations, part));
    Resultant { force, moment }
}

fn with_loads(work: &mut Workspace, equations: &SystemEquations, part: Components) -> Components {
    let found = equations.with_loads(work, &part);
    [found[0], found[1], found[2]]
}

fn listed(
    work: &mut Workspace,
    equations: &SystemEquations,
    body: &Member,
    load: &Load,
) -> LoadExpressions {
    let place: Vector = body.state.place(work, load.point);
    let world = |work: &mut Workspace, vector: Vector| -> Components {
        let found = work.components(vector, Frame::WORLD);
        with_loads(work, equations, found)
    };
    LoadExpressions {
        name: load.name.to_string(),
        family: load.family,
        force: world(work, load.force),
        point: world(work, place),
        moment: world(work, load.moment),
    }
}
