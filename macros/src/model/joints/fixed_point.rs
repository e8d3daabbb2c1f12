//! A body that rotates about one of its points.

use super::joint::{Center, Joint, Orientation};
use super::shape::BALL;

pub const FIXED_POINT: Joint = Joint {
    word: "fixed_point",
    is_planar: false,
    center: Center::Held,
    orientation: Orientation::Quaternion,
    shape: &BALL,
    missing: Some("the force balance: the reaction of the support has no moment about it"),
};
