//! Expressions: names, operators, functions, vectors and points, with frames and dimensions
//! checked.

mod along_axis;
mod arithmetic;
mod built_in;
mod evaluate;
mod functions;
mod given;
mod gradient;
mod lowering;
mod members;
mod points;
mod scope;
mod unit;
mod vectors;
mod written;

pub use along_axis::UNTURNED;
pub use gradient::of_gradient;
pub use lowering::{Lowering, dimension};
pub use members::missing_member;
pub use scope::{
    BUILT_IN, BodyMotion, BodyNames, JointNames, Members, OF_ROD, Offset, Scope, Value,
};
pub use unit::{in_radians, lower_unit, written_unit};
pub use written::{
    base, difference, direction, has_placeholder, is_drive, is_of_solid, is_turning_drive,
    is_unknown, motion, placeholders, short, strip_unit, written_frame, written_motion,
};
