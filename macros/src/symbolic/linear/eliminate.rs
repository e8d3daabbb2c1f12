//! Linear equations with coefficients that depend on the configuration, solved by elimination.
//!
//! What vanishes is proved: every row carries its coefficients at one random state, on each branch, and
//! they are eliminated along with it. Pivots are what vanishes on no branch, and of these ones before
//! numbers before what is positive by its structure, there first what is known early, before anything
//! else, at last what the values of parameters may make zero; a division by what depends on the
//! configuration is guarded ([`Graph::pivot`]).
//!
//! An equation that says nothing on some branch has the solution zero there for the unknown that it is
//! solved for.

use crate::symbolic::graph::{Graph, Id, Node};
use crate::symbolic::number::Function;
use crate::symbolic::zeros::Sample;

/// `sum of coefficients * unknowns = right`
pub struct Row {
    pub coefficients: Vec<Id>,
    pub right: Id,
    /// The coefficients at a random state.
    pub sample: Vec<Sample>,
    /// Where it says something, if that is not everywhere.
    pub active: Option<Id>,
    /// What is known of each coefficient.
    pub sizes: Vec<Size>,
}

/// What a coefficient is compared with before it is divided by.
#[derive(Clone, Copy, Debug)]
pub enum Size {
    /// It is a sum of squares, and remains positive if others are eliminated: it is compared with
    /// itself as it was.
    Squares,
    /// It is a product of two vectors, with the product of their lengths.
    Product(Id),
    /// It is compared with the largest of its terms.
    Terms,
}

/// What equations say of their unknowns.
pub struct Elimination {
    /// The value of each unknown; that of an undetermined one is zero.
    pub values: Vec<Id>,
    /// The guarded reciprocals, each with the unknown that it gives.
    pub pivots: Vec<(usize, Id)>,
    /// Unknowns that the equations do not determine.
    pub undetermined: Vec<usize>,
    /// Rows that are left over.
    pub spare: Vec<usize>,
}

/// A row that is solved for an unknown, and one over its coefficient.
struct Step {
    row: usize,
    column: usize,
    inverse: Id,
}

impl Graph {
    pub fn solve_guarded(&mut self, mut rows: Vec<Row>, unknowns: usize) -> Elimination {
        let written: Vec<Vec<Id>> = rows.iter().map(|row| row.coefficients.clone()).collect();
        let mut left: Vec<usize> = (0..rows.len()).collect();
        let mut steps: Vec<Step> = Vec::new();
        let mut pivots = Vec::new();
        while let Some((row, column)) = self.next_pivot(&rows, &left, unknowns, &steps) {
            left.retain(|other| *other != row);
            let divisor = rows[row].coefficients[column];
            let divisor = match rows[row].active {
                Some(active) => {
                    let (zero, one) = (self.zero(), self.one());
                    rows[row].right = self.select(active, rows[row].right, zero);
                    self.select(active, divisor, one)
                }
                None => divisor,
            };
            let divisor = self.quantity(divisor);
            let scale = match rows[row].sizes[column] {
                Size::Squares => written[row][column],
                Size::Product(size) => size,
                Size::Terms => self.largest_term(rows[row].coefficients[column]),
            };
            let inverse = self.pivot(divisor, scale);
            if matches!(self.node(inverse), Node::Pivot(..)) {
                pivots.push((column, inverse));
            }
            for &other in &left {
                self.reduce(&mut rows, (row, column), other, inverse);
            }
            steps.push(Step {
                row,
                column,
                inverse,
            });
        }
        let zero = self.zero();
        let mut values = vec![zero; unknowns];
        for step in steps.iter().rev() {
            let mut rest = rows[step.row].right;
            for other in (0..unknowns).filter(|other| *other != step.column) {
                let known = self.multiply(rows[step.row].coefficients[other], values[other]);
                rest = self.subtract(rest, known);
            }
            let value = if self.is_early(step.inverse) {
                self.distribute(step.inverse, rest)
            } else {
                self.multiply(step.inverse, rest)
            };
            values[step.column] = self.quantity(value);
        }
        let solved = |column: &usize| steps.iter().any(|step| step.column == *column);
        Elimination {
            values,
            pivots,
            undetermined: (0..unknowns).filter(|column| !solved(column)).collect(),
            spare: left,
        }
    }

