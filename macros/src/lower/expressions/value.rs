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
