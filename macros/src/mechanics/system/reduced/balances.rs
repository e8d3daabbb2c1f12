//! Balances and rows, solved block by block.

use crate::mechanics::proofs::{may_vanish, samples};
use crate::model::Workspace;
use crate::symbolic::{Graph, Id};

use super::block::{Block, Way, next_rows, numerators, solved, way};
use super::equations::GUARDED;

/// A constraint row: `sum of slopes * x = right`.
#[derive(Clone)]
pub struct LinearRow {
    pub name: String,
    pub slopes: Vec<Id>,
    pub right: Id,
    /// Bounds of the squares of the slopes.
    pub sizes: Vec<Id>,
}

/// A coordinate, and its balance.
#[derive(Clone)]
pub struct Balance {
    pub name: String,
    /// The inertia, per acceleration of each coordinate.
    pub masses: Vec<Id>,
    pub driving: Id,
}

/// Balances and rows while they are being solved.
pub struct Balances<'w> {
    pub work: &'w mut Workspace,
    pub all: Vec<Balance>,
    pub rows: Vec<LinearRow>,
    /// Bounds of the inertia of each coordinate.
    sizes: Vec<Id>,
    /// The number of original coordinates. The later ones each stand for several.
    given: usize,
    /// Whether each coordinate is still to be solved for, and whether each row is still to be
    /// solved.
    pub open: Vec<bool>,
    is_left: Vec<bool>,
    pub blocks: Vec<Block>,
}

/// The rows of a block, and their coefficients for its coordinates.
struct Chosen {
    rows: Vec<usize>,
    coordinates: Vec<usize>,
    slopes: Vec<Vec<Id>>,
    right: Vec<Id>,
}

impl<'w> Balances<'w> {
    pub fn new(work: &'w mut Workspace, all: Vec<Balance>, rows: Vec<LinearRow>) -> Self {
        let sizes = all.iter().enumerate().map(|(own, one)| one.masses[own]);
        let mut balances = Self {
            work,
            sizes: sizes.collect(),
            given: all.len(),
            open: vec![true; all.len()],
            is_left: vec![true; rows.len()],
            all,
            rows,
            blocks: Vec::new(),
        };
        balances.drop_zeros();
        balances.label();
        balances
    }

    /// Names the parts of balances and rows.
    fn label(&mut self) {
        let labels = &mut self.work.labels;
        for (number, one) in self.all.iter().enumerate() {
            labels.name(one.masses[number], format!("inertia_{}", one.name));
            for (other, mass) in self.all[..number].iter().zip(&one.masses) {
                labels.name(*mass, format!("coupling_{}_{}", other.name, one.name));
            }
            labels.name(one.driving, format!("driving_{}", one.name));
        }
        for row in &self.rows {
            labels.name(row.right, format!("{}_to_balance", row.name));
        }
    }

    /// The rows that are not solved yet.
    pub fn left(&self) -> Vec<usize> {
        (0..self.rows.len())
            .filter(|row| self.is_left[*row])
            .collect()
    }

    /// Replaces slopes that are proved to vanish by zero.
    fn drop_zeros(&mut self) {
        let left = self.left();
        let slopes = left.iter().flat_map(|row| self.rows[*row].slopes.clone());
        let slopes: Vec<Id> = slopes.collect();
        let mut values = samples(self.work, &slopes).into_iter();
        let zero = self.work.graph.zero();
        for row in left {
            for (slope, value) in self.rows[row].slopes.iter_mut().zip(&mut values) {
                if value.is_zero() {
                    *slope = zero;
                }
            }
        }
    }

    /// Solves the smallest block. Returns whether there was one.
    pub fn next_block(&mut self) -> bool {
        let open = self.left().into_iter().map(|row| {
            let slopes = self.rows[row].slopes.iter().enumerate();
            let there = slopes.filter(|(_, slope)| !self.work.graph.is_zero(**slope));
            (row, there.map(|(coordinate, _)| coordinate).collect())
        });
        let open: Vec<(usize, Vec<usize>)> = open.collect();
        let Some((rows, coordinates)) = next_rows(&open) else {
            return false;
        };
        let known = rows.iter().map(|row| &self.rows[*row]);
        let chosen = Chosen {
            slopes: known
                .clone()
                .map(|row| coordinates.iter().map(|own| row.slopes[*own]).collect())
                .collect(),
            right: known.map(|row| row.right).collect(),
            rows,
            coordinates,
        };
        let block = if chosen.rows.len() == chosen.coordinates.len() {
            self.determined(chosen)
        } else {
            self.with_way(chosen)
        };
        let Some(block) = block else { return false };
        self.replace(block);
        self.drop_zeros();
        true
    }

