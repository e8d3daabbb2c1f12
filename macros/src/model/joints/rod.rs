//! A thin straight body, of whose attitude there is the axis alone.

use super::joint::{Center, Joint, Orientation};

pub const ROD: Joint = Joint {
    word: "rod",
    is_planar: false,
    center: Center::Free,
    orientation: Orientation::Line,
    state: "Rod",
    acceleration: Some("RodAcceleration"),
    missing: Some("the moment balance about the axis: a rod has no inertia about it"),
};
