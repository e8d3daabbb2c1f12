//! The items of a body: its structs, its constructor, its implementations and its documentation.

mod addition;
mod columns;
mod constructor;
mod docs;
mod foreign;
mod open;
mod possible;
mod record;
mod rigid_body;
mod structs;
mod symbols;

pub use addition::Addition;
pub use columns::emit_columns;
pub use constructor::{Constructor, Roots, stored_fields};
pub use docs::Documentation;
pub use foreign::emit_foreign;
pub use open::{open_drives, open_reactions, write_open};
pub use record::{Field, Record};
pub use rigid_body::{Best, Equated, emit_integrate, emit_rigid_body, write_acceleration};
pub use structs::{emit_items, emit_unused, with_private_fields};
