//! The joints to the ground, one file each.

mod fixed_axis;
mod fixed_point;
mod joint;
mod pivot;
mod planar;
mod planar_translation;
mod rod;
mod rotation;
mod shape;
mod spatial;
mod tangent;
mod translation;

pub use fixed_axis::FIXED_AXIS;
pub use fixed_point::FIXED_POINT;
pub use joint::{Joint, Orientation};
pub use pivot::PIVOT;
pub use planar::PLANAR;
pub use planar_translation::PLANAR_TRANSLATION;
pub use rod::ROD;
pub use rotation::ROTATION;
pub use shape::{
    BALL, CYLINDER, Coordinate, FREE, Field, HINGE, OWN, PLANE, Rates, SHIFT, SHIFT_IN_THE_PLANE,
    SLIDE, Shape, UNIVERSAL,
};
pub use spatial::SPATIAL;
pub use tangent::Group;
pub use translation::TRANSLATION;

/// A kind of motion: the joint of a body to the ground.
pub type Motion = &'static Joint;

/// All kinds of motion, in the order in which messages list them.
pub const MOTIONS: [Motion; 9] = [
    &PLANAR,
    &PLANAR_TRANSLATION,
    &SPATIAL,
    &TRANSLATION,
    &ROTATION,
    &PIVOT,
    &FIXED_POINT,
    &FIXED_AXIS,
    &ROD,
];
