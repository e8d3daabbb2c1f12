//! What stands in the lists of a description, entry by entry.

mod charges;
mod checks;
mod composition;
mod entry;
mod foreign;

pub use checks::parse_check;
pub use composition::{Composition, Part};
pub use entry::{parse_entry, parse_name, parse_value};
pub use foreign::{Constant, Function};
