//! Pairs of a linear and an angular vector.

use crate::symbolic::{Components, Graph, Id};

/// A linear vector in the world, and an angular one where the state has its turning
/// (`State::axes`): accelerations, a load on the body, or factors of one of these. About a hinge
/// the angular one stands in the place of z.
#[derive(Clone, Copy)]
pub struct Pair {
    pub linear: Components,
    pub angular: Components,
}

impl Pair {
    pub fn entries(self) -> Vec<Id> {
        [self.linear, self.angular].concat()
    }

    /// The power of one with the other.
    pub fn dot(self, graph: &mut Graph, other: Self) -> Id {
        let linear = graph.dot(self.linear, other.linear);
        let angular = graph.dot(self.angular, other.angular);
        graph.add(linear, angular)
    }
}
