//! What an expression stands for.

use crate::symbolic::{Components, Id, Number};

use super::dimension::Dimension;
use super::frame::{Frame, Vector};

/// The value of an expression, with its dimension.
#[derive(Clone, Copy, Debug)]
pub enum Value {
    Scalar(Id, Dimension),
    Vector(Vector, Dimension),
    /// A vector of which components can be read: it says in which axes.
    Components(Frame, Components, Dimension),
    Condition(Id),
    Point(Point),
    /// The attitude of the body.
    Attitude,
}

impl Value {
    /// What kind of thing this is, for messages.
    pub fn kind(self) -> &'static str {
        match self {
            Self::Scalar(..) => "a scalar",
            Self::Vector(..) | Self::Components(..) => "a vector",
            Self::Condition(_) => "a condition",
            Self::Point(_) => "a point",
            Self::Attitude => "the attitude",
        }
    }
}

/// A number in a message.
pub fn shown(number: &Number) -> String {
    let value = number.to_f64();
    if value == 0.0 || (1e-4..1e7).contains(&value.abs()) {
        value.to_string()
    } else {
        format!("{value:e}")
    }
}

/// A point, in metres.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Point {
    /// Fixed in the body: its offset from G in body axes.
    Body(Components),
    /// Fixed in space: its position in world axes.
    World(Components),
    /// Where it is from G changes: the matter of the body that is there, such as that in contact.
    Moving(Vector),
}

impl Point {
    /// Why this is no point of the body, for messages.
    pub fn where_else(self) -> &'static str {
        match self {
            Self::World(_) => "fixed in space",
            Self::Body(_) | Self::Moving(_) => "not fixed in it",
        }
    }
}
