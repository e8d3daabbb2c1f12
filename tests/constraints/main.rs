//! Constraints, their reactions, and inverse dynamics.

mod beside_a_pin;
mod inverse;
mod inverse_constrained;
mod inverse_turning;
mod jumps;
mod kept;
#[path = "../oracle/mod.rs"]
mod oracle;
mod plane;
mod rates;
#[path = "../reference/mod.rs"]
mod reference;
mod smooth;
mod spatial;
mod supported;
mod turntable;
