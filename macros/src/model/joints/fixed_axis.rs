//! A body that rotates about an axis through one of its points.

use super::joint::{Center, Joint, Orientation};
use super::shape::HINGE;

pub const FIXED_AXIS: Joint = Joint {
    word: "fixed_axis",
    is_planar: false,
    center: Center::Held,
    orientation: Orientation::Angle,
    shape: &HINGE,
    missing: Some("all balances but one: the reactions have no moment about the axis"),
};
