//! Values as lines of comma-separated numbers.

use core::cell::RefCell;
use core::fmt;
use core::iter::Cloned;
use core::slice;
#[cfg(feature = "std")]
use std::{
    fs::File,
    io::{self, BufWriter, Write as _},
    path::Path,
};

use super::column::{Columns, Sink};
use super::names::Named;

/// A table of comma-separated values: a line with the names of the columns, then one line per
/// value.
///
/// `Display` gives it as text, and `write` (feature `std`) writes it to a file. Each number has the
/// fewest digits that read back to the same bits. Infinite numbers and NaN are `inf`, `-inf` and
/// `NaN`.
///
/// ```
/// use newton_euler::{columns::Csv, prelude::*};
///
/// let states = [Hinge { angle: 0.1, angular_velocity: 2.0 }, Hinge::default()];
/// assert_eq!(Csv::of(&states).to_string(), "angle,angular_velocity\n0.1,2\n0,0\n");
/// ```
///
/// Samples begin with their time. [`Self::rows`] writes them as they are computed, so a long
/// motion need not be collected:
///
/// ```
/// use newton_euler::{columns::Csv, prelude::*};
///
/// rigid_body!(Stone {
///     motion: planar_translation,
///     mass: 1[kg],
///     fields: [weight = mass * world(0, -10[m / s ^ 2])],
/// });
///
/// let thrown = PlanarTranslation { velocity: [1.0, 2.0].into(), ..PlanarTranslation::default() };
/// let stone = Stone::default();
/// let samples = stone.integrate(&thrown).samples(0.5, 0.25);
/// let table = Csv::rows(samples.map_while(Result::ok)).to_string();
/// assert!(table.starts_with("time,position.x,position.y,velocity.x,velocity.y\n0,0,0,1,2\n0.25,"));
/// ```
pub struct Csv<I> {
    rows: RefCell<I>,
    /// The name of a column of numbers, from zero.
    number: Option<&'static str>,
}

impl<I> fmt::Debug for Csv<I> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Csv").finish_non_exhaustive()
    }
}

impl<'v, C: Columns<f64> + Named> Csv<Cloned<slice::Iter<'v, C>>> {
    /// The table of a list of values.
    #[must_use]
    pub fn of(values: &'v [C]) -> Self {
        Self::rows(values.iter().cloned())
    }
}

impl<I: Iterator<Item: Columns<f64> + Named>> Csv<I> {
    /// The table of values that are computed while it is written. It can be written only once,
    /// because the values are then used up.
    pub fn rows(rows: impl IntoIterator<IntoIter = I>) -> Self {
        Self {
            rows: RefCell::new(rows.into_iter()),
            number: None,
        }
    }

    /// The same, with an additional first column of this name that numbers the rows from zero.
    ///
    /// ```
    /// use newton_euler::{columns::Csv, prelude::*};
    ///
    /// let states = [Slide { position: 0.5, velocity: -1e-9 }];
    /// let table = Csv::of(&states).numbered("member").to_string();
    /// assert_eq!(table, "member,position,velocity\n0,0.5,-1e-9\n");
    /// ```
    #[must_use]
    pub fn numbered(self, name: &'static str) -> Self {
        Self {
            number: Some(name),
            ..self
        }
    }
}

#[cfg(feature = "std")]
impl<I: Iterator<Item: Columns<f64> + Named>> Csv<I> {
    /// Writes it to a file, row by row.
    ///
    /// # Errors
    /// The file cannot be written.
    pub fn write(&self, path: impl AsRef<Path>) -> io::Result<()> {
        let mut file = BufWriter::new(File::create(path)?);
        write!(file, "{self}")?;
        file.flush()
    }
}

impl<I: Iterator<Item: Columns<f64> + Named>> fmt::Display for Csv<I> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(name) = self.number {
            write_field(f, name)?;
            f.write_str(",")?;
        }
        writeln!(f, "{}", I::Item::NAMES)?;
        let mut rows = self.rows.try_borrow_mut().map_err(|_| fmt::Error)?;
        for (number, row) in rows.by_ref().enumerate() {
            if self.number.is_some() {
                write!(f, "{number},")?;
            }
            let mut line = Line {
                separator: "",
                written: Ok(()),
                f,
            };
            row.write(&mut line);
            line.written?;
            f.write_str("\n")?;
        }
        Ok(())
    }
}

/// Writes a field, in quotes if it contains a separator (RFC 4180).
fn write_field(f: &mut fmt::Formatter<'_>, field: &str) -> fmt::Result {
    if !field.contains([',', '"', '\r', '\n']) {
        return f.write_str(field);
    }
    f.write_str("\"")?;
    for (number, part) in field.split('"').enumerate() {
        f.write_str(if number == 0 { "" } else { "\"\"" })?;
        f.write_str(part)?;
    }
    f.write_str("\"")
}

/// A line that is being written.
struct Line<'l, 'f> {
    separator: &'static str,
    written: fmt::Result,
    f: &'l mut fmt::Formatter<'f>,
}

impl Sink<f64> for Line<'_, '_> {
    fn put(&mut self, number: f64) {
        let separator = core::mem::replace(&mut self.separator, ",");
        let is_plain = number == 0.0 || (1e-5..1e16).contains(&number.abs());
        self.written = self.written.and_then(|()| {
            self.f.write_str(separator)?;
            if is_plain || !number.is_finite() {
                write!(self.f, "{number}")
            } else {
                write!(self.f, "{number:e}")
            }
        });
    }
}
