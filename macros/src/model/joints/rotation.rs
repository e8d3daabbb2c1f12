//! A body that rotates about G; the motion of G is not modeled.

use super::joint::{Center, Joint, Orientation};
use super::shape::BALL;

pub const ROTATION: Joint = Joint {
    word: "rotation",
    is_planar: false,
    center: Center::Unmodeled,
    orientation: Orientation::Quaternion,
    shape: &BALL,
    missing: Some("the force balance: the motion of G is not modeled"),
};
