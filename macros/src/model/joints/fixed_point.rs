//! A body that turns about a point of it.

use super::joint::{Held, Joint, Orientation};

pub const FIXED_POINT: Joint = Joint {
    word: "fixed_point",
    is_planar: false,
    translates: false,
    orientation: Orientation::Quaternion,
    held: Held::Point,
    knows_position: true,
    state: "Rotation",
    acceleration: None,
    missing: Some("the force balance: the reaction of the support has no moment about it"),
};
