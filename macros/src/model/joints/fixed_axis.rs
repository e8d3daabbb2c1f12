//! A body that turns about an axis through a point of it.

use super::joint::{Center, Joint, Orientation};

pub const FIXED_AXIS: Joint = Joint {
    word: "fixed_axis",
    is_planar: false,
    center: Center::Held,
    orientation: Orientation::Angle,
    state: "Hinge",
    acceleration: None,
    missing: Some("all balances but one: the reactions have no moment about the axis"),
};
