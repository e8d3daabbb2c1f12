//! Grid points of tables, and their values as expressions.

use crate::errors::Extent;
use crate::model::Dimension;
use crate::symbolic::{Function, Graph, Id, Number, Table};

/// How a table is interpolated.
#[derive(Clone, Copy, Default)]
pub struct Course {
    pub is_cubic: bool,
    pub is_extrapolated: bool,
}

/// Numbers of one dimension, each with its place.
#[derive(Clone)]
pub struct Column {
    pub numbers: Vec<(Number, Extent)>,
    pub dimension: Dimension,
}

/// Values in rows and columns.
pub struct Grid {
    pub rows: Column,
    pub columns: Column,
    /// The values of each row.
    pub values: Vec<Column>,
}

impl Column {
    pub fn values(&self) -> Vec<Number> {
        self.numbers
            .iter()
            .map(|(number, _)| number.clone())
            .collect()
    }

    /// The place of the first number that is not greater than the one before it.
    pub fn first_back(&self) -> Option<Extent> {
        let mut pairs = self.numbers.windows(2);
        let back = pairs.find(|pair| !(pair[1].0.clone() - pair[0].0.clone()).is_positive());
        back.map(|pair| pair[1].1)
    }

    /// Converts the numbers from a unit of this size and dimension.
    pub fn scale(&mut self, factor: &Number, dimension: Dimension) {
        self.dimension = dimension;
        for (number, _) in &mut self.numbers {
            *number = number.clone() * factor.clone();
        }
    }
}

/// The value of a table of one argument.
pub fn looked_up(
    graph: &mut Graph,
    x: Id,
    (knots, values): (&[Number], &[Number]),
    course: Course,
) -> Option<Id> {
    let knots: Vec<(Number, Number)> = pairs(knots, values);
    let table = if course.is_cubic {
        Table::cubic(&knots, course.is_extrapolated)
    } else {
        Table::linear(&knots, course.is_extrapolated)
    }?;
    Some(read(graph, x, table))
}

impl Grid {
    /// The sum over all rows of the weight of the row, a table in x, times the value of the row at
    /// y, also a table.
    ///
    /// For cubics, the slopes across the rows are interpolated too: at y, each is a cubic through
    /// the slopes at the grid points. The result is a bicubic polynomial in each rectangle, with
    /// continuous slopes. At the grid points, the slopes are those of the cubics along rows and
    /// columns, which are limited (the first step of R. Carlson and F. Fritsch, Monotone Piecewise
    /// Bicubic Interpolation, SIAM J. Numer. Anal. 22, 1985, 386). Between the grid lines nothing
    /// is limited.
    pub fn looked_up(&self, graph: &mut Graph, [x, y]: [Id; 2], course: Course) -> Option<Id> {
        let (rows, columns) = (self.rows.values(), self.columns.values());
        let across = if course.is_cubic {
            Some(self.slopes_across(&rows)?)
        } else {
            None
        };
        let none = vec![Number::zero(); rows.len()];
        let mut sum = graph.zero();
        for (row, values) in self.values.iter().enumerate() {
            let mut unit = none.clone();
            unit[row] = Number::one();
            let value = looked_up(graph, y, (&columns, &values.values()), course)?;
            let Some(across) = &across else {
                let share = looked_up(graph, x, (&rows, &unit), course)?;
                let part = graph.multiply(share, value);
                sum = graph.add(sum, part);
                continue;
            };
            let slope = looked_up(graph, y, (&columns, &across[row]), course)?;
            let shares = [(&unit, &none, value), (&none, &unit, slope)];
            for (values, slopes, factor) in shares {
                let knots = pairs(&rows, values);
                let share = Table::hermite(&knots, slopes, course.is_extrapolated)?;
                let share = read(graph, x, share);
                let part = graph.multiply(share, factor);
                sum = graph.add(sum, part);
            }
        }
        Some(sum)
    }

    /// The slopes of the columns from row to row: for each row, one at each of its grid points.
    fn slopes_across(&self, rows: &[Number]) -> Option<Vec<Vec<Number>>> {
        let mut across = vec![Vec::new(); rows.len()];
        for column in 0..self.columns.numbers.len() {
            let values = self.values.iter().map(|row| row.numbers[column].0.clone());
            let values: Vec<Number> = values.collect();
            let slopes = Table::slopes(&pairs(rows, &values))?;
            for (row, slope) in across.iter_mut().zip(slopes) {
                row.push(slope);
            }
        }
        Some(across)
    }
}

fn pairs(places: &[Number], values: &[Number]) -> Vec<(Number, Number)> {
    places.iter().cloned().zip(values.iter().cloned()).collect()
}

fn read(graph: &mut Graph, x: Id, table: Table) -> Id {
    let number = graph.new_table(table);
    graph.apply(Function::Table, &[x, number])
}
