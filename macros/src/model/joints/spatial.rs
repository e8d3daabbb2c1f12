//! A body that moves freely.

use super::joint::{Center, Joint, Orientation};

pub const SPATIAL: Joint = Joint {
    word: "spatial",
    is_planar: false,
    center: Center::Free,
    orientation: Orientation::Quaternion,
    state: "Spatial",
    acceleration: Some("SpatialAcceleration"),
    missing: None,
};
