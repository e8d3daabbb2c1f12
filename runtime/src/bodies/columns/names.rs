//! The names and units of columns.

use core::fmt;

/// A type whose columns have names.
pub trait Named {
    /// The names of its columns, in their order.
    const NAMES: Names;
}

/// The names of the columns of a type, with their units. The name of a part precedes the names of
/// its components, separated by a dot.
///
/// ```
/// use newton_euler::{columns::Named, prelude::*};
///
/// let names = "position.x,position.y,angle,velocity.x,velocity.y,angular_velocity";
/// assert_eq!(Planar::NAMES.to_string(), names);
/// assert_eq!(Planar::NAMES.count(), 6);
/// ```
#[derive(Clone, Copy, Debug)]
pub enum Names {
    /// A number, with its unit.
    Number(&'static str),
    /// A vector: the names of its components, and their unit.
    Vector(&'static [&'static str], &'static str),
    /// Named parts. The components of a part without a name are listed among the parts.
    Parts(&'static [(&'static str, Names)]),
}

/// One column.
#[derive(Clone, Copy, Debug)]
pub struct Column<'n> {
    /// The names of the part, from the outermost.
    path: Path<'n>,
    /// Its unit, empty if it has none.
    pub unit: &'static str,
}

/// Its name, with the names of the parts that contain it, separated by dots.
impl fmt::Display for Column<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.path.fmt(f)
    }
}

/// A name within others.
#[derive(Clone, Copy, Debug)]
struct Path<'n> {
    around: Option<&'n Path<'n>>,
    name: &'n str,
}

impl fmt::Display for Path<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(around) = self.around {
            around.fmt(f)?;
            if !around.is_empty() && !self.name.is_empty() {
                f.write_str(".")?;
            }
        }
        f.write_str(self.name)
    }
}

impl Path<'_> {
    fn is_empty(&self) -> bool {
        self.name.is_empty() && self.around.is_none_or(Path::is_empty)
    }
}

impl Names {
    /// The number of columns.
    #[must_use]
    pub const fn count(self) -> usize {
        match self {
            Self::Number(_) => 1,
            Self::Vector(components, _) => components.len(),
            Self::Parts(mut parts) => {
                let mut count = 0;
                while let [(_, first), rest @ ..] = parts {
                    count += first.count();
                    parts = rest;
                }
                count
            }
        }
    }

    /// The same names with another unit; names of parts stay as they are.
    #[must_use]
    pub const fn in_unit(self, unit: &'static str) -> Self {
        match self {
            Self::Number(_) => Self::Number(unit),
            Self::Vector(components, _) => Self::Vector(components, unit),
            Self::Parts(parts) => Self::Parts(parts),
        }
    }

    /// Visits each column, in order.
    ///
    /// # Errors
    /// The first error of a visit.
    pub fn each<E>(self, visit: &mut impl FnMut(Column<'_>) -> Result<(), E>) -> Result<(), E> {
        let path = Path {
            around: None,
            name: "",
        };
        self.each_within(path, visit)
    }

    fn each_within<E>(
        self,
        path: Path<'_>,
        visit: &mut impl FnMut(Column<'_>) -> Result<(), E>,
    ) -> Result<(), E> {
        let inside = |name| Path {
            around: Some(&path),
            name,
        };
        match self {
            Self::Number(unit) => visit(Column { path, unit }),
            Self::Vector(components, unit) => components.iter().try_for_each(|name| {
                let path = inside(name);
                visit(Column { path, unit })
            }),
            Self::Parts(parts) => parts
                .iter()
                .try_for_each(|(name, part)| part.each_within(inside(bare(name)), visit)),
        }
    }
}

/// A name without the prefix `r#` of a raw identifier.
#[must_use]
pub const fn bare(name: &str) -> &str {
    match name.as_bytes() {
        [b'r', b'#', ..] => name.split_at(2).1,
        _ => name,
    }
}

/// All columns, separated by commas: the first line of a CSV file.
impl fmt::Display for Names {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut is_first = true;
        self.each(&mut |column| {
            if !core::mem::take(&mut is_first) {
                f.write_str(",")?;
            }
            write!(f, "{column}")
        })
    }
}
