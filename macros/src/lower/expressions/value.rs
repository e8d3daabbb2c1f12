//! What an expression stands for.

use crate::model::{Dimension, Frame, Point, Vector};
use crate::symbolic::{Components, Id};

/// The value of an expression, with its dimension.
#[derive(Clone, Copy, Debug)]
pub enum Value {
    Scalar(Id, Dimension),
    Vector(Vector, Dimension),
    /// A vector of which components can be read: it says in which axes.
    Components(Frame, Components, Dimension),
    Condition(Id),
    Point(Point),
    /// A point of a body of a system, by the number of the body: its offset from that one's G.
    Carried(usize, Vector),
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
            Self::Carried(..) => "a point of another body",
            Self::Attitude => "the attitude",
        }
    }
}
