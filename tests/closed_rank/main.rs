//! Linkages whose rows depend on each other in closed states alone.
#![allow(missing_docs)]

mod change_points;
mod cranks;
mod space;
