//! The motion under constraints, found without the loads of these.
//!
//! ```text
//! M x = f + A^T l        A x = r
//! ```
//!
//! Rows with one coordinate more than there are rows leave one direction n of motion, `A n = 0`.
//! Its components are the minors of the rows, which vanish together only where the rows are
//! dependent. The balances along n have the inertia `n . M n`, and
//!
//! ```text
//! x = p + t n        A p = r,  n . M p = 0        (n . M n) t = n . f
//! ```
//!
//! holds in all states in which the rows are independent. No coordinate is chosen, so nothing is
//! divided by the rate of a coordinate that stands still. In all other balances and rows, t
//! replaces the coordinates, so that one loop after another is solved. Rows with as many
//! coordinates as there are rows determine these coordinates. All remaining rows are eliminated.

mod balances;
mod block;
mod equations;
mod loads;
mod motion;

pub use balances::{Balance, LinearRow};
pub use equations::{LoadedRow, label, together};
pub use loads::loads;
pub use motion::{Reduced, reduce};
