//! Pairs of a linear and an angular vector.

use crate::symbolic::{Components, Graph, Id};

/// A linear vector in the world, and an angular one in the axes of the state
/// (`State::axes`): accelerations, a load on the body, or factors of one of these. For a hinge
/// the angular one takes the place of z.
#[derive(Clone, Copy)]
pub struct Pair {
    pub linear: Components,
    pub angular: Components,
}

impl Pair {
    pub fn entries(self) -> Vec<Id> {
        [self.linear, self.angular].concat()
    }

    /// The power of one on the other.
    pub fn dot(self, graph: &mut Graph, other: Self) -> Id {
        let linear = graph.dot(self.linear, other.linear);
        let angular = graph.dot(self.angular, other.angular);
        graph.add(linear, angular)
    }
}
