//! Curves of samples, by name or by function.

use std::fmt;
use std::string::{String, ToString as _};
use std::vec::Vec;

use crate::bodies::columns::{Columns, Named, Sink};
use crate::integrate::Sample;
use crate::numbers::messages::debug_as_display;

/// Numbers over the samples.
#[derive(Clone, Debug)]
pub(super) struct Curve {
    pub(super) name: String,
    pub(super) unit: String,
    pub(super) numbers: Vec<f64>,
}

impl Curve {
    pub(super) fn of<S>(
        samples: &[Sample<S>],
        name: &str,
        unit: &str,
        function: impl Fn(f64, &S) -> f64,
    ) -> Self {
        let numbers = samples.iter();
        Self {
            name: name.to_string(),
            unit: unit.to_string(),
            numbers: numbers
                .map(|sample| function(sample.time, &sample.state))
                .collect(),
        }
    }
}

/// A name that is none of a state's columns.
#[derive(Clone, PartialEq, Eq)]
pub struct UnknownColumn {
    /// The name.
    pub name: String,
    /// The names that there are.
    pub known: String,
}

impl fmt::Display for UnknownColumn {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { name, known } = self;
        write!(f, "no column is called `{name}`; there are {known}")
    }
}

debug_as_display!(UnknownColumn);

impl core::error::Error for UnknownColumn {}

/// The columns with these names. The name of a part selects all of its columns.
pub(super) fn columns<S: Columns<f64> + Named>(
    samples: &[Sample<S>],
    names: &[&str],
) -> Result<Vec<Curve>, UnknownColumn> {
    let mut known = Vec::new();
    let all: Result<(), core::convert::Infallible> = S::NAMES.each(&mut |column| {
        known.push((column.to_string(), column.unit));
        Ok(())
    });
    let Ok(()) = all;
    let rows: Vec<Vec<f64>> = samples
        .iter()
        .map(|sample| numbers(&sample.state))
        .collect();
    let mut curves = Vec::new();
    for asked in names {
        let is_asked = |column: &str| {
            let rest = column.strip_prefix(asked);
            rest.is_some_and(|rest| rest.is_empty() || rest.starts_with('.'))
        };
        let found = known.iter().enumerate();
        let found = found.filter(|(_, (column, _))| is_asked(column));
        let before = curves.len();
        curves.extend(found.map(|(place, (name, unit))| Curve {
            name: name.clone(),
            unit: (*unit).to_string(),
            numbers: rows.iter().map(|row| row[place]).collect(),
        }));
        if curves.len() == before {
            return Err(UnknownColumn {
                name: (*asked).to_string(),
                known: S::NAMES.to_string().replace(',', ", "),
            });
        }
    }
    Ok(curves)
}

/// The numbers of a value, column by column.
fn numbers(value: &impl Columns<f64>) -> Vec<f64> {
    struct List(Vec<f64>);

    impl Sink<f64> for List {
        fn put(&mut self, number: f64) {
            self.0.push(number);
        }
    }

    let mut list = List(Vec::new());
    value.write(&mut list);
    list.0
}

/// The names of some curves without their common beginning, and that beginning.
pub(super) fn short_names(curves: &[&Curve]) -> (String, Vec<String>) {
    let [first, rest @ ..] = curves else {
        return (String::new(), Vec::new());
    };
    if rest.is_empty() {
        return (first.name.clone(), std::vec![String::new()]);
    }
    let mut ends = first.name.match_indices('.').map(|(end, _)| end);
    let is_common = |end: &usize| {
        let mut others = rest.iter();
        others.all(|curve| curve.name.get(..=*end) == first.name.get(..=*end))
    };
    let common = ends.rfind(is_common);
    let cut = common.map_or(0, |end| end + 1);
    let names = curves.iter().map(|curve| curve.name[cut..].to_string());
    let common = common.map_or("", |end| &first.name[..end]);
    (common.to_string(), names.collect())
}
