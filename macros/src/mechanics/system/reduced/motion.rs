//! Accelerations, block by block.

use crate::mechanics::proofs::samples;
use crate::model::Workspace;
use crate::symbolic::{Elimination, Equation, Graph, Id, Size};

use super::block::{Block, Way, next_rows, numerators, solved, way};

/// A row of what is kept: `sum of slopes * x = right`.
#[derive(Clone)]
pub struct Held {
    pub slopes: Vec<Id>,
    pub right: Id,
    /// Bounds of the squares of the slopes.
    pub sizes: Vec<Id>,
}

/// What is found.
pub struct Reduced {
    /// Of all coordinates: those that were given, and those that stand for others.
    pub values: Vec<Id>,
    pub blocks: Vec<Block>,
    /// The rows that were eliminated with the balances, each with its load.
    pub eliminated: Vec<(usize, Id)>,
}

/// Balances and rows that are being resolved.
struct Reduction<'w> {
    work: &'w mut Workspace,
    masses: Vec<Vec<Id>>,
    driving: Vec<Id>,
    rows: Vec<Held>,
    /// Bounds of the inertia of each coordinate.
    sizes: Vec<Id>,
    open: Vec<bool>,
    is_left: Vec<bool>,
    blocks: Vec<Block>,
}

/// Resolves `M x = f + A^T l`, `A x = r` for x; nothing if rows are found to be dependent.
pub fn reduce(
    work: &mut Workspace,
    masses: Vec<Vec<Id>>,
    driving: Vec<Id>,
    rows: Vec<Held>,
) -> Option<Reduced> {
    let sizes = (0..driving.len()).map(|own| masses[own][own]).collect();
    let mut reduction = Reduction {
        work,
        sizes,
        open: vec![true; driving.len()],
        is_left: vec![true; rows.len()],
        masses,
        driving,
        rows,
        blocks: Vec::new(),
    };
    reduction.drop_zeros();
    while reduction.next_block() {}
    reduction.finish()
}

