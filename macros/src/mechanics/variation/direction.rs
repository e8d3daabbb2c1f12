//! Directions in which a state may change: tangent vectors of the space of states.
//!
//! The attitude changes by a small rotation phi, whatever its form: vectors fixed in the body
//! Whatever its form, an attitude changes by a small rotation phi. Vectors fixed in the body change
//! by `phi x r`, and a quaternion by
//! ```text
//! q' = q (0, phi) / 2    phi in body axes        q' = (0, phi) q / 2    phi in world axes
//! ```

use std::collections::BTreeMap;

use crate::model::{Attitude, Frame, Model, Vector, Workspace, input_rates};
use crate::symbolic::{Components, Graph, Id, Node, Number};

/// A direction in the space of states.
pub struct Direction {
    /// The change of each symbol. Symbols that are not listed are constant.
    pub changes: BTreeMap<Id, Id>,
    /// The rotation of each frame relative to its carrier. Frames that are not listed do not
    /// rotate.
    pub turns: BTreeMap<Frame, Vector>,
}

impl Direction {
    /// The motion of the body and the rates of user-defined states, with constant velocities, and
    /// constant inputs unless they are `.moving`.
    pub fn motion(model: &Model, work: &mut Workspace) -> Self {
        let state = &model.state;
        let phi = work.vector(state.axes, state.angular_velocity);
        let mut motion = Self::turn(work, model.state.body, phi);
        let [place, velocity] = world_parts(work, [state.position, state.velocity]);
        let (graph, changes) = (&work.graph, &mut motion.changes);
        changes.insert(state.time, graph.one());
        changes.extend(state.angle);
        change(graph, changes, place, velocity);
        if let Some(axis) = state.axis {
            change(graph, changes, axis.unit, axis.rate);
        }
        changes.extend(input_rates(work, &model.derivatives));
        let states = model.states.iter();
        changes.extend(states.map(|state| (state.symbol, state.rate)));
        motion
    }

    /// A rotation of the world about `e`: vectors written in its axes rotate with it.
    pub fn turn_of_world(model: &Model, work: &mut Workspace, e: Components) -> Self {
        let state = &model.state;
        let phi = work.vector(Frame::WORLD, e);
        let mut turn = Self::turn(work, model.state.body, phi);
        let linear = world_parts(work, [state.position, state.velocity]).into_iter();
        let graph = &mut work.graph;
        for vector in linear.chain(state.axis.map(|axis| axis.rate)) {
            let by = graph.cross(e, vector);
            change(graph, &mut turn.changes, vector, by);
        }
        turn
    }

    /// A backward rotation of the body axes about `e`: the components of vectors written in them
    /// rotate forward about `e`.
    pub fn turn_of_axes(model: &Model, work: &mut Workspace, e: Components) -> Self {
        let w = model.state.angular_velocity;
        let back = work.graph.negate_vector(e);
        let phi = work.vector(model.state.axes, back);
        let mut turn = Self::turn(work, model.state.body, phi);
        let by = work.graph.cross(e, w);
        change(&work.graph, &mut turn.changes, w, by);
        turn
    }

    /// A change of one symbol by one, with its consequences: if the symbol is an angle, the axes
    /// rotate with it. Without a symbol, nothing changes.
    pub fn of_symbol(work: &mut Workspace, symbol: Option<Id>) -> Self {
        let one = work.graph.one();
        let mut turns = BTreeMap::new();
        for frame in work.turned_frames() {
            let Attitude::Axis { angle, direction } = work.attitude(frame) else {
                continue;
            };
            if work.graph.depends_on(&[angle], |id| Some(id) == symbol) {
                let is_it = |id: Id| (Some(id) == symbol).then_some(one);
                let by = work.graph.change(&[angle], is_it)[0];
                let phi = work.graph.scale_vector(by, direction);
                turns.insert(frame, work.vector(frame, phi));
            }
        }
        Self {
            changes: symbol.map(|symbol| (symbol, one)).into_iter().collect(),
            turns,
        }
    }

    /// A rotation of the body, with everything else constant.
    pub fn turn(work: &mut Workspace, body: Frame, phi: Vector) -> Self {
        let [own, world] = [body, Frame::WORLD].map(|frame| work.part(phi, frame));
        let attitude = work.attitude(body);
        let graph = &mut work.graph;
        let mut changes = BTreeMap::new();
        match attitude {
            Attitude::Fixed => {}
            Attitude::Axis { angle, direction } => {
                let both = graph.add_vectors(own, world);
                changes.insert(angle, graph.dot(direction, both));
            }
            Attitude::Line { axis, .. } => {
                let by = graph.cross(world, axis);
                change(graph, &mut changes, axis, by);
            }
            Attitude::Quaternion { scalar, vector } => {
                let half = graph.number(Number::ratio(1, 2));
                let both = graph.add_vectors(own, world);
                let along = graph.dot(vector, both);
                let along = graph.multiply(half, along);
                changes.insert(scalar, graph.negate(along));
                let apart = graph.subtract_vectors(own, world);
                let swept = graph.cross(vector, apart);
                let kept = graph.scale_vector(scalar, both);
                let twice = graph.add_vectors(kept, swept);
                let by = graph.scale_vector(half, twice);
                change(graph, &mut changes, vector, by);
            }
        }
        Self {
            changes,
            turns: BTreeMap::from([(body, phi)]),
        }
    }
}

fn world_parts(work: &Workspace, vectors: [Vector; 2]) -> [Components; 2] {
    vectors.map(|vector| work.part(vector, Frame::WORLD))
}

/// Adds the change of a vector of the state. Components that the motion does not have are constant.
fn change(graph: &Graph, changes: &mut BTreeMap<Id, Id>, vector: Components, by: Components) {
    let is_symbol = |id: Id| matches!(graph.node(id), Node::Symbol(_)) && !graph.is_early(id);
    let parts = vector.into_iter().zip(by);
    changes.extend(parts.filter(|(part, _)| is_symbol(*part)));
}
