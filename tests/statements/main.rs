//! Published numbers, reproduced through the macro: the statements of the theory, solids, composed
//! bodies, charges, a quadrotor.

mod charges;
mod composed;
#[path = "../dual/mod.rs"]
mod dual;
mod free;
mod inertia;
mod loads;
#[path = "../oracle/mod.rs"]
mod oracle;
mod pendulum;
mod planar;
mod quadrotor;
#[path = "../reference/mod.rs"]
mod reference;
mod rotor;
mod solids;
mod spatial;
#[path = "../tensor/mod.rs"]
mod tensor;
mod top;
