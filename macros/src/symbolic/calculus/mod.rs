//! Derivatives and gradients, as expressions.

mod derivative;
mod gradient;
mod jumps;
mod magnitudes;
mod norms;
