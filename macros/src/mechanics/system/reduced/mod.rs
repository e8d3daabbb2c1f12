//! Motion under constraints, without their loads.
//!
//! ```text
//! M x = f + A^T l        A x = r
//! ```
//!
//! Rows that have a part in one coordinate more than they are leave one way n of moving, `A n = 0`:
//! its components are their minors, and vanish together only where the rows are dependent. The
//! balances projected on it have the inertia `n . M n`, and
//!
//! ```text
//! x = p + t n        A p = r,  n . M p = 0        (n . M n) t = n . f
//! ```
//!
//! holds in all states in which the rows are independent: no coordinate is chosen, and none that
//! stands still is divided by. In all other balances and rows t stands for the coordinates, so that
//! loop after loop is resolved. Rows of as many coordinates give these. What is left over is
//! eliminated.

mod balances;
mod block;
mod loads;
mod motion;
mod together;

pub use balances::{Balance, LinearRow};
pub use loads::loads;
pub use motion::{Reduced, reduce};
pub use together::{LoadedRow, together};
