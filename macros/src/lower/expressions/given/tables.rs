//! Tables: `table(alpha, [-0.2, 0, 0.2], [-1.1, 0.1, 1.2][N])`; of two arguments,
//! `table(alpha, speed, [..], [..], [[..], [..]])`.

use proc_macro2::Ident;

use crate::errors::{Extent, every, hint};
use crate::model::Dimension;
use crate::symbolic::{Id, Number};
use crate::syntax::{Expression, Kind, file_beside};

use crate::lower::expressions::lowering::Lowering;
use crate::lower::expressions::scope::Value;
use crate::lower::expressions::unit::lower_unit;
use crate::lower::expressions::written::strip_unit;

use super::csv::File;
use super::grid::{Column, Course, Grid, looked_up};

const FORM: &str = "write `table(x, [0, 1, 2], [0, 1, 4])`: a scalar, where the values are, and these; of two scalars \
     `table(x, y, [0, 1], [0, 1, 2], [[0, 1, 4], [1, 2, 5]])`, a list of values for each x";
const OF_FILES: &str = "a table of a file is read at one scalar, `table(x, \"lift.csv\")`, with the name of a column \
     `table(x, \"polar.csv\", \"drag\")`, or at two, `table(x, y, \"lift.csv\")`";
/// How a table is interpolated between its values, and how it is continued beyond them.
const CHOICES: [[&str; 2]; 2] = [["linear", "cubic"], ["held", "extrapolated"]];

