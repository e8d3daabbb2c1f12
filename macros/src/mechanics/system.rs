//! The equations of a system, and what else is asked of it.

use crate::model::{Frame, Member, Rates, System, TreeJoint, Variable, Vector, Workspace};
use crate::symbolic::{Components, Id, Number};

use super::Report;
use super::answers::{
    Energy, Momentum, Partial, Switch, derive_switches, done_by_field, list_partial,
};
use super::balances::quadratic;
use super::tree::link::Tree;
use super::tree::{self, Built, Pair};

/// The equations of motion of a system.
pub struct SystemEquations {
    /// Of the freedoms of each joint.
    pub accelerations: Vec<Vec<Id>>,
    pub switches: Vec<Switch>,
    pub partial: Vec<Partial>,
    left_out: Vec<String>,
    /// With other origins and axes, and without what joints cannot tell.
    reduced: Tree,
    built: Built,
}

/// Derives the equations of motion of a system.
pub fn derive_system(system: &System, work: &mut Workspace) -> SystemEquations {
    let built = tree::build(system, work);
    let found = tree::derive_tree(&mut work.graph, &mut work.labels, &built.tree);
    let accelerations: Vec<Vec<Id>> = built
        .links
        .iter()
        .map(|links| found.accelerations[links.clone()].concat())
        .collect();
    let accelerations: Vec<Vec<Id>> = accelerations
        .into_iter()
        .map(|joint| {
            joint
                .into_iter()
                .map(|one| work.graph.result(one))
                .collect()
        })
        .collect();
    for (joint, found) in system.joints.iter().zip(&accelerations) {
        let names = joint.kind.shape.into_iter().flat_map(|shape| shape.second);
        let names = names.flat_map(|field| field.names);
        for (id, name) in found.iter().zip(names) {
            work.labels.name(*id, format!("{}_{name}", joint.name));
        }
    }
    let roots = accelerations.concat();
    let time = system.bodies.first().map(|body| body.state.time);
    let switches = time.map(|time| derive_switches(time, &system.derivatives, work, &roots));
    let loads = system.bodies.iter().flat_map(|body| &body.loads);
    SystemEquations {
        switches: switches.unwrap_or_default(),
        partial: list_partial(loads, work),
        accelerations,
        left_out: found.left_out,
        reduced: found.reduced,
        built,
    }
}

/// `sum of (m v^2 + w . J w) / 2`, and `-F . x` of every uniform field, `x` where it acts.
pub fn derive_system_energy(system: &System, work: &mut Workspace) -> Energy {
    let (mut twice, mut potential) = (work.graph.zero(), work.graph.zero());
    let gravity = work.vector(Frame::WORLD, system.gravity);
    for body in &system.bodies {
        let square = work.norm_squared(body.state.velocity);
        let moving = work.graph.multiply(body.mass, square);
        let rows = body.inertia.rows(&mut work.graph);
        let turning = quadratic(&mut work.graph, &rows, body.state.angular_velocity);
        for part in [moving, turning] {
            twice = work.graph.add(twice, part);
        }
        let weight = work.scale(body.mass, gravity);
        let done = work.dot(weight, body.state.position);
        potential = work.graph.subtract(potential, done);
        for load in &body.loads {
            if let Some(done) = done_by_field(work, &body.state, true, load) {
                potential = work.graph.subtract(potential, done);
            }
        }
    }
    for energy in &system.energies {
        potential = work.graph.add(potential, *energy);
    }
    let half = work.graph.number(Number::ratio(1, 2));
    Energy {
        kinetic: work.graph.distribute(half, twice),
        potential,
    }
}

/// Of the whole, in world axes: linear, about its own G, and about the origin of the world.
pub fn derive_system_momentum(system: &System, work: &mut Workspace) -> Momentum {
    let (mut linear, mut about_origin) = (Vector::ZERO, Vector::ZERO);
    let (mut first, mut mass) = (Vector::ZERO, work.graph.zero());
    for body in &system.bodies {
        let own = work.scale(body.mass, body.state.velocity);
        linear = work.add(linear, own);
        let moved = work.scale(body.mass, body.state.position);
        first = work.add(first, moved);
        mass = work.graph.add(mass, body.mass);
        let lever = cross_in_world(work, body.state.position, own);
        let spin = spin(work, body);
        for part in [lever, spin] {
            about_origin = work.add(about_origin, part);
        }
    }
    let one = work.graph.one();
    let per_mass = work.graph.divide(one, mass);
    let center = work.scale(per_mass, first);
    let carried = cross_in_world(work, center, linear);
    let carried = work.negate(carried);
    let about_center = work.add(about_origin, carried);
    let world = |work: &mut Workspace, vector: Vector| work.components(vector, Frame::WORLD);
    Momentum {
        linear: world(work, linear),
        angular: world(work, about_center),
        about_pole: world(work, about_origin),
    }
}