    /// Takes a multiple of the row of a pivot from another, so that its unknown drops out.
    fn reduce(&mut self, rows: &mut [Row], pivot: (usize, usize), other: usize, inverse: Id) {
        let (row, column) = pivot;
        if rows[other].sample[column].is_zero() {
            rows[other].coefficients[column] = self.zero();
            return;
        }
        let factor = self.multiply(rows[other].coefficients[column], inverse);
        let ratio = rows[other].sample[column].over(&rows[row].sample[column]);
        for index in 0..rows[other].coefficients.len() {
            let sample = rows[other].sample[index].less(&ratio, &rows[row].sample[index]);
            let vanishes = sample.is_zero() || index == column;
            rows[other].coefficients[index] = if vanishes {
                self.zero()
            } else {
                let change = self.multiply(factor, rows[row].coefficients[index]);
                self.subtract(rows[other].coefficients[index], change)
            };
            rows[other].sample[index] = if vanishes { sample.nothing() } else { sample };
        }
        let change = self.multiply(factor, rows[row].right);
        rows[other].right = self.subtract(rows[other].right, change);
    }

    /// The best coefficient that does not vanish.
    fn next_pivot(
        &self,
        rows: &[Row],
        left: &[usize],
        unknowns: usize,
        steps: &[Step],
    ) -> Option<(usize, usize)> {
        let open = (0..unknowns).filter(|column| steps.iter().all(|step| step.column != *column));
        let candidates = open.flat_map(|column| left.iter().map(move |row| (*row, column)));
        let there = candidates.filter(|(row, column)| !rows[*row].sample[*column].is_zero());
        there.min_by_key(|&(row, column)| {
            let coefficient = rows[row].coefficients[column];
            let kind = match (self.as_number(coefficient), rows[row].sizes[column]) {
                (Some(number), _) if number.abs().is_one() => 0,
                (Some(_), _) => 1,
                (None, Size::Squares) if self.is_early(coefficient) => 2,
                (None, Size::Squares) => 3,
                // a coefficient of friction, a slope
                _ if self.may_be_zero_early(coefficient) => 6,
                _ if self.is_early(coefficient) => 4,
                _ => 5,
            };
            let others = rows[row].sample.iter().filter(|entry| !entry.is_zero());
            let may_vanish = rows[row].sample[column].may_vanish();
            (may_vanish, kind, others.count(), row, column)
        })
    }

    /// Whether what is known early, by itself or as a factor, may be zero: values of parameters are
    /// as they like, and what is the same but for rounding is subtracted. One more than they are is
    /// not.
    fn may_be_zero_early(&self, a: Id) -> bool {
        let is_early = self.is_early(a);
        let may = |a: Id| self.may_be_zero_early(a);
        match *self.node(a) {
            Node::Number(ref number) => number.is_zero(),
            Node::Quantity(a) | Node::Negate(a) | Node::Divide(a, _) => may(a),
            Node::Multiply(a, b) => may(a) || may(b),
            Node::Add(a, b) => is_early && may(a) && may(b),
            Node::Subtract(a, b) => is_early && may(a) == may(b),
            Node::Unary(Function::Exp | Function::Cosh, _) => false,
            Node::Unary(_, a) => is_early && may(a),
            _ => is_early,
        }
    }

    /// The size of the largest term of a sum.
    pub fn largest_term(&mut self, sum: Id) -> Id {
        let mut largest = self.zero();
        for (_, term) in self.terms(sum) {
            let size = self.apply(Function::Abs, &[term]);
            largest = if self.is_zero(largest) {
                size
            } else {
                self.apply(Function::Max, &[largest, size])
            };
        }
        largest
    }
}
