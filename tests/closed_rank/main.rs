//! Linkages whose rows depend on each other only in closed states.
#![allow(missing_docs)]

mod beside;
mod carried;
mod change_points;
mod cranks;
mod doors;
mod factors;
mod pins;
mod projection;
mod space;
