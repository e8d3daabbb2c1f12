//! A body that moves in the plane and does not rotate.

use super::joint::{Center, Joint, Orientation};
use super::shape::SHIFT_IN_THE_PLANE;

pub const PLANAR_TRANSLATION: Joint = Joint {
    word: "planar_translation",
    is_planar: true,
    center: Center::Free,
    orientation: Orientation::Fixed,
    shape: &SHIFT_IN_THE_PLANE,
    missing: Some("the moment balance: the body does not turn"),
};
