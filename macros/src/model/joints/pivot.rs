//! A planar body that rotates about one of its points.

use super::joint::{Center, Joint, Orientation};
use super::shape::HINGE;

pub const PIVOT: Joint = Joint {
    word: "pivot",
    is_planar: true,
    center: Center::Held,
    orientation: Orientation::Angle,
    shape: &HINGE,
    missing: Some("the force balance and out of the plane: the body turns about a point of it"),
};
