//! Oracles that share no code with the macro: vector code, symmetries, conservation laws, a second
//! derivation, exact arithmetic.

mod conditions;
mod conservation;
mod conservation_supports;
mod covariance;
#[path = "../dual/mod.rs"]
mod dual;
mod lagrange_motions;
mod lagrange_planar;
#[path = "../oracle/mod.rs"]
mod oracle;
mod poles;
mod principal_axes;
mod regular;
mod vector_law;
mod vector_law_inertia;
mod vector_law_motions;
mod vector_law_supports;
