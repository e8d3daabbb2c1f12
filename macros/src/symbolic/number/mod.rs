//! Exact numbers, irrational numbers, residues modulo a prime, and eigenvalues.

mod angle;
mod arithmetic;
mod ball;
mod eigen;
mod exact;
mod float;
mod foreign;
mod function;
pub mod irrational;
mod rational_residues;
mod residue;
mod table;
mod values;

pub use eigen::{Matrix, PrincipalAxes, Spectrum, Symmetry, scaled};
pub use exact::Number;
pub use foreign::Foreign;
pub use function::{Function, ORDERS};
pub use residue::Residue;
pub use table::{Piece, Table};
