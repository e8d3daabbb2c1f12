//! How the state of a system changes.

use std::collections::BTreeMap;

use crate::mechanics::answers::quaternion_rate;
use crate::mechanics::variation::Direction;
use crate::model::{Frame, Part, System, TreeJoint, Variable, Vector, Workspace, input_rates};
use crate::symbolic::{Coordinate, Id};

/// The change in time, with constant rates of joints, and constant inputs unless they are
/// `.moving`.
pub fn motion(system: &System, work: &mut Workspace) -> Direction {
    let mut changes = BTreeMap::new();
    let time = system.bodies.first().map(|body| body.state.time);
    changes.extend(time.map(|time| (time, work.graph.one())));
    changes.extend(input_rates(work, &system.derivatives));
    let states = system.states.iter();
    changes.extend(states.map(|state| (state.symbol, state.rate)));
    let mut turns = BTreeMap::new();
    for joint in &system.joints {
        let rates = |variable: Variable, part: usize| joint.coordinates.get(variable, part);
        // prescribed coordinates are functions of time and of user-defined states
        if !joint.is_driven() {
            changes.extend(places(work, joint, rates));
        }
        turns.extend(turns_of(joint, work, system.is_planar, rates));
    }
    Direction { changes, turns }
}

/// The change if one rate of a joint is one, and nothing else moves.
pub fn unit_motion(
    system: &System,
    work: &mut Workspace,
    joint: &TreeJoint,
    moving: (Variable, usize),
) -> Direction {
    let (zero, one) = (work.graph.zero(), work.graph.one());
    let rates = |variable: Variable, part: usize| {
        joint.coordinates.get(variable, part)?;
        Some(if (variable, part) == moving {
            one
        } else {
            zero
        })
    };
    Direction {
        changes: places(work, joint, rates).into_iter().collect(),
        turns: turns_of(joint, work, system.is_planar, rates)
            .into_iter()
            .collect(),
    }
}

/// The change of the coordinates of a joint at these rates.
fn places(
    work: &mut Workspace,
    joint: &TreeJoint,
    rates: impl Fn(Variable, usize) -> Option<Id>,
) -> Vec<(Id, Id)> {
    let moved = moved(work, joint, rates).into_iter();
    moved.map(|one| (one.symbol, one.rate)).collect()
}

/// The angular velocities of the frames of a joint at these rates, each relative to the frame
/// before.
fn turns_of(
    joint: &TreeJoint,
    work: &mut Workspace,
    is_planar: bool,
    rates: impl Fn(Variable, usize) -> Option<Id>,
) -> Vec<(Frame, Vector)> {
    let frames = &joint.frames[joint.turned.len()..];
    let zero = work.graph.zero();
    let get = |part: usize| rates(Variable::AngularVelocity, part).unwrap_or(zero);
    let mut turns = Vec::new();
    for ((part, coordinate), frame) in joint.kind.numbered().zip(frames) {
        let graph = &mut work.graph;
        let rate = match part {
            Part::Slide(_) => continue,
            Part::Turn(number) => graph.scale_vector(get(coordinate), joint.directions[number]),
            Part::Screw => graph.scale_vector(get(0), joint.directions[0]),
            Part::Free if is_planar => [zero, zero, get(0)],
            Part::Ball | Part::Free => [get(0), get(1), get(2)],
        };
        turns.push((*frame, work.vector(*frame, rate)));
    }
    turns
}

/// The coordinates of a joint in the state, with their rates of change.
pub fn positions(work: &mut Workspace, joint: &TreeJoint) -> Vec<Coordinate> {
    moved(work, joint, |variable, part| {
        joint.coordinates.get(variable, part)
    })
}

/// The same at these rates.
fn moved(
    work: &mut Workspace,
    joint: &TreeJoint,
    rates: impl Fn(Variable, usize) -> Option<Id>,
) -> Vec<Coordinate> {
    let mut list = Vec::new();
    for field in joint.kind.shape.into_iter().flat_map(|shape| shape.fields) {
        let of = |variable: Variable, part: usize| joint.coordinates.get(variable, part);
        let rate_of = match field.variable {
            Variable::Position => Variable::Velocity,
            Variable::Angle => Variable::AngularVelocity,
            Variable::Quaternion => {
                let symbols = [0, 1, 2, 3].map(|part| of(Variable::Quaternion, part));
                let w = [0, 1, 2].map(|part| rates(Variable::AngularVelocity, part));
                let ([Some(scalar), Some(x), Some(y), Some(z)], [Some(a), Some(b), Some(c)]) =
                    (symbols, w)
                else {
                    continue;
                };
                let rates = quaternion_rate(work, scalar, [x, y, z], [a, b, c]);
                let symbols = [x, y, z, scalar].into_iter();
                list.extend(
                    symbols
                        .zip(rates)
                        .map(|(symbol, rate)| Coordinate { symbol, rate }),
                );
                continue;
            }
            _ => continue,
        };
        let parts = field.first..field.first + field.names.len();
        list.extend(parts.filter_map(|part| {
            let (symbol, rate) = (of(field.variable, part)?, rates(rate_of, part)?);
            Some(Coordinate { symbol, rate })
        }));
    }
    list
}
