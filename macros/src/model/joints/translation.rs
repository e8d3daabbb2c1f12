//! A body that moves and does not turn.

use super::joint::{Held, Joint, Orientation};

pub const TRANSLATION: Joint = Joint {
    word: "translation",
    is_planar: false,
    translates: true,
    orientation: Orientation::Fixed,
    held: Held::Nothing,
    knows_position: true,
    state: "Translation",
    acceleration: None,
    missing: Some("the moment balance: the body does not turn"),
};
