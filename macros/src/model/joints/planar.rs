//! A body that moves in the plane.

use super::joint::{Held, Joint, Orientation};

pub const PLANAR: Joint = Joint {
    word: "planar",
    is_planar: true,
    translates: true,
    orientation: Orientation::Angle,
    held: Held::Nothing,
    knows_position: true,
    state: "Planar",
    acceleration: Some("PlanarAcceleration"),
    missing: Some("three equations out of the plane: the motion is planar"),
};
