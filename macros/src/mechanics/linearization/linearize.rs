//! The derivatives of accelerations with respect to states and inputs, and with respect to
//! parameters.

use crate::model::{Meaning, Outline, Workspace};

use super::blocks::{Linearization, assemble, blocks_by};
use super::changes::{Column, Directions, changes, components, of_inputs};
use super::differentiated::{Differentiated, Tangent};

/// The derivatives with respect to states and inputs.
pub fn linearize(
    outline: &Outline,
    subject: &impl Tangent,
    work: &mut Workspace,
    mut differentiated: Differentiated,
) -> Linearization {
    let mut directions = Directions::new();
    for (number, group) in outline.tangent().iter().enumerate() {
        let components = 0..group.size;
        let components = components.map(|component| subject.direction(work, group, component));
        directions.push((Column::State(number), components.collect()));
    }
    directions.extend(of_inputs(outline, work));
    let (roots, accelerations) = (
        differentiated.changing.clone(),
        differentiated.accelerations.clone(),
    );
    let changes = changes(work, &roots, &accelerations, &directions, |work, change| {
        differentiated.finish(work, change)
    });
    let spin = |work: &Workspace, joint: usize| subject.spin(work, joint);
    assemble(outline, work, accelerations, &changes, spin)
}

/// The derivatives with respect to parameters. Since nothing moves, the chain rule passes through
/// rotations as through any other expressions, and through expressions of parameters alone.
pub fn sensitivity(
    outline: &Outline,
    work: &mut Workspace,
    mut differentiated: Differentiated,
) -> Linearization {
    let params = (0..outline.params.len()).map(|number| {
        let symbols = components(work, |part| Meaning::Param(number, part)).into_iter();
        let changes = symbols.map(|symbol| {
            let (graph, roots) = (&mut work.graph, &differentiated.changing);
            let one = graph.one();
            let change = graph.change(roots, |id| (id == symbol).then_some(one));
            differentiated.finish(work, change)
        });
        (Column::Param(number), changes.collect())
    });
    let changes = params.collect();
    blocks_by(outline, work, differentiated.accelerations, &changes)
}
