//! Motion under constraints, without their loads.
//!
//! ```text
//! M x = f + A^T l        A x = r
//! ```
//!
//! Rows in one coordinate more than their number leave one direction n of motion, `A n = 0`. Its
//! components are the minors of the rows, which vanish together only where the rows are dependent.
//! The balances along it have the inertia `n . M n`, and
//!
//! ```text
//! x = p + t n        A p = r,  n . M p = 0        (n . M n) t = n . f
//! ```
//!
//! holds in all states in which the rows are independent: no coordinate is chosen, so there is no
//! division by one that stands still. In all other balances and rows t replaces the coordinates, so
//! that loop after loop is resolved. Rows in as many coordinates as their number determine these.
//! The remaining ones are eliminated.

mod balances;
mod block;
mod loads;
mod motion;
mod together;

pub use balances::{Balance, LinearRow};
pub use loads::loads;
pub use motion::{Reduced, reduce};
pub use together::{LoadedRow, together};
