//! Unknown loads of a rod.

use crate::errors::Errors;
use crate::mechanics::balances::turning;
use crate::model::{Axis, Model, Workspace};
use crate::symbolic::Id;

use super::pushes::Push;

/// The same of one unit of each unknown.
pub fn check_pushes(
    model: &Model,
    work: &mut Workspace,
    axis: Axis,
    pushes: &[Push],
    errors: &mut Errors,
) -> Option<()> {
    let graph = &mut work.graph;
    let parts: Vec<Id> = pushes
        .iter()
        .map(|push| graph.dot(axis.unit, push.moment))
        .collect();
    let wrong = turning(work, &parts);
    for index in &wrong {
        let name = pushes[*index].name(model);
        errors.push(
            pushes[*index].place,
            format!(
                "`{name}` has a moment about the axis, about which a rod has no inertia: let it act on \
                 the axis, or write a direction across it, as in `_ * axis.cross(k)`"
            ),
        );
    }
    wrong.is_empty().then_some(())
}
