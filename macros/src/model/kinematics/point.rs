//! Points, fixed in a body, in space, or moving.

use crate::model::words::Frame;
use crate::symbolic::Components;

use super::vector::Vector;

/// A point, in metres.
#[derive(Clone, Copy, Debug)]
pub enum Point {
    /// Fixed in a frame: where it is from its origin, which of a body is G.
    Fixed(Frame, Components),
    /// Where it is from G changes: the matter of the body that is there, such as that in contact.
    Moving(Vector),
}

impl Point {
    /// Where it is from G, if it is fixed in this body.
    pub fn offset(self, body: Frame) -> Option<Components> {
        match self {
            Self::Fixed(frame, offset) if frame == body => Some(offset),
            Self::Fixed(..) | Self::Moving(_) => None,
        }
    }

    /// Why this is no point of the body, for messages.
    pub fn where_else(self) -> &'static str {
        match self {
            Self::Fixed(Frame::WORLD, _) => "fixed in space",
            Self::Fixed(..) | Self::Moving(_) => "not fixed in it",
        }
    }
}
