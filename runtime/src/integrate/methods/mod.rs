//! The integration methods.

pub mod adaptive;
pub mod by_tolerance;
pub mod closed_form;
pub mod commutator_free;
pub mod either;
pub mod fixed;
pub mod projected;
pub mod runge_kutta;
pub mod series;
