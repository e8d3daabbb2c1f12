//! Parameters, inputs, points and locals, in order of dependency.

mod changing;
mod checks;
mod foreign;
mod in_order;
mod names;
mod order;
mod outline;
mod parameters;
mod states;
mod support;

pub use changing::check_changing;
pub use names::{check_distinct, check_names, unused};
pub use order::{Definition, check_circles, definition_order, split_at_points};
pub use outline::{FLOW, INVERSE, LINEARIZATION, Offer, REGRESSOR, outline_under};
