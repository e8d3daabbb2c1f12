//! Straight-line code: expressions of the graph as Rust statements, in methods of a body.

mod block;
mod expression;
mod lints;
mod method;
mod naming;
mod places;
mod reads;
mod scalar;
mod shapes;
mod site;
mod statements;
mod text;
mod writer;

pub use block::Block;
pub use lints::allow_constants;
pub use method::Method;
pub use naming::{Names, PRINCIPAL_AXES, given, local, local_name};
pub use places::{joint_symbols, motion_symbols};
pub use scalar::{Scalar, number_literal, private};
pub use shapes::{Shapes, Values};
pub use site::Site;
pub use statements::Facts;
pub use text::code_text;
pub use writer::{COMMON, Fields, Source, Told, Writer};
