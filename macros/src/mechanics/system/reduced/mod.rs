//! Motion under constraints, without their loads.
//!
//! ```text
//! M x = f + A^T l        A x = r
//! ```
//!
//! Rows that contain one coordinate more than their number leave one way n of moving, `A n = 0`.
//! Its components are their minors, which vanish together only where the rows are dependent. The
//! balances projected on it have the inertia `n . M n`, and
//!
//! ```text
//! x = p + t n        A p = r,  n . M p = 0        (n . M n) t = n . f
//! ```
//!
//! holds in all states in which the rows are independent: no coordinate is chosen as independent,
//! so nothing is divided by one that stands still. In all other balances and rows, t replaces these
//! coordinates, and loop after loop is solved. Rows with as many coordinates as their number
//! determine them. The rest is eliminated.

mod balances;
mod block;
mod loads;
mod motion;
mod together;

pub use balances::{Balance, Held};
pub use loads::loads;
pub use motion::{Reduced, reduce};
pub use together::{Kept, together};
