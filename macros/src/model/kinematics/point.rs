//! Points: fixed in a body, fixed in space, or moving.

use crate::model::words::Frame;
use crate::symbolic::Components;

use super::vector::Vector;

/// A point, in meters.
#[derive(Clone, Copy, Debug)]
pub enum Point {
    /// Fixed in a frame: its offset from the origin, which is G for a body.
    Fixed(Frame, Components),
    /// Given by an offset from G that changes: the material point of the body at a place, such as a
    /// contact.
    Moving(Vector),
}

impl Point {
    /// Its offset from G, if it is fixed in this body.
    pub fn offset(self, body: Frame) -> Option<Components> {
        match self {
            Self::Fixed(frame, offset) if frame == body => Some(offset),
            Self::Fixed(..) | Self::Moving(_) => None,
        }
    }

    /// The reason why it is not a point of the body, for messages.
    pub fn where_else(self) -> &'static str {
        match self {
            Self::Fixed(Frame::WORLD, _) => "fixed in space",
            Self::Fixed(..) | Self::Moving(_) => "not fixed in it",
        }
    }
}
