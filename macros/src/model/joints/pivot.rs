//! A body in the plane that turns about a point of it.

use super::joint::{Held, Joint, Orientation};

pub const PIVOT: Joint = Joint {
    word: "pivot",
    is_planar: true,
    translates: false,
    orientation: Orientation::Angle,
    held: Held::Axis,
    knows_position: true,
    state: "Hinge",
    acceleration: None,
    missing: Some("the force balance and out of the plane: the body turns about a point of it"),
};
