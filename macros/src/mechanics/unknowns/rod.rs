//! Unknown loads of a rod.

use crate::errors::{Errors, Extent};
use crate::mechanics::balances::turning;
use crate::model::{Axis, Workspace};
use crate::symbolic::{Components, Id};

/// Nothing balances a moment about the axis: that of one unit of each unknown, with its name and
/// its place, has no such part.
pub fn check_across(
    work: &mut Workspace,
    axis: Axis,
    moments: &[(String, Extent, Components)],
    errors: &mut Errors,
) -> Option<()> {
    let graph = &mut work.graph;
    let along = moments
        .iter()
        .map(|(_, _, moment)| graph.dot(axis.unit, *moment));
    let parts: Vec<Id> = along.collect();
    let wrong = turning(work, &parts);
    for index in &wrong {
        let (name, place, _) = &moments[*index];
        errors.push(
            *place,
            format!(
                "`{name}` has a moment about the axis, about which a rod has no inertia: let it act on \
                 the axis, or write a direction across it, as in `_ * axis.cross(k)`"
            ),
        );
    }
    wrong.is_empty().then_some(())
}
