//! Derivatives and gradients, as expressions.

mod derivative;
mod gradient;
mod norms;
