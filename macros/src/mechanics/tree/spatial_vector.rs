//! Spatial vectors (Featherstone): an angular and a linear vector.

use crate::model::Labels;
use crate::symbolic::{Components, Graph, Id};

/// An angular and a linear vector about the origin of a link, in its axes: a twist, an
/// acceleration, or a moment and a force.
#[derive(Clone, Copy, PartialEq)]
pub struct SpatialVector {
    pub angular: Components,
    pub linear: Components,
}

/// Whether a motion is about or along a coordinate axis, in either sense.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Along {
    Angular(usize),
    Linear(usize),
}

impl SpatialVector {
    /// The twist of unit rate about a direction.
    pub fn about(graph: &Graph, direction: Components) -> Self {
        Self {
            angular: direction,
            linear: graph.zeros(),
        }
    }

    /// The twist of unit rate along a direction.
    pub fn along(graph: &Graph, direction: Components) -> Self {
        Self {
            angular: graph.zeros(),
            linear: direction,
        }
    }

    /// The coordinate axis that a twist of unit rate is about or along, if there is one.
    pub fn axis(&self, graph: &Graph) -> Option<Along> {
        let is_unit = |a: Id| graph.as_number(a).is_some_and(|a| a.abs().is_one());
        let only =
            |v: Components| (0..3).find(|axis| is_unit(v[*axis]) && graph.is_along(v, *axis));
        let is_zero = |v: &Components| graph.is_zero_vector(v);
        if is_zero(&self.linear) {
            only(self.angular).map(Along::Angular)
        } else if is_zero(&self.angular) {
            only(self.linear).map(Along::Linear)
        } else {
            None
        }
    }

    pub fn zero(graph: &Graph) -> Self {
        Self {
            angular: graph.zeros(),
            linear: graph.zeros(),
        }
    }

    /// Names both vectors.
    pub fn name(&self, labels: &mut Labels, [angular, linear]: [&str; 2], of: &str) {
        labels.vector_or_one(angular, of, self.angular);
        labels.vector(&format!("{linear}_{of}"), self.linear);
    }

    /// Describes both vectors.
    pub fn explain(&self, labels: &mut Labels, meaning: &'static str) {
        labels.explain(self.angular.into_iter().chain(self.linear), meaning);
    }

    /// Names and describes the load that a link lacks.
    pub fn name_lacking(&self, labels: &mut Labels, of: &str) {
        let meaning =
            "moment and force that a body needs beyond its loads, with all that it carries";
        self.explain(labels, meaning);
        self.name(labels, ["moment", "force"], of);
    }

    pub fn plus(self, graph: &mut Graph, other: Self) -> Self {
        Self {
            angular: graph.add_vectors(self.angular, other.angular),
            linear: graph.add_vectors(self.linear, other.linear),
        }
    }

    pub fn minus(self, graph: &mut Graph, other: Self) -> Self {
        Self {
            angular: graph.subtract_vectors(self.angular, other.angular),
            linear: graph.subtract_vectors(self.linear, other.linear),
        }
    }

    pub fn scaled(self, graph: &mut Graph, factor: Id) -> Self {
        Self {
            angular: graph.scale_vector(factor, self.angular),
            linear: graph.scale_vector(factor, self.linear),
        }
    }

    pub fn dot(self, graph: &mut Graph, other: Self) -> Id {
        let angular = graph.dot(self.angular, other.angular);
        let linear = graph.dot(self.linear, other.linear);
        graph.add(angular, linear)
    }

    pub fn quantities(self, graph: &mut Graph) -> Self {
        Self {
            angular: graph.quantities(self.angular),
            linear: graph.quantities(self.linear),
        }
    }
}
