//! Values as text.

use core::fmt;

use super::column::{Columns, Sink};
use super::names::{Named, Names, bare};
use crate::numbers::scalar::Scalar;

/// Writes a value with the names of its parts and their units.
///
/// # Errors
/// The errors of the formatter.
pub fn show<T: Scalar>(
    value: &(impl Columns<T> + Named),
    f: &mut fmt::Formatter<'_>,
) -> fmt::Result {
    show_part(names_of(value), &mut 0, value, f)
}

fn names_of<N: Named>(_: &N) -> Names {
    N::NAMES
}

/// Writes the part that begins at a column index, and advances the index past the part.
fn show_part<T: Scalar>(
    names: Names,
    index: &mut usize,
    value: &impl Columns<T>,
    f: &mut fmt::Formatter<'_>,
) -> fmt::Result {
    let with_unit = |f: &mut fmt::Formatter<'_>, unit: &str| match unit {
        "" => Ok(()),
        unit => write!(f, " {unit}"),
    };
    match names {
        Names::Number(unit) => {
            show_number(index, value, f)?;
            with_unit(f, unit)
        }
        Names::Vector(components, unit) => {
            // x, y, z is the only order of a vector; quaternions have two
            if components.len() > 3 {
                for (place, name) in components.iter().enumerate() {
                    let before = if place == 0 { "(" } else { ", " };
                    write!(f, "{before}{name}")?;
                }
                f.write_str(") = ")?;
            }
            for place in 0..components.len() {
                f.write_str(if place == 0 { "(" } else { ", " })?;
                show_number(index, value, f)?;
            }
            f.write_str(")")?;
            with_unit(f, unit)
        }
        Names::Parts(parts) => {
            let is_nested = parts
                .iter()
                .any(|(_, part)| matches!(part, Names::Parts(_)));
            for (place, (name, part)) in parts.iter().enumerate() {
                f.write_str(match (place, is_nested) {
                    (0, _) => "",
                    (_, true) => "; ",
                    (_, false) => ", ",
                })?;
                let separator = match part {
                    Names::Parts(_) => ": ",
                    _ => " ",
                };
                write!(f, "{}{separator}", bare(name))?;
                show_part(*part, index, value, f)?;
            }
            Ok(())
        }
    }
}

/// Writes the number at an index, all its lanes, and advances the index.
fn show_number<T: Scalar>(
    index: &mut usize,
    value: &impl Columns<T>,
    f: &mut fmt::Formatter<'_>,
) -> fmt::Result {
    let mut place = Place {
        left: *index,
        found: None,
    };
    value.write(&mut place);
    *index += 1;
    let Some(number) = place.found else {
        return Ok(());
    };
    (0..T::LANES).try_for_each(|lane| {
        if lane > 0 {
            f.write_str(" | ")?;
        }
        fmt::Display::fmt(&number.lane(lane), f)
    })
}

/// One of the numbers that are put.
struct Place<T> {
    left: usize,
    found: Option<T>,
}

impl<T> Sink<T> for Place<T> {
    fn put(&mut self, scalar: T) {
        match self.left.checked_sub(1) {
            Some(left) => self.left = left,
            None if self.found.is_none() => self.found = Some(scalar),
            None => {}
        }
    }
}
