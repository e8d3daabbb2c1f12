//! Expressions: a hash-consed graph with simplifying constructors over exact numbers.
//!
//! This room knows no mechanics and no words: symbols are numbers, and their meanings belong to the
//! model. On top of `std` and dashu it provides exact folding, three stages of evaluation, vectors,
//! derivatives, linear equations, eigenvalues, a schedule, a cost and an interpreter, and the proof
//! that an expression is zero.

mod algebra;
mod calculus;
mod graph;
mod linear;
mod number;
mod series;
mod zeros;

pub use algebra::{Algebra, Exact, Tape};
pub use graph::{Comparison, Components, Cost, Graph, Id, Node, Program, ShortMap, Stage, Symbol};
pub use linear::{Elimination, Equation, Size, Span, Undetermined};
pub use number::{
    Foreign, Function, Number, PrincipalAxes, Residue, Spectrum, Symmetry, Table, scaled,
};
pub use series::{Coordinate, LANES, Origin, Polynomial, Recurrences, Sum, Term};
pub use zeros::{Residues, Sample, free, until_decided};
