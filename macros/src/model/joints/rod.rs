//! A thin straight body, of whose attitude there is the axis alone.

use super::joint::{Held, Joint, Orientation};

pub const ROD: Joint = Joint {
    word: "rod",
    is_planar: false,
    translates: true,
    orientation: Orientation::Line,
    held: Held::Nothing,
    knows_position: true,
    state: "Rod",
    acceleration: Some("RodAcceleration"),
    missing: Some("the moment balance about the axis: a rod has no inertia about it"),
};