    /// Solves rows for equally many coordinates. `None` if the determinant may vanish on a whole
    /// branch.
    fn determined(&mut self, known: Chosen) -> Option<Block> {
        let graph = &mut self.work.graph;
        let (determinant, numerators) = solved(graph, &known.slopes, &known.right);
        let size = graph.largest_term(determinant);
        let determinant = graph.quantity(determinant);
        if may_vanish(self.work, determinant) {
            return None;
        }
        let inverse = if known.coordinates.iter().all(|own| *own < self.given) {
            self.work.graph.pivot(determinant, size)
        } else {
            self.inverse_by_squares(determinant, &known)
        };
        let graph = &mut self.work.graph;
        Some(Block {
            fixed: divided(graph, &numerators, inverse),
            rows: known.rows,
            coordinates: known.coordinates,
            slopes: known.slopes,
            way: None,
            inverse,
            later: Vec::new(),
        })
    }

    /// The reciprocal of a determinant, as `d / (d d)`. Slopes along ways are sums that may vanish
    /// in closed states, so their values do not bound their terms. So the square is compared with
    /// the bounds of the squares of slopes, like the inertia along ways.
    fn inverse_by_squares(&mut self, determinant: Id, known: &Chosen) -> Id {
        let bounds = self.bounds(known);
        let graph = &mut self.work.graph;
        let square = graph.multiply(determinant, determinant);
        let size = bounds
            .iter()
            .fold(graph.one(), |size, bound| graph.multiply(size, *bound));
        let inverse = graph.pivot(square, size);
        graph.multiply(determinant, inverse)
    }

    /// Solves rows with one coordinate more. `None` if, on a whole branch, there may be no way, or
    /// none with inertia.
    fn with_way(&mut self, known: Chosen) -> Option<Block> {
        let bounds = self.bounds(&known);
        let graph = &mut self.work.graph;
        let own = &known.coordinates;
        let (along, bounds) = way(graph, &known.slopes, &bounds);
        let momentum: Vec<Id> = own
            .iter()
            .map(|one| {
                let sum = graph.inner(at(&self.all[*one].masses, own), &along);
                graph.quantity(sum)
            })
            .collect();
        let inertia = graph.inner(momentum.iter().copied(), &along);
        let inertia = graph.quantity(inertia);
        if may_vanish(self.work, inertia) {
            return None;
        }
        let graph = &mut self.work.graph;
        let size = graph.inner(at(&self.sizes, own), &bounds);
        let inverse = graph.pivot(inertia, size);
        let numerators = numerators(graph, &known.slopes, &known.right, &momentum);
        let fixed = divided(graph, &numerators, inverse);
        self.sizes.push(size);
        for row in &mut self.rows {
            let bound = graph.inner(at(&row.sizes, own), &bounds);
            row.sizes.push(bound);
        }
        let coordinate = self.stand_for(own, &along, inertia);
        let Workspace { graph, labels, .. } = &mut *self.work;
        for ((one, along), momentum) in own.iter().zip(&along).zip(&momentum) {
            let name = &self.all[*one].name;
            // a share may be an arm, which has a meaning of its own
            let (_, arm) = graph.split_sign(*along);
            if labels.get(arm).is_none() {
                labels.explain([*along], "rate of a joint by that of the independent joint");
            }
            labels.explain(
                [*momentum],
                "load on a joint by the acceleration of the independent joint",
            );
            labels.name(*along, format!("share_{name}"));
            labels.name(*momentum, format!("momentum_{name}"));
        }
        let name = &self.all[coordinate].name;
        labels.explain([inertia], "inertia that the independent joint moves");
        labels.name(inertia, format!("inertia_{name}"));
        labels.name(inverse, format!("inverse_inertia_{name}"));
        labels.explain([inverse], GUARDED);
        Some(Block {
            rows: known.rows,
            coordinates: known.coordinates,
            slopes: known.slopes,
            fixed,
            way: Some(Way {
                along,
                momentum,
                numerators,
                coordinate,
            }),
            inverse,
            later: Vec::new(),
        })
    }

