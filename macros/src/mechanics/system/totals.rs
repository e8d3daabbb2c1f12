//! Energy and momentum of a system.

use crate::mechanics::answers::{Energy, Momentum, done_by_field};
use crate::mechanics::balances::quadratic;
use crate::model::{Frame, System, Vector, Workspace};
use crate::symbolic::Number;

/// `sum of (m v^2 + w . J w) / 2`, and `-F . x` of every uniform field, which acts at x.
pub fn derive_system_energy(system: &System, work: &mut Workspace) -> Energy {
    let (mut twice, mut potential) = (work.graph.zero(), work.graph.zero());
    let gravity = work.vector(Frame::WORLD, system.gravity);
    for joint in &system.joints {
        let square = joint.armature.and_then(|armature| {
            let rate = joint.rate()?;
            let square = work.graph.multiply(rate, rate);
            Some(work.graph.multiply(armature, square))
        });
        twice = square.map_or(twice, |square| work.graph.add(twice, square));
    }
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
            if let Some(done) = done_by_field(work, &body.state, load) {
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

/// The momentum of the whole system, in world axes: linear, angular about the G of the system, and
/// angular about the origin of the world.
///
/// The angular momentum about G is computed from positions and velocities relative to the first
/// body, so that it keeps its digits far from the origin.
pub fn derive_system_momentum(system: &System, work: &mut Workspace) -> Momentum {
    let (mut mass, mut linear) = (work.graph.zero(), Vector::ZERO);
    let (mut first, mut drift) = (Vector::ZERO, Vector::ZERO);
    let mut relative = Vec::new();
    let start = system.bodies.first().map(|body| &body.state);
    let start = start.map(|state| [state.position, state.velocity]);
    let [position, velocity] = start.unwrap_or([Vector::ZERO; 2]);
    for body in &system.bodies {
        mass = work.graph.add(mass, body.mass);
        let own = work.scale(body.mass, body.state.velocity);
        linear = work.add(linear, own);
        let arm = subtract(work, body.state.position, position);
        let rate = subtract(work, body.state.velocity, velocity);
        let (moved, driven) = (work.scale(body.mass, arm), work.scale(body.mass, rate));
        (first, drift) = (work.add(first, moved), work.add(drift, driven));
        relative.push((body, arm, rate));
    }
    let one = work.graph.one();
    let per_mass = work.graph.divide(one, mass);
    let (center, drift) = (work.scale(per_mass, first), work.scale(per_mass, drift));
    let mut about_center = Vector::ZERO;
    for (body, arm, rate) in relative {
        let (arm, rate) = (subtract(work, arm, center), subtract(work, rate, drift));
        let own = work.scale(body.mass, rate);
        let lever = cross_in_world(work, arm, own);
        let spin = body
            .inertia
            .times(&mut work.graph, body.state.angular_velocity);
        let spin = work.vector(body.state.body, spin);
        for part in [lever, spin] {
            about_center = work.add(about_center, part);
        }
    }
    let center = work.add(position, center);
    let carried = cross_in_world(work, center, linear);
    let about_pole = work.add(about_center, carried);
    let world = |work: &mut Workspace, vector: Vector| work.components(vector, Frame::WORLD);
    Momentum {
        linear: world(work, linear),
        angular: world(work, about_center),
        about_pole: world(work, about_pole),
    }
}

fn subtract(work: &mut Workspace, a: Vector, b: Vector) -> Vector {
    let b = work.negate(b);
    work.add(a, b)
}

fn cross_in_world(work: &mut Workspace, a: Vector, b: Vector) -> Vector {
    let [a, b] = [a, b].map(|vector| work.components(vector, Frame::WORLD));
    let product = work.graph.cross(a, b);
    work.vector(Frame::WORLD, product)
}
