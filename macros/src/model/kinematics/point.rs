//! Points, fixed in the body, in space, or moving.

use crate::model::words::Frame;
use crate::symbolic::Components;

use super::vector::Vector;

/// A point, in metres.
#[derive(Clone, Copy, Debug)]
pub enum Point {
    /// Fixed in the body: its offset from G in body axes.
    Body(Components),
    /// Fixed in space: its position in world axes.
    World(Components),
    /// Where it is from G changes: the matter of the body that is there, such as that in contact.
    Moving(Vector),
}

impl Point {
    /// Fixed in a frame.
    pub fn in_frame(frame: Frame, components: Components) -> Self {
        if frame == Frame::WORLD {
            Self::World(components)
        } else {
            Self::Body(components)
        }
    }

    /// Why this is no point of the body, for messages.
    pub fn where_else(self) -> &'static str {
        match self {
            Self::World(_) => "fixed in space",
            Self::Body(_) | Self::Moving(_) => "not fixed in it",
        }
    }
}
