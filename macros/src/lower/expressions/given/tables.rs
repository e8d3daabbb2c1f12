//! Tables: `table(alpha, [-0.2, 0, 0.2], [-1.1, 0.1, 1.2][N])`, of two numbers
//! `table(alpha, speed, [..], [..], [[..], [..]])`.

use proc_macro2::Ident;

use crate::errors::{Extent, every, hint};
use crate::model::Dimension;
use crate::symbolic::{Function, Id, Number, Table};
use crate::syntax::{Expression, Kind};

use crate::lower::expressions::lowering::Lowering;
use crate::lower::expressions::scope::Value;
use crate::lower::expressions::unit::lower_unit;

const FORM: &str = "write `table(x, [0, 1, 2], [0, 1, 4])`: a scalar, where the values are, and these; of two scalars \
     `table(x, y, [0, 1], [0, 1, 2], [[0, 1, 4], [1, 2, 5]])`, a list of values for each x";
/// How a table goes on between its values and beyond them.
const WORDS: [&str; 4] = ["linear", "cubic", "held", "extrapolated"];

/// How a table goes on.
#[derive(Clone, Copy, Default)]
struct Course {
    is_cubic: bool,
    is_extrapolated: bool,
}

/// Numbers of one dimension, each with its place.
struct Column {
    numbers: Vec<(Number, Extent)>,
    dimension: Dimension,
}

impl Column {
    fn values(&self) -> impl Iterator<Item = &Number> {
        self.numbers.iter().map(|(number, _)| number)
    }
}

impl Lowering<'_> {
    pub fn table(
        &mut self,
        word: &Ident,
        arguments: &[Expression],
        extent: Extent,
    ) -> Option<Value> {
        let is_word = |one: &&Expression| matches!(&one.kind, Kind::Name(name) if WORDS.contains(&&*name.to_string()));
        let words = arguments.iter().rev().take_while(is_word).count();
        let (written, words) = arguments.split_at(arguments.len() - words);
        let mut course = Course::default();
        for one in words {
            if let Kind::Name(name) = &one.kind {
                course.is_cubic |= name == "cubic";
                course.is_extrapolated |= name == "extrapolated";
            }
        }
        match written {
            [x, places, values] => self.table_of_one(x, [places, values], course),
            [x, y, rows, columns, values] => {
                if course.is_cubic {
                    let place = words.first().map_or(extent, |one| one.extent);
                    return self.report(
                        place,
                        "a table of two scalars is linear in each of them: leave `cubic` out",
                    );
                }
                self.table_of_two([x, y], [rows, columns], values, course)
            }
            [.., last] => {
                if let Kind::Name(name) = &last.kind
                    && written.len() == 4
                {
                    let hint = hint(&name.to_string(), WORDS);
                    let words = WORDS.join("`, `");
                    let message = format!("a table goes on as `{words}`{hint}");
                    return self.report(name.span(), message);
                }
                self.report(word.span(), FORM)
            }
            [] => self.report(word.span(), FORM),
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
        let value = self.looked_up(x, &knots, &values, course)?;
        Some(Value::Scalar(value, values.dimension))
    }

    /// Linear in each: by its share of each row, a table in y.
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
        let Kind::List(lists) = &list.kind else {
            return self.report(list.extent, FORM);
        };
        if lists.len() != of_rows.numbers.len() {
            let message = format!(
                "a list of values for each of {} places, and these are {}",
                of_rows.numbers.len(),
                lists.len()
            );
            return self.report(list.extent, message);
        }
        let found = every(lists.iter().map(|list| {
            let column = self.column(list)?;
            self.check_as_many(&of_columns, &column, list.extent)?;
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
        let mut sum = self.work.graph.zero();
        for (place, column) in found.iter().enumerate() {
            let share = (0..lists.len()).map(|row| Number::integer(i64::from(row == place)));
            let share = Column {
                numbers: share.map(|number| (number, list.extent)).collect(),
                dimension: Dimension::NONE,
            };
            let share = self.looked_up(x, &of_rows, &share, course)?;
            let value = self.looked_up(y, &of_columns, column, course)?;
            let part = self.work.graph.multiply(share, value);
            sum = self.work.graph.add(sum, part);
        }
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

    /// What a table is read at.
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
        let mut numbers = numbers?;
        if let Some(((factor, of_unit), place)) = unit {
            self.check_unitless(dimension, place)?;
            dimension = of_unit;
            for (number, _) in &mut numbers {
                *number = number.clone() * factor.clone();
            }
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

    /// Where values are: each beyond the one before.
    fn increasing(&mut self, written: &Expression) -> Option<Column> {
        let column = self.column(written)?;
        if column.numbers.len() < 2 {
            return self.report(written.extent, "a table has two values at least");
        }
        let pairs = column.numbers.windows(2);
        let mut back = pairs.filter(|pair| !(pair[1].0.clone() - pair[0].0.clone()).is_positive());
        if let Some([_, (_, place)]) = back.next() {
            let place = *place;
            return self.report(
                place,
                "the places of a table increase, and this is not beyond the one before",
            );
        }
        Some(column)
    }

    fn check_place(&mut self, of_x: Dimension, knots: &Column, places: &Expression) -> Option<()> {
        if of_x.fits(knots.dimension) {
            return Some(());
        }
        let (these, x) = (knots.dimension.described(), of_x.described());
        let message = format!("these places are {these}, and what the table is read at is {x}");
        self.report(places.extent, message)
    }

    fn check_as_many(&mut self, knots: &Column, values: &Column, place: Extent) -> Option<()> {
        let (count, expected) = (values.numbers.len(), knots.numbers.len());
        if count == expected {
            return Some(());
        }
        let message = format!(
            "a table has a value for each place: there are {expected} places and {count} values"
        );
        self.report(place, message)
    }

    /// The value of a table.
    fn looked_up(&mut self, x: Id, knots: &Column, values: &Column, course: Course) -> Option<Id> {
        let knots: Vec<(Number, Number)> = knots
            .values()
            .cloned()
            .zip(values.values().cloned())
            .collect();
        let table = if course.is_cubic {
            Table::cubic(&knots, course.is_extrapolated)
        } else {
            Table::linear(&knots, course.is_extrapolated)
        }?;
        let graph = &mut self.work.graph;
        let number = graph.new_table(table);
        Some(graph.apply(Function::Table, &[x, number]))
    }
}
