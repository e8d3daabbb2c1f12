//! A body that turns about G; the motion of G is not looked at.

use super::joint::{Held, Joint, Orientation};

pub const ROTATION: Joint = Joint {
    word: "rotation",
    is_planar: false,
    translates: false,
    orientation: Orientation::Quaternion,
    held: Held::Nothing,
    knows_position: false,
    state: "Rotation",
    acceleration: None,
    missing: Some("the force balance: the motion of G is not modelled"),
};
