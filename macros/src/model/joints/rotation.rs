//! A body that turns about G; the motion of G is not looked at.

use super::joint::{Center, Joint, Orientation};

pub const ROTATION: Joint = Joint {
    word: "rotation",
    is_planar: false,
    center: Center::Unmodelled,
    orientation: Orientation::Quaternion,
    state: "Rotation",
    acceleration: None,
    missing: Some("the force balance: the motion of G is not modelled"),
};
