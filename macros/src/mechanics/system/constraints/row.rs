//! One scalar constraint.

use crate::mechanics::unknowns::Activity;
use crate::model::Labels;
use crate::symbolic::{Graph, Id};

/// A constraint in the form that the equations need.
#[derive(Clone)]
pub struct ConstraintRow {
    pub name: String,
    /// Zero in all states of the motion; `None` for a constraint of velocities.
    pub value: Option<Id>,
    /// A cosine that is one in all states of the motion, and less in other assemblies whose value is
    /// zero.
    pub facing: Option<Id>,
    pub rate: Id,
    /// The derivative of the rate if no joint accelerates.
    pub bias: Id,
    /// The slopes along the rates of the open coordinates, in the order of the links.
    pub slopes: Vec<Id>,
    /// Where it is not trivial.
    pub activity: Activity,
}

impl ConstraintRow {
    /// One where it is trivial, and zero elsewhere. With this factor of its load in its equation, the
    /// load is zero where it is trivial.
    pub fn triviality(&self, graph: &mut Graph) -> Id {
        let (zero, one) = (graph.zero(), graph.one());
        let active = self.activity.condition;
        active.map_or(zero, |active| graph.select(active, zero, one))
    }

    /// Its value; zero where it is trivial.
    pub fn gap(&self, graph: &mut Graph) -> Option<Id> {
        let (value, zero) = (self.value?, graph.zero());
        let active = self.activity.condition;
        Some(active.map_or(value, |active| graph.select(active, value, zero)))
    }

    /// What shows where it holds, and on what it depends.
    pub fn parts(&self) -> impl Iterator<Item = Id> {
        let places = self.value.into_iter().chain(self.facing);
        places.chain(self.slopes.iter().copied())
    }

    /// The same with these parts, in their order.
    pub fn with_parts(&self, parts: &mut impl Iterator<Item = Id>) -> Self {
        let value = self.value.and_then(|_| parts.next());
        let facing = self.facing.and_then(|_| parts.next());
        let slopes = parts.take(self.slopes.len()).collect();
        Self {
            value,
            facing,
            slopes,
            ..self.clone()
        }
    }

    /// Its name, as a word of the language.
    pub fn spelled(&self) -> String {
        self.name.replace('.', "_")
    }

    /// Names its parts; `coordinates` are the names of the open coordinates.
    pub fn label<'n>(&self, labels: &mut Labels, coordinates: impl Iterator<Item = &'n str>) {
        let name = self.spelled();
        if let Some(value) = self.value {
            labels.name(value, format!("{name}_gap"));
        }
        labels.name(self.rate, format!("{name}_rate"));
        labels.name(self.bias, format!("{name}_drift"));
        for (slope, coordinate) in self.slopes.iter().zip(coordinates) {
            labels.name(*slope, format!("{name}_by_{coordinate}"));
        }
    }
}
