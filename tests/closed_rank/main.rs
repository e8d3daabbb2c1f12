//! Linkages whose rows depend on each other in closed states alone.
#![allow(missing_docs)]

mod cranks;
mod space;
