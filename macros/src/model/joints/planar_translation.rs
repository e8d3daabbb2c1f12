//! A body that moves in the plane and does not turn.

use super::joint::{Held, Joint, Orientation};

pub const PLANAR_TRANSLATION: Joint = Joint {
    word: "planar_translation",
    is_planar: true,
    translates: true,
    orientation: Orientation::Fixed,
    held: Held::Nothing,
    knows_position: true,
    state: "PlanarTranslation",
    acceleration: None,
    missing: Some("the moment balance: the body does not turn"),
};