    /// Bounds of the squares of all slopes of each coordinate.
    fn bounds(&mut self, known: &Chosen) -> Vec<Id> {
        let graph = &mut self.work.graph;
        let bounds = known.coordinates.iter().map(|own| {
            let rows = known.rows.iter();
            let mut sizes: Vec<Id> = rows.map(|row| self.rows[*row].sizes[*own]).collect();
            sizes.dedup();
            graph.sum(&sizes)
        });
        bounds.collect()
    }

    /// Adds a coordinate that stands for others along a way: its balance, and its slopes in the
    /// rows.
    fn stand_for(&mut self, coordinates: &[usize], along: &[Id], inertia: Id) -> usize {
        let graph = &mut self.work.graph;
        let mut masses: Vec<Id> = Vec::new();
        for balance in &mut self.all {
            let sum = graph.inner(at(&balance.masses, coordinates), along);
            let coupling = graph.quantity(sum);
            balance.masses.push(coupling);
            masses.push(coupling);
        }
        masses.push(inertia);
        let driving = coordinates.iter().map(|own| self.all[*own].driving);
        let driving = graph.inner(driving, along);
        let name = format!("loop_{}", self.blocks.len() + 1);
        for row in &mut self.rows {
            let sum = graph.inner(at(&row.slopes, coordinates), along);
            let slope = graph.quantity(sum);
            self.work
                .labels
                .name(slope, format!("{}_by_{name}", row.name));
            row.slopes.push(slope);
        }
        self.open.push(true);
        self.work.labels.name(driving, format!("driving_{name}"));
        self.all.push(Balance {
            name,
            masses,
            driving,
        });
        self.all.len() - 1
    }

    /// Substitutes the solved coordinates into the other balances and rows.
    fn replace(&mut self, mut block: Block) {
        let Workspace { graph, labels, .. } = &mut *self.work;
        let zero = graph.zero();
        for (own, fixed) in block.coordinates.iter().zip(&block.fixed) {
            self.open[*own] = false;
            labels.name(*fixed, format!("fixed_{}", self.all[*own].name));
        }
        for row in &block.rows {
            self.is_left[*row] = false;
        }
        let rows = self.rows.iter_mut().enumerate();
        for (number, row) in rows.filter(|(number, _)| self.is_left[*number]) {
            let slopes: Vec<Id> = at(&row.slopes, &block.coordinates).collect();
            if slopes.iter().all(|slope| graph.is_zero(*slope)) {
                continue;
            }
            let known = graph.inner(slopes.iter().copied(), &block.fixed);
            let right = graph.subtract(row.right, known);
            row.right = graph.quantity(right);
            labels.name(row.right, format!("{}_to_balance", row.name));
            for own in &block.coordinates {
                row.slopes[*own] = zero;
            }
            block.later.push((number, slopes));
        }
        // the fixed part has no inertia along its own coordinate
        let way = block.way.as_ref().map(|way| way.coordinate);
        for (coordinate, balance) in self.all.iter_mut().enumerate() {
            if self.open[coordinate] && way != Some(coordinate) {
                let taken = graph.inner(at(&balance.masses, &block.coordinates), &block.fixed);
                balance.driving = graph.subtract(balance.driving, taken);
            }
        }
        self.blocks.push(block);
    }
}

fn divided(graph: &mut Graph, numerators: &[Id], inverse: Id) -> Vec<Id> {
    let values = numerators.iter().map(|one| {
        let value = graph.multiply(inverse, *one);
        graph.quantity(value)
    });
    values.collect()
}

/// The entries of a list for these coordinates.
pub fn at(list: &[Id], coordinates: &[usize]) -> impl Iterator<Item = Id> {
    coordinates.iter().map(|own| list[*own])
}
