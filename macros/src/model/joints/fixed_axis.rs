//! A body that turns about an axis through a point of it.

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
