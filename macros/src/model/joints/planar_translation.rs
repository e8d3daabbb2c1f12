//! A body that moves in the plane and does not turn.

use super::joint::{Center, Joint, Orientation};

pub const PLANAR_TRANSLATION: Joint = Joint {
    word: "planar_translation",
    is_planar: true,
    center: Center::Free,
    orientation: Orientation::Fixed,
    state: "PlanarTranslation",
    acceleration: None,
    missing: Some("the moment balance: the body does not turn"),
};
