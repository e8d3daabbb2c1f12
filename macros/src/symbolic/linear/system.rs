//! Linear equations while they are being solved, and one step of their elimination.

use crate::symbolic::graph::{Graph, Id, Node};
use crate::symbolic::zeros::Sample;

use super::sizes::Size;

/// `sum of coefficients * unknowns = right`
#[derive(Clone)]
pub struct Equation {
    pub coefficients: Vec<Id>,
    pub right: Id,
    /// The coefficients at a random state.
    pub sample: Vec<Sample>,
    /// The condition under which it is not trivial, if there are branches where it is.
    pub active: Option<Id>,
    /// The known properties of each coefficient.
    pub sizes: Vec<Size>,
}

/// The solution of equations for their unknowns.
pub struct Elimination {
    /// The value of each unknown; that of an undetermined one is zero.
    pub values: Vec<Id>,
    /// The guarded reciprocals, each with its unknown.
    pub pivots: Vec<(usize, Id)>,
    /// The unknowns that the equations do not determine.
    pub undetermined: Vec<Undetermined>,
    /// The remaining rows, with the remainder of their right sides.
    pub spare: Vec<(usize, Id)>,
    /// The equations as they are left: each without the unknowns that were solved for before it.
    pub left: Vec<Equation>,
}

/// An unknown that is determined only together with others, if at all.
pub struct Undetermined {
    pub column: usize,
    /// The unknowns that can replace it.
    pub others: Vec<usize>,
    /// A sum of unknowns with factors, including this one, that is determined. If there are no
    /// others, this unknown alone.
    pub sum: Vec<(usize, Id)>,
}

/// Equations while they are being solved.
pub(super) struct System<'g> {
    pub graph: &'g mut Graph,
    pub rows: Vec<Equation>,
    /// The coefficients as written.
    pub written: Vec<Vec<Id>>,
    pub unknowns: usize,
    /// The rows that are not solved yet.
    pub left: Vec<usize>,
    /// Whether all sums of squares are eliminated, and `written` contains the result.
    pub is_reduced: bool,
    pub steps: Vec<Step>,
    pub pivots: Vec<(usize, Id)>,
}

/// A row solved for an unknown, and the reciprocal of its coefficient.
pub(super) struct Step {
    pub row: usize,
    pub column: usize,
    pub inverse: Id,
}

impl System<'_> {
    /// The unknowns that are not solved yet.
    pub(super) fn open(&self) -> impl Iterator<Item = usize> {
        let is_open = |column: &usize| self.steps.iter().all(|step| step.column != *column);
        (0..self.unknowns).filter(is_open)
    }

    pub(super) fn is_there(&self, row: usize, column: usize) -> bool {
        !self.rows[row].sample[column].is_zero()
    }

    /// A coefficient; zero if it is proved to vanish in all states.
    pub(super) fn coefficient(&self, row: usize, column: usize) -> Id {
        if self.is_there(row, column) {
            self.rows[row].coefficients[column]
        } else {
            self.graph.zero()
        }
    }

    /// Solves a row for an unknown, and eliminates the unknown from the other rows.
    pub(super) fn eliminate(&mut self, row: usize, column: usize) {
        let divisor = self.rows[row].coefficients[column];
        let divisor = match self.rows[row].active {
            Some(active) => {
                let (zero, one) = (self.graph.zero(), self.graph.one());
                self.rows[row].right = self.graph.select(active, self.rows[row].right, zero);
                self.graph.select(active, divisor, one)
            }
            None => divisor,
        };
        let divisor = self.graph.quantity(divisor);
        let size = match self.rows[row].sizes[column] {
            Size::Squares | Size::Reduced => self.written[row][column],
            Size::Product(size) => size,
            Size::Terms | Size::Masses | Size::Beside => {
                self.graph.largest_term(self.rows[row].coefficients[column])
            }
        };
        let inverse = self.graph.pivot(divisor, size);
        self.give(row, column, inverse);
        for other in self.left.clone() {
            self.reduce((row, column), other, inverse);
        }
    }

    /// Records that this row gives this unknown, by the reciprocal of its coefficient.
    pub(super) fn give(&mut self, row: usize, column: usize, inverse: Id) {
        self.left.retain(|other| *other != row);
        let is_new = self.pivots.iter().all(|(_, known)| *known != inverse);
        if is_new && matches!(self.graph.node(inverse), Node::Pivot(..)) {
            self.pivots.push((column, inverse));
        }
        self.steps.push(Step {
            row,
            column,
            inverse,
        });
    }

    /// Subtracts a multiple of a pivot's row from another row, to eliminate its unknown.
    fn reduce(&mut self, (row, column): (usize, usize), other: usize, inverse: Id) {
        let (graph, rows) = (&mut *self.graph, &mut self.rows);
        if rows[other].sample[column].is_zero() {
            rows[other].coefficients[column] = graph.zero();
            return;
        }
        let factor = graph.multiply(rows[other].coefficients[column], inverse);
        let ratio = rows[other].sample[column].over(&rows[row].sample[column]);
        for index in 0..rows[other].coefficients.len() {
            let sample = rows[other].sample[index].minus(&ratio.times(&rows[row].sample[index]));
            let vanishes = sample.is_zero() || index == column;
            rows[other].coefficients[index] = if vanishes {
                graph.zero()
            } else {
                let change = graph.multiply(factor, rows[row].coefficients[index]);
                graph.subtract(rows[other].coefficients[index], change)
            };
            rows[other].sample[index] = if vanishes { sample.nothing() } else { sample };
        }
        let change = if graph.is_early(factor) {
            graph.distribute(factor, rows[row].right)
        } else {
            graph.multiply(factor, rows[row].right)
        };
        rows[other].right = graph.subtract(rows[other].right, change);
    }
}
