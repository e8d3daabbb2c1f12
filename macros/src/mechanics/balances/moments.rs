//! The inertia about G, or about the held point.

use crate::model::{Inertia, Model, Workspace};
use crate::symbolic::{Components, Id};

/// The inertia about G, or about the held point: `J_P = J_G + m (c^2 1 - c c)` with `c = G - P`.
pub fn inertia_about_center(model: &Model, work: &mut Workspace) -> Inertia {
    let (Some(support), Some(mass)) = (model.state.support, model.mass) else {
        return model.inertia;
    };
    let graph = &mut work.graph;
    let inertia = model.inertia.displaced(graph, mass, support.offset);
    match inertia {
        Inertia::Scalar(moment) => work.labels.name(moment, "inertia_about_support"),
        Inertia::Spatial(rows) => work.labels.matrix("inertia_about_support", &rows),
        Inertia::Absent => {}
    }
    inertia
}

/// `d.J d`, for a unit vector d; in the plane, the moment of inertia.
pub fn moment_of_inertia(work: &mut Workspace, inertia: &Inertia, d: Components) -> Id {
    let graph = &mut work.graph;
    match inertia {
        Inertia::Absent => graph.zero(),
        Inertia::Scalar(moment) => *moment,
        Inertia::Spatial(rows) => {
            let momentum = graph.transform(rows, d);
            graph.dot(d, momentum)
        }
    }
}
