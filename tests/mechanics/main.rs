//! The runtime without the macro: inertia, wrenches, attitudes, tops, fields, states as text.

mod attitude;
mod erratum;
mod field;
mod inertia;
mod inertia_shape;
mod integration_order;
mod reduction;
#[path = "../reference/mod.rs"]
mod reference;
mod rod;
mod serde;
mod singular;
mod tops;
mod wrench;
