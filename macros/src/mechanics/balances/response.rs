//! The acceleration due to a single load.

use crate::model::{Inertia, Model, Pair, Workspace};
use crate::symbolic::Components;

use super::dyadic::{Dyadic, cheapest};
use super::euler_equations::{inverse_inertia, is_diagonal};
use super::moments::{inertia_about_center, moment_of_inertia};

/// The part of a moment about the center along the free rotations of the body. For a hinge, the
/// part along its axis takes the place of z.
pub fn free_moment(model: &Model, work: &mut Workspace, moment: Components) -> Components {
    let graph = &mut work.graph;
    match model.hinge(graph) {
        Some(d) => {
            let zero = graph.zero();
            [zero, zero, graph.dot(d, moment)]
        }
        None => moment,
    }
}

/// The response to a force and a [`free_moment`] about the center: `F / m` and `J^-1 M`, as far as
/// the motion has these accelerations.
pub fn response(model: &Model, work: &mut Workspace, load: Pair) -> Pair {
    let (force, moment) = (load.linear, load.angular);
    let graph = &mut work.graph;
    let zeros = graph.zeros();
    let linear = match model.moved_mass() {
        Some(mass) => {
            let inverse_mass = graph.inverse_of_positive(mass);
            work.labels.name(inverse_mass, "inverse_mass");
            work.graph.scale_vector(inverse_mass, force)
        }
        None => zeros,
    };
    if !model.motion.has_attitude() || work.graph.is_zero_vector(&moment) {
        return Pair {
            linear,
            angular: zeros,
        };
    }
    let mut inertia = inertia_about_center(model, work);
    if let Some(d) = model.hinge(&mut work.graph) {
        inertia = Inertia::Scalar(moment_of_inertia(work, &inertia, d));
    }
    let angular = match inertia {
        Inertia::Absent => zeros,
        Inertia::Scalar(inertia) => {
            let inverse = work.graph.inverse_of_positive(inertia);
            work.labels.name(inverse, "inverse_inertia");
            work.graph.scale_vector(inverse, moment)
        }
        Inertia::Spatial(rows) if is_diagonal(&work.graph, &rows) => {
            let graph = &mut work.graph;
            [0, 1, 2].map(|i| {
                let inverse = graph.inverse_of_positive(rows[i][i]);
                graph.multiply(inverse, moment[i])
            })
        }
        Inertia::Spatial(rows) => {
            let (graph, labels) = (&mut work.graph, &mut work.labels);
            let inverse = inverse_inertia(graph, labels, &rows);
            let full = graph.transform(&inverse, moment);
            let dyadic =
                Dyadic::of_inverse(graph, &rows).map(|inverse| inverse.transform(graph, moment));
            cheapest(graph, full, dyadic)
        }
    };
    Pair { linear, angular }
}
