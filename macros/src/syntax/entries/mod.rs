//! The keys of a description, and the entries of its lists.

mod charges;
mod checks;
mod composition;
mod declaration;
mod definition;
mod entry;
mod foreign;
mod keys;
mod parse;

pub use composition::{Composition, Part};
pub use definition::parse_value;
pub use entry::parse_name;
pub use foreign::{Constant, Function};
pub use keys::{bracketed_entry, holds_keys, key_meant, report_unknown};
pub use parse::{check_length, key_value, parse_description, parse_key, parse_keys};
