//! Where each part of a state is among its coordinates.

use std::ops::Range;

use mounted::model::{Meaning, Variable};

use crate::description::body::{Body, Motion};

/// Parts of a state, in the order of its coordinates.
#[derive(Clone, Debug, Default)]
pub struct Layout {
    pub position: Range<usize>,
    /// Angle, quaternion with its scalar last, or the axis of a rod.
    pub attitude: Range<usize>,
    pub velocity: Range<usize>,
    /// Or the rate of the axis.
    pub turning: Range<usize>,
}

impl Layout {
    pub fn of(motion: &Motion) -> Self {
        let [position, attitude, velocity, turning] = match motion {
            Motion::Spatial => [3, 4, 3, 3],
            Motion::Rotation | Motion::FixedPoint(_) => [0, 4, 0, 3],
            Motion::Translation => [3, 0, 3, 0],
            Motion::Planar => [2, 1, 2, 1],
            Motion::PlanarTranslation => [2, 0, 2, 0],
            Motion::Pivot(_) | Motion::FixedAxis(..) => [0, 1, 0, 1],
            Motion::Rod(_) => [3, 3, 3, 3],
        };
        let mut next = 0;
        let mut part = |count: usize| {
            next += count;
            next - count..next
        };
        Self {
            position: part(position),
            attitude: part(attitude),
            velocity: part(velocity),
            turning: part(turning),
        }
    }

    pub fn len(&self) -> usize {
        self.turning.end
    }

    /// The coordinate that a symbol stands for.
    pub fn place(&self, meaning: Meaning) -> Option<usize> {
        let Meaning::Of(_, variable, i) = meaning else {
            return None;
        };
        Some(match variable {
            Variable::Position => self.position.start + i,
            Variable::Velocity => self.velocity.start + i,
            Variable::Angle => self.attitude.start,
            Variable::Quaternion => self.attitude.start + (i + 3) % 4,
            Variable::Axis => self.attitude.start + i,
            // about the one axis that there is
            Variable::AngularVelocity if self.turning.len() == 1 && i == 2 => self.turning.start,
            Variable::AngularVelocity | Variable::AxisRate => self.turning.start + i,
            _ => return None,
        })
    }
}

/// Whether the motion of G has coordinates.
pub fn translates(body: &Body) -> bool {
    !Layout::of(&body.motion).position.is_empty()
}

/// Whether the attitude is an angle about an axis that is held.
pub fn is_hinged(body: &Body) -> bool {
    matches!(body.motion, Motion::Pivot(_) | Motion::FixedAxis(..))
}

pub fn is_rod(body: &Body) -> bool {
    matches!(body.motion, Motion::Rod(_))
}
