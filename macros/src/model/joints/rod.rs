//! A thin straight body, whose attitude is only its axis.

use super::joint::{Center, Joint, Orientation};
use super::shape::LINE;

pub const ROD: Joint = Joint {
    word: "rod",
    is_planar: false,
    center: Center::Free,
    orientation: Orientation::Line,
    shape: &LINE,
    missing: Some("the moment balance about the axis: a rod has no inertia about it"),
};