impl Reduction<'_> {
    fn graph(&mut self) -> &mut Graph {
        &mut self.work.graph
    }

    /// Slopes that are proved to vanish.
    fn drop_zeros(&mut self) {
        let left = self.left();
        let slopes: Vec<Id> = left
            .iter()
            .flat_map(|row| self.rows[*row].slopes.clone())
            .collect();
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

    fn left(&self) -> Vec<usize> {
        (0..self.rows.len())
            .filter(|row| self.is_left[*row])
            .collect()
    }

    /// Resolves the smallest block; whether there was one.
    fn next_block(&mut self) -> bool {
        let open = self.left().into_iter().map(|row| {
            let slopes = self.rows[row].slopes.iter().enumerate();
            let there = slopes.filter(|(_, slope)| !self.work.graph.is_zero(**slope));
            (row, there.map(|(coordinate, _)| coordinate).collect())
        });
        let open: Vec<(usize, Vec<usize>)> = open.collect();
        let Some((rows, coordinates)) = next_rows(&open) else {
            return false;
        };
        let slopes: Vec<Vec<Id>> = rows
            .iter()
            .map(|row| {
                let of = |coordinate: &usize| self.rows[*row].slopes[*coordinate];
                coordinates.iter().map(of).collect()
            })
            .collect();
        let right: Vec<Id> = rows.iter().map(|row| self.rows[*row].right).collect();
        let block = if rows.len() == coordinates.len() {
            self.determined(rows, coordinates, slopes, &right)
        } else {
            self.with_way(rows, coordinates, slopes, &right)
        };
        let Some(block) = block else { return false };
        self.replace(block);
        self.drop_zeros();
        true
    }

    /// Rows of as many coordinates.
    fn determined(
        &mut self,
        rows: Vec<usize>,
        coordinates: Vec<usize>,
        slopes: Vec<Vec<Id>>,
        right: &[Id],
    ) -> Option<Block> {
        let graph = self.graph();
        let (determinant, numerators) = solved(graph, &slopes, right);
        let determinant = graph.quantity(determinant);
        let shown = graph.unnamed(determinant);
        let size = graph.largest_term(shown);
        if samples(self.work, &[determinant])[0].may_vanish() {
            return None;
        }
        let graph = self.graph();
        let inverse = graph.checked_reciprocal(determinant, size);
        let fixed = numerators.into_iter().map(|one| {
            let value = graph.multiply(inverse, one);
            graph.quantity(value)
        });
        Some(Block {
            fixed: fixed.collect(),
            rows,
            coordinates,
            slopes,
            way: None,
            inverse,
            later: Vec::new(),
        })
    }

    /// Rows of one coordinate more.
    fn with_way(
        &mut self,
        rows: Vec<usize>,
        coordinates: Vec<usize>,
        slopes: Vec<Vec<Id>>,
        right: &[Id],
    ) -> Option<Block> {
        let graph = &mut self.work.graph;
        let bounds: Vec<Id> = (0..coordinates.len())
            .map(|place| {
                let own = rows
                    .iter()
                    .map(|row| self.rows[*row].sizes[coordinates[place]]);
                let mut own: Vec<Id> = own.collect();
                own.dedup();
                graph.sum(&own)
            })
            .collect();
        let (along, bounds) = way(graph, &slopes, &bounds);
        let momentum: Vec<Id> = coordinates
            .iter()
            .map(|i| {
                let masses = &self.masses[*i];
                let own = coordinates.iter().map(|j| masses[*j]);
                let sum = products(graph, own.zip(along.iter().copied()));
                graph.quantity(sum)
            })
            .collect();
        let pairs = |list: &[Id]| -> Vec<(Id, Id)> {
            let pairs = along.iter().copied().zip(list.iter().copied());
            pairs.collect()
        };
        let inertia = products(graph, pairs(&momentum).into_iter());
        let inertia = graph.quantity(inertia);
        let own = coordinates.iter().map(|own| self.sizes[*own]);
        let size = products(graph, own.zip(bounds.iter().copied()));
        let numerators = numerators(graph, &slopes, right, &momentum);
        // somewhere on every branch there is a way, and it has inertia
        if samples(self.work, &[inertia])[0].may_vanish() {
            return None;
        }
        let graph = &mut self.work.graph;
        let inverse = graph.pivot(inertia, size);
        let fixed = numerators.iter().map(|one| {
            let value = graph.multiply(inverse, *one);
            graph.quantity(value)
        });
        let fixed = fixed.collect();
        let driving: Vec<Id> = coordinates.iter().map(|own| self.driving[*own]).collect();
        let driving = products(graph, pairs(&driving).into_iter());
        let coordinate = self.open.len();
        self.stand_for(&coordinates, &along, (inertia, driving));
        self.sizes.push(size);
        let graph = &mut self.work.graph;
        for row in &mut self.rows {
            let own = coordinates.iter().map(|own| row.sizes[*own]);
            row.sizes
                .push(products(graph, own.zip(bounds.iter().copied())));
        }
        Some(Block {
            rows,
            coordinates,
            slopes,
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

    /// A coordinate that stands for others along a way: its balance, and its part in the rows.
    fn stand_for(
        &mut self,
        coordinates: &[usize],
        along: &[Id],
        (inertia, driving): (Id, Id),
    ) {
        let graph = &mut self.work.graph;
        let mut row: Vec<Id> = self
            .masses
            .iter()
            .map(|masses| {
                let own = coordinates.iter().map(|own| masses[*own]);
                let sum = products(graph, own.zip(along.iter().copied()));
                graph.quantity(sum)
            })
            .collect();
        for (masses, own) in self.masses.iter_mut().zip(&row) {
            masses.push(*own);
        }
        row.push(inertia);
        self.masses.push(row);
        self.driving.push(driving);
        self.open.push(true);
        for row in &mut self.rows {
            let own = coordinates.iter().map(|own| row.slopes[*own]);
            let sum = products(graph, own.zip(along.iter().copied()));
            row.slopes.push(graph.quantity(sum));
        }
    }

    /// Puts what is found of coordinates into the other balances and rows.
    fn replace(&mut self, mut block: Block) {
        let graph = &mut self.work.graph;
        let zero = graph.zero();
        for own in &block.coordinates {
            self.open[*own] = false;
        }
        for row in &block.rows {
            self.is_left[*row] = false;
            self.rows[*row].slopes.resize(self.open.len(), zero);
        }
        for (number, row) in self.rows.iter_mut().enumerate() {
            if !self.is_left[number] {
                continue;
            }
            let slopes: Vec<Id> = block.coordinates.iter().map(|own| row.slopes[*own]).collect();
            if slopes.iter().all(|slope| graph.is_zero(*slope)) {
                continue;
            }
            let known = slopes.iter().copied().zip(block.fixed.iter().copied());
            let known = products(graph, known);
            let right = graph.subtract(row.right, known);
            row.right = graph.quantity(right);
            for own in &block.coordinates {
                row.slopes[*own] = zero;
            }
            block.later.push((number, slopes));
        }
        for (coordinate, masses) in self.masses.iter().enumerate() {
            if !self.open[coordinate] {
                continue;
            }
            let is_way = |way: &Way| way.coordinate == coordinate;
            if block.way.as_ref().is_some_and(is_way) {
                continue;
            }
            let own = block.coordinates.iter().map(|own| masses[*own]);
            let taken = products(graph, own.zip(block.fixed.iter().copied()));
            self.driving[coordinate] = graph.subtract(self.driving[coordinate], taken);
        }
        self.blocks.push(block);
    }

    /// What is left is eliminated; then the values of all coordinates, the last ones first.
    fn finish(mut self) -> Option<Reduced> {
        let zero = self.work.graph.zero();
        let mut values = vec![zero; self.open.len()];
        let left = self.left();
        let open: Vec<usize> = (0..self.open.len()).filter(|one| self.open[*one]).collect();
        // what moves alone is divided once, with what it stands for
        let alone: Vec<usize> = open
            .iter()
            .copied()
            .filter(|own| self.is_alone(*own, &open, &left))
            .collect();
        let open: Vec<usize> = open.into_iter().filter(|own| !alone.contains(own)).collect();
        let solved = self.eliminate(&open, &left);
        if !solved.undetermined.is_empty() {
            return None;
        }
        let mut found = solved.values.into_iter();
        for (own, value) in open.iter().zip(&mut found) {
            values[*own] = value;
        }
        let graph = &mut self.work.graph;
        for block in self.blocks.iter().rev() {
            let fixed = block.fixed.iter().copied();
            let Some(way) = &block.way else {
                for (own, value) in block.coordinates.iter().zip(fixed) {
                    values[*own] = value;
                }
                continue;
            };
            let is_alone = alone.contains(&way.coordinate);
            let (parts, by) = if is_alone {
                (way.numerators.clone(), self.driving[way.coordinate])
            } else {
                (fixed.collect(), values[way.coordinate])
            };
            let by = graph.quantity(by);
            for ((own, part), along) in block.coordinates.iter().zip(parts).zip(&way.along) {
                let moved = graph.multiply(by, *along);
                let sum = graph.add(part, moved);
                let value = if is_alone {
                    graph.multiply(block.inverse, sum)
                } else {
                    sum
                };
                values[*own] = graph.quantity(value);
            }
            if is_alone {
                values[way.coordinate] = graph.multiply(block.inverse, by);
            }
        }
        Some(Reduced {
            values,
            blocks: self.blocks,
            eliminated: left.into_iter().zip(found).collect(),
        })
    }

    /// Whether a coordinate stands for others, and nothing else that is left has to do with it.
    fn is_alone(&self, own: usize, open: &[usize], left: &[usize]) -> bool {
        let graph = &self.work.graph;
        let ways = self.blocks.iter().filter_map(|block| block.way.as_ref());
        let mut others = open.iter().filter(|other| **other != own);
        let mut rows = left.iter();
        ways.into_iter().any(|way| way.coordinate == own)
            && others.all(|other| graph.is_zero(self.masses[own][*other]))
            && rows.all(|row| graph.is_zero(self.rows[*row].slopes[own]))
    }

    /// The balances and the rows that are left, together.
    fn eliminate(&mut self, open: &[usize], left: &[usize]) -> Elimination {
        let masses = open.iter().map(|own| {
            let row = open.iter().map(|other| self.masses[*own][*other]);
            row.collect()
        });
        let masses: Vec<Vec<Id>> = masses.collect();
        let driving: Vec<Id> = open.iter().map(|own| self.driving[*own]).collect();
        let rows: Vec<(Vec<Id>, Id)> = left
            .iter()
            .map(|row| {
                let row = &self.rows[*row];
                let slopes = open.iter().map(|own| row.slopes[*own]);
                (slopes.collect(), row.right)
            })
            .collect();
        let equations = together(self.work, &masses, &driving, &rows);
        self.work.graph.solve(equations, open.len() + left.len())
    }
}

/// `M x - A^T l = f`, `A x = r`; of the loads `-A M^-1 A^T` is left once the masses are eliminated.
fn together(
    work: &mut Workspace,
    masses: &[Vec<Id>],
    driving: &[Id],
    rows: &[(Vec<Id>, Id)],
) -> Vec<Equation> {
    let (count, zero) = (masses.len(), work.graph.zero());
    let mut sides = Vec::new();
    for (own, (masses, right)) in masses.iter().zip(driving).enumerate() {
        let mut coefficients = masses.clone();
        coefficients.extend(rows.iter().map(|(slopes, _)| work.graph.negate(slopes[own])));
        sides.push((coefficients, *right, (own, Size::Squares)));
    }
    for (number, (slopes, right)) in rows.iter().enumerate() {
        let coefficients = [slopes.clone(), vec![zero; rows.len()]].concat();
        sides.push((coefficients, *right, (count + number, Size::Reduced)));
    }
    let all: Vec<Id> = sides.iter().flat_map(|(row, ..)| row.clone()).collect();
    let mut values = samples(work, &all).into_iter();
    let equations = sides.into_iter().map(|(coefficients, right, (own, size))| {
        let mut sizes = vec![Size::Beside; coefficients.len()];
        sizes[own] = size;
        Equation {
            sample: values.by_ref().take(coefficients.len()).collect(),
            sizes,
            active: None,
            coefficients,
            right,
        }
    });
    equations.collect()
}

/// The sum of the products.
pub fn products(graph: &mut Graph, pairs: impl Iterator<Item = (Id, Id)>) -> Id {
    let parts: Vec<Id> = pairs.map(|(a, b)| graph.multiply(a, b)).collect();
    graph.sum(&parts)
}
