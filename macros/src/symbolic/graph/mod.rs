//! The graph: nodes, the constructors that simplify them, vectors, costs, and the order of a
//! program.

mod build;
mod cost;
mod difference;
mod hash;
mod nodes;
mod pending;
mod positive;
mod product;
mod program;
mod spectra;
mod sum;
mod values;
mod vector;

pub use cost::Cost;
pub use hash::ShortMap;
pub use nodes::{Comparison, Components, Graph, Id, Node, Stage, Symbol};
pub use program::Program;
