//! Mass, first moment and inertia of links.

use crate::model::ENTRIES;
use crate::symbolic::{Components, Graph, Id};

use super::turning::Turning;

type Rows = [Components; 3];

/// The mass, the first moment `m c` and the inertia of a link about its origin, in its axes.
#[derive(Clone, Copy, PartialEq)]
pub struct Properties {
    pub mass: Id,
    pub first: Components,
    pub inertia: Rows,
}

impl Properties {
    pub fn none(graph: &Graph) -> Self {
        Self {
            mass: graph.zero(),
            first: graph.zeros(),
            inertia: [graph.zeros(); 3],
        }
    }

    /// The properties of a mass with its center at `c`, from its inertia about the center.
    pub fn of_body(graph: &mut Graph, mass: Id, c: Components, inertia: &Rows) -> Self {
        let first = graph.scale_vector(mass, c);
        Self {
            mass,
            first,
            inertia: crate::model::displaced(graph, mass, c, inertia),
        }
    }

    /// Ten unit values: in each, one of the ten numbers is one and the others are zero.
    pub fn units(graph: &Graph) -> [Self; 10] {
        let (one, none) = (graph.one(), Self::none(graph));
        core::array::from_fn(|number| {
            let mut unit = none;
            match number {
                0 => unit.mass = one,
                1..4 => unit.first[number - 1] = one,
                _ => {
                    let (_, row, column) = ENTRIES[number - 4];
                    (unit.inertia[row][column], unit.inertia[column][row]) = (one, one);
                }
            }
            unit
        })
    }

    /// The ten numbers.
    pub fn entries(&self) -> [Id; 10] {
        let [x, y, z] = self.first;
        let [xx, yy, zz, xy, yz, zx] = ENTRIES.map(|(_, row, column)| self.inertia[row][column]);
        [self.mass, x, y, z, xx, yy, zz, xy, yz, zx]
    }

    pub fn plus(self, graph: &mut Graph, other: &Self) -> Self {
        Self {
            mass: graph.add(self.mass, other.mass),
            first: graph.add_vectors(self.first, other.first),
            inertia: [0, 1, 2].map(|i| graph.add_vectors(self.inertia[i], other.inertia[i])),
        }
    }

    pub fn minus(self, graph: &mut Graph, other: &Self) -> Self {
        Self {
            mass: graph.subtract(self.mass, other.mass),
            first: graph.subtract_vectors(self.first, other.first),
            inertia: [0, 1, 2].map(|i| graph.subtract_vectors(self.inertia[i], other.inertia[i])),
        }
    }

    /// The properties about a point from which the origin is at `r`:
    /// `J + (2 r.h 1 - r h - h r) + m (r^2 1 - r r)`.
    pub fn seen_from(self, graph: &mut Graph, r: Components) -> Self {
        let mut inertia = crate::model::displaced(graph, self.mass, r, &self.inertia);
        let along = graph.dot(r, self.first);
        let twice = graph.add(along, along);
        for i in 0..3 {
            for j in 0..3 {
                let (rh, hr) = (
                    graph.multiply(r[i], self.first[j]),
                    graph.multiply(self.first[i], r[j]),
                );
                let both = graph.add(rh, hr);
                let mut entry = graph.subtract(inertia[i][j], both);
                if i == j {
                    entry = graph.add(entry, twice);
                }
                inertia[i][j] = entry;
            }
        }
        let moved = graph.scale_vector(self.mass, r);
        Self {
            mass: self.mass,
            first: graph.add_vectors(self.first, moved),
            inertia,
        }
    }

    /// The properties in rotated axes.
    pub fn turned(&self, graph: &mut Graph, turning: Turning) -> Self {
        Self {
            mass: self.mass,
            first: turning.to_carrier(graph, self.first),
            inertia: turning.tensor(graph, &self.inertia),
        }
    }
}
