//! Potentials of systems and of their bodies.

mod cables;
mod charges;
mod every_kind;
mod plane;
mod space;
