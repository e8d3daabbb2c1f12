//! Spatial vectors (Featherstone): an angular and a linear vector; and spatial inertias.

use crate::model::Labels;
use crate::symbolic::{Components, Graph, Id};

use super::turning::{Turning, transposed};

type Rows = [Components; 3];

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

    /// The same vectors, in the axes of a link instead of those of its carrier.
    pub fn seen_in(self, graph: &mut Graph, turning: Turning) -> Self {
        Self {
            angular: turning.to_link(graph, self.angular),
            linear: turning.to_link(graph, self.linear),
        }
        .quantities(graph)
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

/// A symmetric matrix: `moment = A alpha + B a`, `force = B^T alpha + M a`, about the origin of a
/// link, in its axes. It may be the inertia of a rigid body, or of several with moving joints.
#[derive(Clone, Copy, PartialEq)]
pub struct SpatialInertia {
    pub angular: Rows,
    pub mixed: Rows,
    pub linear: Rows,
}

impl SpatialInertia {
    pub fn none(graph: &Graph) -> Self {
        let zeros = [graph.zeros(); 3];
        Self {
            angular: zeros,
            mixed: zeros,
            linear: zeros,
        }
    }

    pub fn is_zero(&self, graph: &Graph) -> bool {
        let mut rows = [self.angular, self.mixed, self.linear]
            .into_iter()
            .flatten();
        rows.all(|row| graph.is_zero_vector(&row))
    }

    pub fn plus(&self, graph: &mut Graph, other: &Self) -> Self {
        let add = |graph: &mut Graph, a: &Rows, b: &Rows| {
            [0, 1, 2].map(|i| graph.add_vectors(a[i], b[i]))
        };
        Self {
            angular: add(graph, &self.angular, &other.angular),
            mixed: add(graph, &self.mixed, &other.mixed),
            linear: add(graph, &self.linear, &other.linear),
        }
    }

    /// Names all entries, and describes them.
    pub fn name(&self, labels: &mut Labels, of: &str, meaning: &'static str) {
        for part in [&self.angular, &self.mixed, &self.linear] {
            labels.explain(part.concat(), meaning);
        }
        labels.matrix(&format!("inertia_{of}"), &self.angular);
        labels.matrix(&format!("coupling_{of}"), &self.mixed);
        labels.matrix(&format!("mass_{of}"), &self.linear);
    }

    /// Makes each entry a statement.
    pub fn quantities(&self, graph: &mut Graph) -> Self {
        let each = |graph: &mut Graph, rows: &Rows| rows.map(|row| graph.quantities(row));
        Self {
            angular: each(graph, &self.angular),
            mixed: each(graph, &self.mixed),
            linear: each(graph, &self.linear),
        }
    }

    pub fn times(&self, graph: &mut Graph, twist: &SpatialVector) -> SpatialVector {
        let of_angular = graph.transform(&self.angular, twist.angular);
        let of_linear = graph.transform(&self.mixed, twist.linear);
        let moment = graph.add_vectors(of_angular, of_linear);
        let of_angular = graph.transform(&transposed(&self.mixed), twist.angular);
        let of_linear = graph.transform(&self.linear, twist.linear);
        let force = graph.add_vectors(of_angular, of_linear);
        SpatialVector {
            angular: moment,
            linear: force,
        }
    }

    /// The inertia in rotated axes.
    pub fn turned(&self, graph: &mut Graph, turning: Turning) -> Self {
        Self {
            angular: turning.tensor(graph, &self.angular),
            mixed: turning.matrix(graph, &self.mixed),
            linear: turning.tensor(graph, &self.linear),
        }
    }

    /// The inertia about a point from which the origin is at `r`:
    /// `B' = B + [r]x M`, `A' = A - B [r]x + [r]x B'^T`.
    pub fn seen_from(&self, graph: &mut Graph, r: Components) -> Self {
        if graph.is_zero_vector(&r) {
            return *self;
        }
        let across = |graph: &mut Graph, rows: &Rows| {
            let columns = transposed(rows).map(|column| graph.cross(r, column));
            transposed(&columns)
        };
        let levers = across(graph, &self.linear);
        let mixed = [0, 1, 2].map(|i| graph.add_vectors(self.mixed[i], levers[i]));
        let mixed = mixed.map(|row| graph.quantities(row));
        let outer = across(graph, &transposed(&mixed));
        // the rows of -(B [r]x) are r x b
        let inner = self.mixed.map(|row| graph.cross(r, row));
        let angular = [0, 1, 2].map(|i| {
            let sum = graph.add_vectors(inner[i], outer[i]);
            graph.add_vectors(self.angular[i], sum)
        });
        let mut seen = Self {
            angular,
            mixed,
            linear: self.linear,
        };
        seen.mirror();
        seen
    }

    /// Makes both halves of each symmetric matrix the same expressions.
    pub fn mirror(&mut self) {
        for rows in [&mut self.angular, &mut self.linear] {
            let upper = *rows;
            for (i, row) in rows.iter_mut().enumerate() {
                for (entry, above) in row[..i].iter_mut().zip(upper) {
                    *entry = above[i];
                }
            }
        }
    }
}
