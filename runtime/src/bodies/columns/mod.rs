//! Types that hold a fixed number of scalars, read and written as a sequence of scalars.
//!
//! An ensemble stores its members in columns. Reading one number from each column gives one body
//! with its state; reading several at once gives a body over lanes. `rigid_body!` implements these
//! traits for bodies that are generic over their scalar.

mod column;
mod csv;
mod kinds;
mod names;
mod shown;

pub use column::{Columnar, Columns, Generic, Sink, Source};
pub use csv::Csv;
pub use names::{Column, Named, Names};
#[doc(hidden)]
pub use {names::bare, shown::show};
