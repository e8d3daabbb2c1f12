//! What rustdoc shows of the equations: the balances as laws, and the statements behind them.
//! In an editor's hover the laws are plain text.

mod laws;
mod markup;
mod statements;

pub use laws::{laws_in_text, laws_on_page};
pub use statements::statements_on_page;