fn cross_in_world(work: &mut Workspace, a: Vector, b: Vector) -> Vector {
    let [a, b] = [a, b].map(|vector| work.components(vector, Frame::WORLD));
    let product = work.graph.cross(a, b);
    work.vector(Frame::WORLD, product)
}

/// `J w`
fn spin(work: &mut Workspace, body: &Member) -> Vector {
    let rows = body.inertia.rows(&mut work.graph);
    let spin = work.graph.transform(&rows, body.state.angular_velocity);
    work.vector(body.state.body, spin)
}

/// The load along each freedom of each joint that makes it accelerate as is given, less what is known
/// of its drive.
pub fn derive_system_inverse(
    system: &System,
    work: &mut Workspace,
    equations: &SystemEquations,
) -> Vec<Vec<Id>> {
    let given: Vec<Vec<Id>> = system.joints.iter().map(given_accelerations).collect();
    let loads = loads(work, equations, &equations.reduced, &given);
    let joints = system.joints.iter().zip(&equations.built.links);
    let drives = joints.map(|(joint, links)| {
        let mut found = Vec::new();
        for link in links.clone() {
            for freedom in &equations.reduced.links[link].freedoms {
                let needed = Pair::of(&freedom.twist).dot(&mut work.graph, loads[link]);
                let known = joint.drives[found.len()];
                found.push(work.graph.subtract(needed, known));
            }
        }
        found
    });
    let drives: Vec<Vec<Id>> = drives.collect();
    let (folded, images) = work.graph.folded(&drives.concat());
    work.labels.follow(&images);
    let mut folded = folded.into_iter().map(|one| work.graph.result(one));
    drives
        .iter()
        .map(|joint| folded.by_ref().take(joint.len()).collect())
        .collect()
}

/// The symbols of the accelerations of a joint, by its freedoms.
fn given_accelerations(joint: &TreeJoint) -> Vec<Id> {
    let second = joint.kind.shape.into_iter().flat_map(|shape| shape.second);
    let parts = second
        .flat_map(|field| (0..field.names.len()).map(|part| (field.variable, field.first + part)));
    let rates: &Rates = &joint.coordinates;
    parts
        .filter_map(|(variable, part): (Variable, usize)| rates.get(variable, part))
        .collect()
}

/// The load of every link, with these accelerations joint by joint.
fn loads(
    work: &mut Workspace,
    equations: &SystemEquations,
    tree: &Tree,
    accelerations: &[Vec<Id>],
) -> Vec<Pair> {
    let mut by_link: Vec<Vec<Id>> = Vec::new();
    for (links, joint) in equations.built.links.iter().zip(accelerations) {
        let mut rest = joint.iter().copied();
        for link in links.clone() {
            let count = tree.links[link].freedoms.len();
            by_link.push(rest.by_ref().take(count).collect());
        }
    }
    tree::joint_loads(&mut work.graph, tree, &by_link)
}

/// Force and moment of each joint on the body that it carries, at its point there, world axes, drives
/// included.
pub fn derive_system_reactions(
    work: &mut Workspace,
    equations: &SystemEquations,
) -> Vec<[Components; 2]> {
    let loads = loads(
        work,
        equations,
        &equations.built.tree,
        &equations.accelerations,
    );
    let built = &equations.built;
    let reactions = (0..built.links.len()).map(|body| {
        let link = built.body(body);
        let load = tree::in_world(&mut work.graph, &built.tree.links, link, loads[link]);
        [load.linear, load.angular]
    });
    reactions.collect()
}

/// The bodies and joints of a system, and what does not appear in its equations.
pub fn describe_system(system: &System, work: &Workspace, equations: &SystemEquations) -> Report {
    let name = |body: usize| format!("`{}`", system.bodies[body].name);
    let joints = system.joints.iter().map(|joint| {
        let carrier = joint.carrier.map_or("the ground".to_owned(), name);
        format!(
            "`{}`: {} from {carrier} to {}",
            joint.name,
            joint.kind.word,
            name(joint.carried)
        )
    });
    let mut skipped = equations.left_out.clone();
    if !work.graph.is_zero_vector(&system.gravity) {
        skipped
            .push("the weight of each body: the ground accelerates against it instead".to_owned());
    }
    let mut lists = vec![("Joints", joints.collect())];
    if !system.cables.is_empty() {
        let cables = system.cables.iter().map(|cable| {
            let ends = cable.bodies.each_ref().map(|body| match body {
                Some(body) => format!("`{body}`"),
                None => "the ground".to_owned(),
            });
            format!("`{}`: between {} and {}", cable.name, ends[0], ends[1])
        });
        lists.push(("Cables", cables.collect()));
    }
    Report { lists, skipped }
}
