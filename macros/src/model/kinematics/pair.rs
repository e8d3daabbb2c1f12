//! Pairs of a linear and an angular vector.

use crate::symbolic::{Components, Graph, Id};

/// A linear vector in world axes and an angular one in the axes of the state (`State::axes`):
/// accelerations, a load on the body, or factors of one of these. For a hinge, the angular
/// component along its axis takes the place of z.
#[derive(Clone, Copy)]
pub struct Pair {
    pub linear: Components,
    pub angular: Components,
}

impl Pair {
    pub fn entries(self) -> Vec<Id> {
        [self.linear, self.angular].concat()
    }

    /// The product of both: the power of a load along a motion.
    pub fn dot(self, graph: &mut Graph, other: Self) -> Id {
        let linear = graph.dot(self.linear, other.linear);
        let angular = graph.dot(self.angular, other.angular);
        graph.add(linear, angular)
    }
}
