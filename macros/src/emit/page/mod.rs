//! What rustdoc shows of the equations: the balances as laws, and the statements that compute them.
//! In an editor's hover text, the laws are plain text.

mod laws;
mod markup;
mod statements;

pub use laws::{laws_in_text, laws_on_page};
pub use statements::statements_on_page;
