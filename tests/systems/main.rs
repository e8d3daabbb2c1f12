//! Systems of bodies: published numbers, another way to the same numbers, and laws.
#![allow(missing_docs)]

mod compare;
mod corners;
mod described;
mod large;
mod laws;
mod oracle;
mod plane;
#[path = "../reference/mod.rs"]
mod reference;
mod references;
mod shapes;
mod spatial;
