//! The keys of a description, and the entries of its lists.

mod charges;
mod checks;
mod composition;
mod entry;
mod foreign;
mod parse;

pub use composition::{Composition, Part};
pub use entry::{parse_name, parse_value};
pub use foreign::{Constant, Function};
pub use parse::{
    check_length, key_meant, key_value, parse_description, parse_key, parse_keys, report_unknown,
};
