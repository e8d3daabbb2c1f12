//! The mass matrix, from composite bodies: a link and everything that it carries, with the joints
//! held (Walker and Orin, Efficient Dynamic Computer Simulation of Robotic Mechanisms). For few
//! degrees of freedom, it is cheaper than the recursion.

use crate::model::Labels;
use crate::symbolic::{Graph, Id};

use super::articulated::{Passed, name_passed, wrench_on_carrier};
use super::bias::derive_bias;
use super::link::{Link, Tree};
use super::spatial::{SpatialInertia, SpatialVector};

/// `M q'' = drives - bias`, with a row and a column for each coordinate, link by link.
#[derive(Clone)]
pub struct MassMatrix {
    pub rows: Vec<Vec<Id>>,
    /// The drive of each coordinate, minus the load that the motion needs without acceleration.
    pub driving: Vec<Id>,
    pub names: Vec<String>,
}

impl MassMatrix {
    pub fn derive(graph: &mut Graph, labels: &mut Labels, tree: &Tree) -> Self {
        let links = &tree.links;
        let bias = derive_bias(graph, labels, tree);
        let mut composite: Vec<SpatialInertia> = Vec::new();
        let mut lacking: Vec<SpatialVector> = Vec::new();
        for (link, (_, own)) in links.iter().zip(&bias) {
            composite.push(SpatialInertia::of(graph, link));
            lacking.push(*own);
        }
        let first = first_freedoms(links);
        let mut passed = Vec::new();
        let count = links.iter().map(|link| link.open().count()).sum();
        let zero = graph.zero();
        let (mut rows, mut driving) = (vec![vec![zero; count]; count], vec![zero; count]);
        for (index, link) in links.iter().enumerate().rev() {
            let own = composite[index].quantities(graph);
            let load = lacking[index].quantities(graph);
            own.name(
                labels,
                &link.name,
                "inertia of a body with all that it carries",
            );
            load.name_lacking(labels, &link.name);
            for (number, freedom) in link.open().enumerate() {
                let row = first[index] + number;
                let needed = freedom.twist.dot(graph, load);
                driving[row] = graph.subtract(freedom.drive, needed);
                // the couplings of this coordinate to those that carry it
                let mut wrench = own.times(graph, &freedom.twist).quantities(graph);
                let mut at = index;
                loop {
                    for (number, other) in links[at].open().enumerate() {
                        let mut entry = other.twist.dot(graph, wrench);
                        let column = first[at] + number;
                        if column == row {
                            entry = graph.add(entry, freedom.armature);
                        }
                        rows[row][column] = graph.quantity(entry);
                        rows[column][row] = rows[row][column];
                    }
                    let Some(carrier) = links[at].carrier else {
                        break;
                    };
                    wrench = wrench_on_carrier(graph, &links[at], wrench);
                    at = carrier;
                }
            }
            if let Some(carrier) = link.carrier {
                let seen = own.seen_by_carrier(graph, link);
                composite[carrier] = composite[carrier].plus(graph, &seen);
                let wrench = wrench_on_carrier(graph, link, load);
                lacking[carrier] = lacking[carrier].plus(graph, wrench);
                passed.push(Passed(link, seen, wrench));
            }
        }
        name_passed(labels, tree, &passed);
        let freedoms = links.iter().flat_map(Link::open);
        let matrix = Self {
            rows,
            driving,
            names: freedoms.map(|freedom| freedom.name.clone()).collect(),
        };
        matrix.name(labels);
        matrix
    }

    fn name(&self, labels: &mut Labels) {
        for (row, first) in self.rows.iter().zip(&self.names) {
            for (entry, second) in row.iter().zip(&self.names) {
                labels.explain(
                    [*entry],
                    "mass matrix: load on a joint by the acceleration of another",
                );
                labels.name(*entry, format!("inertia_{second}_{first}"));
            }
        }
    }

    /// Sets the acceleration of a coordinate that is coupled to no others, because it is already
    /// known.
    pub fn separate(&mut self, graph: &mut Graph, freedom: usize, acceleration: Id) {
        let (zero, one) = (graph.zero(), graph.one());
        for other in 0..self.rows.len() {
            self.rows[freedom][other] = zero;
            self.rows[other][freedom] = zero;
        }
        self.rows[freedom][freedom] = one;
        self.driving[freedom] = acceleration;
    }

    /// Solves from the last coordinate to the first, `L^T D L`.
    pub fn solve(&self, graph: &mut Graph, labels: &mut Labels) -> Vec<Id> {
        let (mut rows, mut driving) = (self.rows.clone(), self.driving.clone());
        let count = rows.len();
        let mut shares = Vec::new();
        for k in (0..count).rev() {
            let one = graph.one();
            let inverse = graph.divide(one, rows[k][k]);
            let inverse = graph.quantity(inverse);
            labels.name(inverse, format!("inverse_inertia_{}", self.names[k]));
            let share: Vec<Id> = (0..k)
                .map(|j| {
                    let share = graph.multiply(rows[k][j], inverse);
                    graph.quantity(share)
                })
                .collect();
            driving[k] = graph.quantity(driving[k]);
            // a motion that is known already has no inertia
            if !graph.is_one(rows[k][k]) {
                let meaning = "1 / J of each joint, without the share of later ones";
                labels.explain([inverse], meaning);
                let meaning = "load along each joint, without the share of later ones";
                labels.explain([driving[k]], meaning);
            }
            labels.name(driving[k], format!("driving_{}", self.names[k]));
            for i in 0..k {
                for j in 0..=i {
                    let less = graph.multiply(rows[k][i], share[j]);
                    rows[i][j] = graph.subtract(rows[i][j], less);
                    rows[j][i] = rows[i][j];
                }
                let less = graph.multiply(share[i], driving[k]);
                driving[i] = graph.subtract(driving[i], less);
            }
            driving[k] = graph.multiply(driving[k], inverse);
            shares.push(share);
        }
        shares.reverse();
        let mut found: Vec<Id> = Vec::new();
        for (own, share) in driving.into_iter().zip(shares) {
            let carried = share.iter().zip(&found);
            let carried: Vec<Id> = carried
                .map(|(share, rate)| graph.multiply(*share, *rate))
                .collect();
            let carried = graph.sum(&carried);
            let rate = graph.subtract(own, carried);
            found.push(graph.quantity(rate));
        }
        found
    }
}

/// The index of the first coordinate of each link.
fn first_freedoms(links: &[Link]) -> Vec<usize> {
    let mut next = 0;
    let firsts = links.iter().map(|link| {
        let first = next;
        next += link.open().count();
        first
    });
    firsts.collect()
}
