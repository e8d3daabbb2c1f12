//! A body that turns about an axis through a point of it.

use super::joint::{Held, Joint, Orientation};

pub const FIXED_AXIS: Joint = Joint {
    word: "fixed_axis",
    is_planar: false,
    translates: false,
    orientation: Orientation::Angle,
    held: Held::Axis,
    knows_position: true,
    state: "Hinge",
    acceleration: None,
    missing: Some("all balances but one: the reactions have no moment about the axis"),
};
