//! Tables in files: `table(alpha, "lift.csv")`; with the name of a column,
//! `table(alpha, "polar.csv", "drag")`; with two arguments, `table(alpha, speed, "lift.csv")`.
//!
//! Commas separate cells. Empty lines and lines that begin with `#` are skipped. The first row is a
//! header if none of its cells is a number.

use crate::errors::{Errors, Extent, every, hint};
use crate::model::Dimension;
use crate::symbolic::Number;

use super::grid::{Column, Grid};

/// A row: its line number, and its cells.
struct Row<'t> {
    line: usize,
    cells: Vec<&'t str>,
}

/// A file, and the place in the description that names it.
pub struct File<'t> {
    name: &'t str,
    place: Extent,
    rows: Vec<Row<'t>>,
}

impl<'t> File<'t> {
    pub fn new(name: &'t str, text: &'t str, place: Extent, errors: &mut Errors) -> Option<Self> {
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        let lines = text.lines().enumerate();
        let lines = lines.filter(|(_, line)| !line.trim().is_empty() && !line.starts_with('#'));
        let rows = lines.map(|(number, line)| Row {
            line: number + 1,
            cells: line
                .split(',')
                .map(|cell| cell.trim().trim_matches('"'))
                .collect(),
        });
        let rows: Vec<Row<'_>> = rows.collect();
        if rows.is_empty() {
            return errors.report(place, format!("`{name}` is empty"));
        }
        let file = Self { name, place, rows };
        file.check_as_long(errors)?;
        Some(file)
    }

    /// Reports a row that is not as long as the first.
    fn check_as_long(&self, errors: &mut Errors) -> Option<()> {
        let expected = self.rows[0].cells.len();
        every(self.rows.iter().map(|row| {
            let count = row.cells.len();
            if count == expected {
                return Some(());
            }
            let message = format!("cells: {count} here, and {expected} in the first row");
            let place = self.at(row, errors);
            errors.report(place, message)
        }))?;
        Some(())
    }

    /// The grid points in the first column, and the values in the named column, or in the only
    /// other one.
    pub fn columns(
        mut self,
        asked: Option<(&str, Extent)>,
        errors: &mut Errors,
    ) -> Option<(Column, Column)> {
        let has_header = self.rows[0].cells.iter().all(|cell| number(cell).is_none());
        let header = has_header.then(|| self.rows.remove(0).cells);
        let column = match (asked, header) {
            (Some((word, place)), Some(header)) => {
                let mut named = (1..header.len()).filter(|column| header[*column] == word);
                let Some(found) = named.next() else {
                    let words = header[1..].join("`, `");
                    let hint = hint(word, header.iter().skip(1).copied());
                    let message = format!("`{}` has the columns `{words}`{hint}", self.name);
                    return errors.report(place, message);
                };
                if named.next().is_some() {
                    let message = format!("`{}` has several columns `{word}`", self.name);
                    return errors.report(place, message);
                }
                found
            }
            (Some((_, place)), None) => {
                let message = format!("`{}` has no header that names its columns", self.name);
                return errors.report(place, message);
            }
            (None, header) => self.only_column(header, errors)?,
        };
        let (places, values) = (self.column(0, errors), self.column(column, errors));
        let (places, values) = (places?, values?);
        Some((self.increasing(places, errors)?, values))
    }

    fn only_column(&self, header: Option<Vec<&str>>, errors: &mut Errors) -> Option<usize> {
        let count = header.as_ref().map_or_else(
            || self.rows.first().map_or(2, |row| row.cells.len()),
            Vec::len,
        );
        let message = match count {
            2 => return Some(1),
            1 => format!(
                "`{}` has one column: a table has grid points and values",
                self.name
            ),
            _ => {
                let words = header.map_or_else(String::new, |words| {
                    format!(": `{}`", words[1..].join("`, `"))
                });
                let name = self.name;
                format!("which column? write its name, `table(x, \"{name}\", \"..\")`{words}")
            }
        };
        errors.report(self.place, message)
    }

    /// A table of two arguments. The first row has the grid points of the second argument, after a
    /// cell that is ignored. Each further row begins with a grid point of the first argument, and
    /// then has the values.
    pub fn grid(mut self, errors: &mut Errors) -> Option<Grid> {
        if self.rows[0].cells.len() < 3 {
            let message = format!(
                "`{}` needs two columns of values after the grid points",
                self.name
            );
            return errors.report(self.place, message);
        }
        let first = self.rows.remove(0);
        let columns = self.cells(&first, errors);
        let columns = columns.and_then(|columns| self.increasing(columns, errors));
        let rows = self.column(0, errors);
        let rows = rows.and_then(|rows| self.increasing(rows, errors));
        let values = every(self.rows.iter().map(|row| self.cells(row, errors)));
        Some(Grid {
            rows: rows?,
            columns: columns?,
            values: values?,
        })
    }

    /// The numbers in a row, except its first cell.
    fn cells(&self, row: &Row<'_>, errors: &mut Errors) -> Option<Column> {
        let cells = row.cells[1..].iter();
        plain(every(cells.map(|cell| self.number(row, cell, errors)))?)
    }

    fn column(&self, column: usize, errors: &mut Errors) -> Option<Column> {
        let rows = self.rows.iter();
        plain(every(
            rows.map(|row| self.number(row, row.cells[column], errors)),
        )?)
    }

    fn number(&self, row: &Row<'_>, cell: &str, errors: &mut Errors) -> Option<(Number, Extent)> {
        let place = self.at(row, errors);
        match number(cell) {
            Some(number) if number.fits_f64() => Some((number, place)),
            Some(_) => errors.report(place, format!("`{cell}` is out of the range of `f64`")),
            None => errors.report(place, format!("`{cell}` is not a number")),
        }
    }

    fn increasing(&self, column: Column, errors: &mut Errors) -> Option<Column> {
        if column.numbers.len() < 2 {
            let message = format!("`{}` has fewer than two rows of values", self.name);
            return errors.report(self.place, message);
        }
        match column.first_back() {
            None => Some(column),
            Some(place) => errors.report(
                place,
                "the grid points of a table must increase, and this one does not exceed the one before it",
            ),
        }
    }

    /// The place of a row.
    fn at(&self, row: &Row<'_>, errors: &mut Errors) -> Extent {
        let source = errors.source(format!("`{}`, line {}", self.name, row.line));
        self.place.within(source)
    }
}

/// Numbers without a unit.
#[allow(clippy::unnecessary_wraps, reason = "it ends chains of `?`")]
fn plain(numbers: Vec<(Number, Extent)>) -> Option<Column> {
    Some(Column {
        numbers,
        dimension: Dimension::ANY,
    })
}

/// A decimal number.
fn number(cell: &str) -> Option<Number> {
    let is_decimal = |c: char| c.is_ascii_digit() || "+-.eE".contains(c);
    let has_digit = cell.starts_with(|c: char| c.is_ascii_digit() || "+-.".contains(c));
    let cell = cell.strip_prefix('+').unwrap_or(cell);
    (has_digit && cell.chars().all(is_decimal))
        .then(|| Number::parse(cell))
        .flatten()
}
