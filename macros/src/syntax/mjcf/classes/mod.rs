//! Elements with the attributes that their classes give them, and what classes make of actuators.

mod element;
mod law;

pub use element::{Classes, Element, TURNS, Tags, bare};
pub use law::Law;
