//! The parallel-axis theorem.

use proc_macro2::Ident;

use crate::symbolic::{Components, Graph, Id};

use super::definitions::Mass;
use super::draft::Draft;
use super::lower::Lowering;
use super::value::Point;

impl Lowering<'_> {
    /// The parallel-axis theorem, exactly: `J_G = J_P - m (r^2 1 - r r)`.
    pub fn moved_to_center(
        &mut self,
        draft: Draft,
        point: Point,
        mass: Mass,
        place: &Ident,
    ) -> Option<Draft> {
        let Point::Body(r) = point else {
            return self.report(
                place.span(),
                format!(
                    "the inertia is constant only about a point of the body, and this one is {}",
                    point.where_else()
                ),
            );
        };
        let mass = match mass {
            Mass::Known(mass) => mass,
            Mass::Reported => return None,
            Mass::Absent => {
                return self.report(
                    place.span(),
                    "`.about(P)` needs the mass of the body: write `mass: ..`",
                );
            }
        };
        let graph = &mut self.work.graph;
        let minus_mass = graph.negate(mass);
        let inertia = draft.inertia.displaced(graph, minus_mass, r);
        Some(Draft { inertia, ..draft })
    }
}

/// `J + m (r^2 1 - r r)`: the inertia `J` about G, taken about a point at the offset `r`.
pub fn displaced(
    graph: &mut Graph,
    mass: Id,
    r: Components,
    rows: &[Components; 3],
) -> [Components; 3] {
    let squares = r.map(|component| graph.square(component));
    [0, 1, 2].map(|i| {
        [0, 1, 2].map(|j| {
            let lever = if i == j {
                graph.add(squares[(i + 1) % 3], squares[(i + 2) % 3])
            } else {
                let product = graph.multiply(r[i], r[j]);
                graph.negate(product)
            };
            let added = graph.multiply(mass, lever);
            graph.add(rows[i][j], added)
        })
    })
}
