//! Expressions: a hash-consed graph with simplifying constructors over exact numbers.
//!
//! This room knows no mechanics and no words: symbols are numbers, and what they stand for is the
//! business of the model. It adds to `std` and dashu: exact folding, three stages of evaluation,
//! vectors, derivatives, linear equations, eigenvalues, a schedule, a cost and an interpreter, and the
//! proof that an expression is zero.

mod algebra;
mod ball;
mod branches;
mod build;
mod convolution;
mod cost;
mod degree;
mod derivative;
mod difference;
mod eigen;
mod eliminate;
mod evaluate;
mod expansion;
mod function;
mod gradient;
mod graph;
mod hash;
mod identity;
mod irrational;
mod number;
mod product;
mod program;
mod recurrence;
mod residue;
mod slopes;
mod solve;
mod substitute;
mod sum;
mod tape;
mod values;
mod vector;
mod zeros;

pub use algebra::Algebra;
pub use branches::on_branches;
pub use convolution::{LANES, Origin, Sum, Term};
pub use cost::Cost;
pub use eigen::{PrincipalAxes, Spectrum, Symmetry, scaled};
pub use eliminate::{Elimination, Row, Size};
pub use function::Function;
pub use graph::{Comparison, Graph, Id, Node, Stage, Symbol};
pub use identity::Residues;
pub use number::Number;
pub use program::Program;
pub use recurrence::{Coordinate, Recurrences};
pub use residue::Residue;
pub use solve::{Equation, Solution};
pub use tape::Tape;
pub use vector::Components;
pub use zeros::{Sample, free};
