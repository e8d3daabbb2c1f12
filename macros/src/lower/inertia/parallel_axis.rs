//! The parallel-axis theorem.

use proc_macro2::Ident;

use crate::lower::expressions::Lowering;
use crate::model::{Mass, Point};

use super::draft::Draft;

impl Lowering<'_> {
    /// The inertia about G by the parallel-axis theorem, exactly: `J_G = J_P - m (r^2 1 - r r)`.
    pub fn moved_to_center(
        &mut self,
        draft: Draft,
        point: Point,
        mass: Mass,
        place: &Ident,
    ) -> Option<Draft> {
        let Some(r) = point.offset(self.state.body) else {
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
