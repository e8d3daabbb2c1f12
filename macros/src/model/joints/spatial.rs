//! A body that moves freely.

use super::joint::{Held, Joint, Orientation};

pub const SPATIAL: Joint = Joint {
    word: "spatial",
    is_planar: false,
    translates: true,
    orientation: Orientation::Quaternion,
    held: Held::Nothing,
    knows_position: true,
    state: "Spatial",
    acceleration: Some("SpatialAcceleration"),
    missing: None,
};
