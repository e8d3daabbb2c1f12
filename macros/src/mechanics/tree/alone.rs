//! Bodies that only the ground holds and that carry no others. Each of them moves by the balances
//! of a single body.

use crate::mechanics::balances::solve_balances;
use crate::model::{Model, Part, Point, State, Support, System, Vector, Workspace};
use crate::symbolic::Id;

/// The accelerations along the coordinates of a joint whose body is alone.
pub fn alone(system: &System, work: &mut Workspace, number: usize) -> Option<Vec<Id>> {
    let model = as_single(system, work, number)?;
    let further = drive(system, work, number)?;
    let (found, _) = solve_balances(&model, work, &model.loads, vec![further], None);
    let linear = &found.linear[model.motion.linear_axes()];
    Some([linear, &found.angular[model.motion.angular_axes()]].concat())
}

/// The model of a single body for a body that is alone.
fn as_single(system: &System, work: &Workspace, number: usize) -> Option<Model> {
    let (joint, body) = (&system.joints[number], &system.bodies[number]);
    let mut others = system.joints.iter();
    let carries = others.any(|other| other.carrier == Some(number));
    if joint.carrier.is_some() || carries || joint.is_driven() || joint.armature.is_some() {
        return None;
    }
    let is_driven_so = !work.accelerations_in(&joint.drives).is_empty();
    if is_driven_so || body.loads.iter().any(|load| load.follows(work)) {
        return None;
    }
    let motion = joint.kind.motion(system.is_planar)?;
    let support = motion.is_supported().then(|| Support {
        offset: joint.pin,
        anchor: joint.place,
        direction: joint
            .directions
            .first()
            .copied()
            .filter(|_| motion.has_written_axis()),
    });
    let state = State {
        support,
        ..body.state
    };
    let loads = body.weights.iter().chain(&body.loads).cloned().collect();
    let pole = Point::Fixed(state.body, work.graph.zeros());
    Some(Model {
        is_differentiated: system.is_differentiated,
        ..Model::of(motion, state, (Some(body.mass), body.inertia), loads, pole)
    })
}

/// The moment of the drives of its joint, in body axes; `None` if some are forces.
fn drive(system: &System, work: &mut Workspace, number: usize) -> Option<Vector> {
    let (joint, body) = (&system.joints[number], &system.bodies[number]);
    let graph = &mut work.graph;
    let moment = match (joint.kind.parts, joint.drives.as_slice()) {
        ([Part::Ball], [x, y, z]) => [*x, *y, *z],
        ([Part::Turn(_)], [along]) => {
            let z = graph.unit_vectors()[2];
            let axis = joint.directions.first().filter(|_| !system.is_planar);
            graph.scale_vector(*along, axis.copied().unwrap_or(z))
        }
        (_, forces) if forces.iter().all(|one| graph.is_zero(*one)) => return Some(Vector::ZERO),
        _ => return None,
    };
    Some(work.vector(body.state.body, moment))
}