impl Lowering<'_> {
    pub fn table(&mut self, word: &Ident, arguments: &[Expression]) -> Option<Value> {
        let is_known = |name: &Ident| CHOICES.as_flattened().iter().any(|word| name == word);
        let is_word = |one: &&Expression| matches!(&one.kind, Kind::Name(name) if is_known(name));
        let words = arguments.iter().rev().take_while(is_word).count();
        let (written, words) = arguments.split_at(arguments.len() - words);
        let course = self.course(words)?;
        let is_text = |one: &&Expression| matches!(strip_unit(one).kind, Kind::Text(_));
        match written {
            [_, .., last] if is_text(&last) => self.table_of_file(written, course),
            [x, places, values] => self.table_of_one(x, [places, values], course),
            [x, y, rows, columns, values] => {
                self.table_of_two([x, y], [rows, columns], values, course)
            }
            [.., last] => {
                if let Kind::Name(name) = &last.kind
                    && written.len() == 4
                {
                    let hint = hint(&name.to_string(), CHOICES.as_flattened().iter().copied());
                    let words = CHOICES.as_flattened().join("`, `");
                    let message = format!("expected one of `{words}`{hint}");
                    return self.report(name.span(), message);
                }
                self.report(word.span(), FORM)
            }
            [] => self.report(word.span(), FORM),
        }
    }

    /// What the words at the end of a table say: at most one of each pair.
    fn course(&mut self, words: &[Expression]) -> Option<Course> {
        let mut course = Course::default();
        let mut said: [Option<&Ident>; 2] = [None; 2];
        for one in words {
            let Kind::Name(name) = &one.kind else {
                continue;
            };
            let choice = CHOICES
                .iter()
                .position(|pair| pair.iter().any(|word| name == word))?;
            match said[choice].replace(name) {
                Some(first) if first == name => {
                    return self.report(name.span(), format!("`{name}` is written twice"));
                }
                Some(first) => {
                    let message =
                        format!("a table is `{first}` or `{name}`: leave one of them out");
                    return self.report(name.span(), message);
                }
                None => {}
            }
            course.is_cubic |= name == "cubic";
            course.is_extrapolated |= name == "extrapolated";
        }
        Some(course)
    }

    /// `(x, "lift.csv")`, `(x, "polar.csv", "drag")` or `(x, y, "lift.csv")`. A unit after the last
    /// string is the unit of the values.
    fn table_of_file(&mut self, written: &[Expression], course: Course) -> Option<Value> {
        let texts = written
            .iter()
            .filter_map(|one| match &strip_unit(one).kind {
                Kind::Text(text) => Some((text.as_str(), one)),
                _ => None,
            });
        let texts: Vec<(&str, &Expression)> = texts.collect();
        let (scalars, _) = written.split_at(written.len() - texts.len());
        let arguments = every(scalars.iter().map(|one| self.argument(one)));
        let (name, place) = texts[0];
        let (path, text) = file_beside(name, place.extent, self.errors)?;
        let file = File::new(name, &text, strip_unit(place).extent, self.errors)?;
        self.work.files.extend(path);
        let unit = match texts.last() {
            Some((_, last)) => self.unit_of_values(last)?,
            None => None,
        };
        match (&arguments?[..], &texts[..]) {
            (&[(x, _)], [_, rest @ ..]) if rest.len() < 2 => {
                let asked = rest.first().map(|(word, place)| (*word, place.extent));
                let (knots, mut values) = file.columns(asked, self.errors)?;
                if let Some((factor, dimension)) = unit {
                    values.scale(&factor, dimension);
                }
                let value = (&knots.values()[..], &values.values()[..]);
                let value = looked_up(&mut self.work.graph, x, value, course)?;
                Some(Value::Scalar(value, values.dimension))
            }
            (&[(x, _), (y, _)], [_]) => {
                let mut grid = file.grid(self.errors)?;
                for values in &mut grid.values {
                    if let Some((factor, dimension)) = &unit {
                        values.scale(factor, *dimension);
                    }
                }
                let dimension = unit.map_or(Dimension::ANY, |(_, dimension)| dimension);
                let value = grid.looked_up(&mut self.work.graph, [x, y], course)?;
                Some(Value::Scalar(value, dimension))
            }
            _ => self.report(place.extent, OF_FILES),
        }
    }

    #[allow(clippy::option_option, reason = "outer: reported; inner: not written")]
    fn unit_of_values(&mut self, last: &Expression) -> Option<Option<(Number, Dimension)>> {
        match &last.kind {
            Kind::Unit(_, unit) => Some(Some(lower_unit(unit, self.errors)?)),
            _ => Some(None),
        }
    }

    fn table_of_one(
        &mut self,
        x: &Expression,
        [places, values]: [&Expression; 2],
        course: Course,
    ) -> Option<Value> {
        let (argument, knots, values) = (
            self.argument(x),
            self.increasing(places),
            self.column(values),
        );
        let ((x, of_x), knots) = (argument?, knots?);
        self.check_place(of_x, &knots, places)?;
        let values = values?;
        self.check_as_many(&knots, &values, places.extent)?;
        let both = (&knots.values()[..], &values.values()[..]);
        let value = looked_up(&mut self.work.graph, x, both, course)?;
        Some(Value::Scalar(value, values.dimension))
    }

    /// A table of two arguments, with values in rows and columns.
    fn table_of_two(
        &mut self,
        [x, y]: [&Expression; 2],
        [rows, columns]: [&Expression; 2],
        values: &Expression,
        course: Course,
    ) -> Option<Value> {
        let (x, y) = (self.argument(x), self.argument(y));
        let (of_rows, of_columns) = (self.increasing(rows), self.increasing(columns));
        let ((x, of_x), (y, of_y)) = (x?, y?);
        let (of_rows, of_columns) = (of_rows?, of_columns?);
        self.check_place(of_x, &of_rows, rows)?;
        self.check_place(of_y, &of_columns, columns)?;
        let (list, unit) = match &values.kind {
            Kind::Unit(inner, unit) => (&**inner, Some(unit)),
            _ => (values, None),
        };
        let (found, dimension) = self.rows_of_values(list, [&of_rows, &of_columns])?;
        let grid = Grid {
            rows: of_rows,
            columns: of_columns,
            values: found,
        };
        let sum = grid.looked_up(&mut self.work.graph, [x, y], course)?;
        let Some(unit) = unit else {
            return Some(Value::Scalar(sum, dimension));
        };
        let (factor, of_unit) = lower_unit(unit, self.errors)?;
        self.check_unitless(dimension, unit.extent)?;
        let factor = self.work.graph.number(factor);
        Some(Value::Scalar(
            self.work.graph.multiply(factor, sum),
            of_unit,
        ))
    }

    /// The lists of values, one for each row, all of one dimension.
    fn rows_of_values(
        &mut self,
        list: &Expression,
        [rows, columns]: [&Column; 2],
    ) -> Option<(Vec<Column>, Dimension)> {
        let Kind::List(lists) = &list.kind else {
            return self.report(list.extent, FORM);
        };
        if lists.len() != rows.numbers.len() {
            let message = format!(
                "a list of values for each of {} grid points, and these are {}",
                rows.numbers.len(),
                lists.len()
            );
            return self.report(list.extent, message);
        }
        let found = every(lists.iter().map(|list| {
            let column = self.column(list)?;
            self.check_as_many(columns, &column, list.extent)?;
            Some(column)
        }))?;
        let mut dimension = Dimension::ANY;
        for (list, column) in lists.iter().zip(&found) {
            let Some(unified) = dimension.unify(column.dimension) else {
                let (this, other) = (column.dimension.described(), dimension.described());
                let message = format!("this is {this}, and values before it are {other}");
                return self.report(list.extent, message);
            };
            dimension = unified;
        }
        Some((found, dimension))
    }

    /// The scalar at which a table is evaluated.
    fn argument(&mut self, written: &Expression) -> Option<(Id, Dimension)> {
        match self.value(written)? {
            Value::Scalar(id, dimension) => Some((id, dimension)),
            other => self.report(
                written.extent,
                format!("a table is read at a scalar, and this is {}", other.kind()),
            ),
        }
    }

    /// A list of numbers.
    fn column(&mut self, written: &Expression) -> Option<Column> {
        let (list, unit) = match &written.kind {
            Kind::Unit(inner, unit) => (&**inner, Some(unit)),
            _ => (written, None),
        };
        let Kind::List(entries) = &list.kind else {
            return self.report(
                written.extent,
                "expected a list of numbers, such as `[0, 0.1, 0.3]`",
            );
        };
        let unit = match unit {
            Some(unit) => Some((lower_unit(unit, self.errors)?, unit.extent)),
            None => None,
        };
        let mut dimension = Dimension::ANY;
        let mut numbers = Some(Vec::new());
        for entry in entries {
            let number = self.entry(entry, &mut dimension);
            match (&mut numbers, number) {
                (Some(all), Some(number)) => all.push((number, entry.extent)),
                _ => numbers = None,
            }
        }
        let numbers = numbers?;
        if let Some(((factor, of_unit), place)) = unit {
            self.check_unitless(dimension, place)?;
            let mut column = Column { numbers, dimension };
            column.scale(&factor, of_unit);
            return Some(column);
        }
        Some(Column { numbers, dimension })
    }

    fn entry(&mut self, written: &Expression, dimension: &mut Dimension) -> Option<Number> {
        let Value::Scalar(id, found) = self.value(written)? else {
            return self.report(written.extent, "a table is made of numbers");
        };
        let Some(unified) = dimension.unify(found) else {
            let (this, other) = (found.described(), dimension.described());
            let message = format!("this is {this}, and numbers before it are {other}");
            return self.report(written.extent, message);
        };
        *dimension = unified;
        match self.work.graph.as_number(id) {
            Some(number) => Some(number.clone()),
            None => self.report(
                written.extent,
                "a table is made of numbers, and this is not known while the code is written",
            ),
        }
    }

    /// Grid points in increasing order.
    fn increasing(&mut self, written: &Expression) -> Option<Column> {
        let column = self.column(written)?;
        if column.numbers.len() < 2 {
            return self.report(written.extent, "a table has two values at least");
        }
        if let Some(place) = column.first_back() {
            return self.report(
                place,
                "the grid points of a table must increase, and this one does not exceed the one before it",
            );
        }
        Some(column)
    }

    fn check_place(&mut self, of_x: Dimension, knots: &Column, places: &Expression) -> Option<()> {
        if of_x.fits(knots.dimension) {
            return Some(());
        }
        let (these, x) = (knots.dimension.described(), of_x.described());
        let message = format!("the grid points are {these}, but the argument is {x}");
        self.report(places.extent, message)
    }

    fn check_as_many(&mut self, knots: &Column, values: &Column, place: Extent) -> Option<()> {
        let (count, expected) = (values.numbers.len(), knots.numbers.len());
        if count == expected {
            return Some(());
        }
        let message = format!(
            "a table has a value for each grid point: there are {expected} points and {count} values"
        );
        self.report(place, message)
    }
}
