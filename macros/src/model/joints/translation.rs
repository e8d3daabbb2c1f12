//! A body that moves and does not rotate.

use super::joint::{Center, Joint, Orientation};
use super::shape::SHIFT;

pub const TRANSLATION: Joint = Joint {
    word: "translation",
    is_planar: false,
    center: Center::Free,
    orientation: Orientation::Fixed,
    shape: &SHIFT,
    missing: Some("the moment balance: the body does not turn"),
};
