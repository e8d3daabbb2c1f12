//! Potentials of systems and of their bodies.

mod cables;
mod plane;
mod space;
