//! A body that moves freely.

use super::joint::{Center, Joint, Orientation};
use super::shape::FREE;

pub const SPATIAL: Joint = Joint {
    word: "spatial",
    is_planar: false,
    center: Center::Free,
    orientation: Orientation::Quaternion,
    shape: &FREE,
    missing: None,
};
