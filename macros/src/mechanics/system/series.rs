//! Taylor series of the motion of a system: the coordinates of its joints, in the order of its state.

use crate::errors::{Errors, Extent};
use crate::mechanics::answers::{Moving, Taylor, quaternion_rate};
use crate::model::{Rates, System, TreeJoint, Variable, Workspace};
use crate::symbolic::{Coordinate, Id};

use super::equations::loads;
use super::rates::velocities;

/// The recurrences, if they exist; what is in their way is reported where they are asked for. The
/// joints are in the order in which the state has them, each with its accelerations.
pub fn derive_system_taylor(
    system: &System,
    work: &mut Workspace,
    asked: Extent,
    accelerations: &[Vec<Id>],
    errors: &mut Errors,
) -> Option<Taylor> {
    let mut coordinates = Vec::new();
    let joints = || {
        system
            .written
            .iter()
            .map(|joint| (&system.joints[*joint], *joint))
    };
    for (joint, _) in joints() {
        coordinates.extend(positions(work, joint));
    }
    for (joint, number) in joints() {
        let rates = velocities(joint).into_iter().zip(&accelerations[number]);
        coordinates.extend(rates.map(|(symbol, rate)| Coordinate {
            symbol,
            rate: *rate,
        }));
    }
    let unit = work.graph.one();
    coordinates.extend(system.bodies.first().map(|body| Coordinate {
        symbol: body.state.time,
        rate: unit,
    }));
    let moving = Moving {
        coordinates,
        loads: loads(system, work),
        derivatives: &system.derivatives,
    };
    moving.expand(work, None, asked, errors)
}

/// What is before the rates in the state of a joint, with its rates.
fn positions(work: &mut Workspace, joint: &TreeJoint) -> Vec<Coordinate> {
    let rates: &Rates = &joint.coordinates;
    let mut list = Vec::new();
    for field in joint.kind.shape.into_iter().flat_map(|shape| shape.fields) {
        let of = |variable: Variable, part: usize| rates.get(variable, part);
        let rate_of = match field.variable {
            Variable::Position => Variable::Velocity,
            Variable::Angle => Variable::AngularVelocity,
            Variable::Quaternion => {
                let symbols = [0, 1, 2, 3].map(|part| of(Variable::Quaternion, part));
                let w = [0, 1, 2].map(|part| of(Variable::AngularVelocity, part));
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
            let (symbol, rate) = (of(field.variable, part)?, of(rate_of, part)?);
            Some(Coordinate { symbol, rate })
        }));
    }
    list
}
