//! A body that moves in the plane.

use super::joint::{Center, Joint, Orientation};
use super::shape::PLANE;

pub const PLANAR: Joint = Joint {
    word: "planar",
    is_planar: true,
    center: Center::Free,
    orientation: Orientation::Angle,
    shape: &PLANE,
    missing: Some("three equations out of the plane: the motion is planar"),
};
