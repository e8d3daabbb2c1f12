//! Potentials of systems and of their bodies.

mod plane;
mod space;
