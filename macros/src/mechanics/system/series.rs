//! Taylor series of the motion of a system. Its coordinates are those of its joints, in the order
//! of its state.

use crate::errors::{Errors, Extent};
use crate::mechanics::answers::{SeriesInput, Taylor, polynomials};
use crate::model::{Own, System, Workspace};
use crate::symbolic::{Coordinate, Id};

use super::equations::loads;
use super::motion::positions;
use super::rates::velocities;

/// The recurrences, if they exist. Obstacles are reported where the series is requested. The joints
/// are in the order of the state, each with its accelerations.
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
    coordinates.extend(system.states.iter().map(Own::coordinate));
    let time = system.bodies.first().map(|body| body.state.time);
    let moving = SeriesInput {
        coordinates,
        polynomials: polynomials(time, &system.derivatives, work),
        loads: loads(system, work),
        cables: system
            .cables
            .iter()
            .map(|cable| cable.name.to_string())
            .collect(),
    };
    moving.expand(work, None, asked, errors)
}
