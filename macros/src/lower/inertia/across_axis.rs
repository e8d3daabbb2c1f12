//! The inertia of a rod.

use crate::lower::expressions::Lowering;
use crate::model::{Attitude, Inertia};
use crate::symbolic::{Id, Number};

use super::draft::Draft;

impl Lowering<'_> {
    /// The inertia of a rod, as one moment J: only the tensor `J (1 - e e)` is possible.
    pub fn across_axis(&mut self, draft: Draft) -> Option<Draft> {
        let Inertia::Spatial(rows) = draft.inertia else {
            return Some(draft);
        };
        // otherwise the error in the direction is reported
        let Attitude::Line { direction, .. } = self.work.attitude(self.state.body) else {
            return None;
        };
        let graph = &mut self.work.graph;
        let trace = graph.sum(&[rows[0][0], rows[1][1], rows[2][2]]);
        let half = graph.number(Number::ratio(1, 2));
        let moment = graph.distribute(half, trace);
        let mut rest: Vec<Id> = Vec::new();
        for i in 0..3 {
            for j in 0..3 {
                // the entry less that of J (1 - e e), which must be zero
                let dyad = graph.multiply(direction[i], direction[j]);
                let dyad = graph.multiply(moment, dyad);
                let sum = graph.add(rows[i][j], dyad);
                rest.push(if i == j {
                    graph.subtract(sum, moment)
                } else {
                    sum
                });
            }
        }
        if !rest.into_iter().all(|entry| graph.vanishes(entry)) {
            return self.report(
                draft.extent,
                format!(
                    "a rod has no moment of inertia about its axis, and the same one about every axis \
                     across it: {FORMS_OF_ROD}"
                ),
            );
        }
        Some(Draft {
            inertia: Inertia::Scalar(moment),
            ..draft
        })
    }
}

/// The forms in which the inertia of a rod can be written.
pub const FORMS_OF_ROD: &str =
    "write the one moment across its axis, `rod(l)`, or `compose([..])` of rods and points";
