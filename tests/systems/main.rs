//! Systems of bodies: published numbers, a second derivation, and laws.
#![allow(missing_docs)]

mod along_axes;
mod armatures;
mod axes_of_params;
mod balanced;
mod balances;
mod compare;
mod constrained;
mod corners;
mod counts;
mod described;
mod directions;
mod drawings;
mod driven;
mod far;
mod floating;
mod frames;
mod hyperstatic;
mod kinds;
mod lagrange;
#[allow(dead_code, reason = "no screws here")]
#[path = "../lagrange_systems/mod.rs"]
mod lagrange_systems;
mod large;
mod laws;
mod linkages;
mod links;
mod loops;
mod matrices;
mod mechanisms;
mod open;
mod oracle;
mod params;
mod plane;
mod points;
mod potentials;
#[path = "../reference/mod.rs"]
mod reference;
mod references;
mod reversed;
mod rolling;
mod screws;
mod series;
mod shapes;
mod slots;
mod spatial;
mod squeezer;
mod statics;
mod still;
mod unequal;
