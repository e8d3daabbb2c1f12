//! Kinetic energy.

use crate::model::{Inertia, Model, Workspace};
use crate::symbolic::Id;

use super::dyadic::quadratic;
use super::moments::inertia_about_center;

/// `m v^2 + w . J w`
pub fn twice_kinetic(model: &Model, work: &mut Workspace) -> Id {
    let translation = match model.moved_mass() {
        Some(mass) => {
            let square = work.norm_squared(model.state.velocity);
            work.graph.multiply(mass, square)
        }
        None => work.graph.zero(),
    };
    let inertia = inertia_about_center(model, work);
    let graph = &mut work.graph;
    let rotation = match inertia {
        Inertia::Absent => graph.zero(),
        Inertia::Scalar(moment) => {
            let square = graph.norm_squared(model.state.turn_rate());
            graph.multiply(moment, square)
        }
        Inertia::Spatial(rows) => quadratic(graph, &rows, model.state.angular_velocity),
    };
    graph.add(translation, rotation)
}
