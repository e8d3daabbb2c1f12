//! Systems of bodies: published numbers, another way to the same numbers, and laws.
#![allow(missing_docs)]

mod balances;
mod compare;
mod corners;
mod counts;
mod described;
mod drawings;
mod kinds;
mod large;
mod laws;
mod oracle;
mod params;
mod plane;
mod potentials;
#[path = "../reference/mod.rs"]
mod reference;
mod references;
mod shapes;
mod spatial;
