//! A body that moves and does not turn.

use super::joint::{Center, Joint, Orientation};

pub const TRANSLATION: Joint = Joint {
    word: "translation",
    is_planar: false,
    center: Center::Free,
    orientation: Orientation::Fixed,
    state: "Translation",
    acceleration: None,
    missing: Some("the moment balance: the body does not turn"),
};
