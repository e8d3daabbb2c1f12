//! Several doubles in one register, of the width of the processor.
//!
//! Operations are those of `f64` in each lane, without fused ones. Sines and cosines are computed
//! in all lanes at once, other elementary functions lane by lane. Each lane gives the same bits as
//! `f64` alone.

mod arithmetic;
mod register;
mod scalar;
mod sines;
mod width;

pub use arithmetic::{Lanes, Mask};
pub use register::{Register, Work};
pub(crate) use register::{by_itself, in_function};
pub use width::Width;
