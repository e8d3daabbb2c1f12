//! The acceleration that one load makes by itself.

use crate::model::{Inertia, Model};
use crate::symbolic::Components;

use super::dyadic::{Dyadic, cheapest};
use super::euler_equations::{inverse_inertia, is_diagonal};
use super::newton_euler::inertia_about_center;

/// Of a force (world axes) and a moment about the center (body axes): `F / m`, `J^-1 M`, as far as
/// the motion has them.
pub fn response(
    model: &mut Model,
    force: Components,
    moment: Components,
) -> (Components, Components) {
    let graph = &mut model.frames.graph;
    let (zeros, one) = (graph.zeros(), graph.one());
    let linear = match model.mass {
        Some(mass) if model.motion.translates() => {
            let inverse_mass = graph.divide(one, mass);
            model.frames.labels.name(inverse_mass, "inverse_mass");
            model.frames.graph.scale_vector(inverse_mass, force)
        }
        _ => zeros,
    };
    if !model.motion.has_attitude() || model.frames.graph.is_zero_vector(&moment) {
        return (linear, zeros);
    }
    let angular = match inertia_about_center(model) {
        Inertia::Absent => zeros,
        Inertia::Scalar(inertia) => {
            let inverse = model.frames.graph.divide(one, inertia);
            model.frames.labels.name(inverse, "inverse_inertia");
            model.frames.graph.scale_vector(inverse, moment)
        }
        Inertia::Spatial(rows) if is_diagonal(&model.frames.graph, &rows) => {
            let graph = &mut model.frames.graph;
            [0, 1, 2].map(|i| {
                let inverse = graph.divide(one, rows[i][i]);
                graph.multiply(inverse, moment[i])
            })
        }
        Inertia::Spatial(rows) => {
            let (graph, labels) = (&mut model.frames.graph, &mut model.frames.labels);
            let inverse = inverse_inertia(graph, labels, &rows);
            let full = graph.transform(&inverse, moment);
            let dyadic =
                Dyadic::of_inverse(graph, &rows).map(|inverse| inverse.transform(graph, moment));
            cheapest(graph, full, dyadic)
        }
    };
    (linear, angular)
}
