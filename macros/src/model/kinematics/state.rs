//! The state of a body, in symbols, and its support.

use std::ops::Range;

use crate::model::joints::{Motion, Orientation};
use crate::model::words::{Frame, FrameWord, Meaning, Variable};
use crate::symbolic::{Components, Id, Stage};

use super::attitude::Attitude;
use super::point::Point;
use super::vector::Vector;
use super::workspace::Workspace;

/// The state of a body, in symbols. Quantities that a kind of motion does not have are zero.
#[derive(Clone, Copy)]
pub struct State {
    /// The frame of the body, which identifies it.
    pub body: Frame,
    /// The axes of its rotation: those of the body, or those of the world if no axes rotate with
    /// it.
    pub axes: Frame,
    pub time: Id,
    /// Position, velocity and acceleration of G.
    pub position: Vector,
    pub velocity: Vector,
    pub acceleration: Vector,
    /// Angular velocity and acceleration in `axes`; for a rod, `u x u'` and `u x u''`.
    pub angular_velocity: Components,
    pub angular_acceleration: Components,
    /// The angle of a body that rotates about one axis, and its rate.
    pub angle: Option<(Id, Id)>,
    /// The axis that a rod has instead of an attitude.
    pub axis: Option<Axis>,
    /// The support of the body, once it is read.
    pub support: Option<Support>,
    /// Whether a hinge carries it whose axis does not pass through G.
    pub swings: bool,
}

impl State {
    /// The position of a point. The difference of two points of the body does not depend on the
    /// place of the body, however far away it is (`docs/trust.md`, H9).
    pub fn place(&self, work: &mut Workspace, point: Point) -> Vector {
        match point {
            Point::Fixed(Frame::WORLD, position) => work.vector(Frame::WORLD, position),
            Point::Fixed(body, offset) => {
                let offset = work.fixed_in(body, offset);
                work.add(self.position, offset)
            }
            Point::Moving(offset) => work.add(self.position, offset),
        }
    }

    /// The velocity of a point of the body at this offset, minus that of G.
    pub fn swept(&self, work: &mut Workspace, offset: Components) -> Vector {
        if let (Attitude::Line { direction, .. }, Some(axis)) =
            (work.attitude(self.body), self.axis)
        {
            let along = work.graph.dot(direction, offset);
            let swept = work.graph.scale_vector(along, axis.rate);
            return work.vector(Frame::WORLD, swept);
        }
        let swept = work.graph.cross(self.angular_velocity, offset);
        work.vector(self.body, swept)
    }

    /// The angular velocity; for a rod u', which has the same length.
    pub fn turn_rate(&self) -> Components {
        self.axis.map_or(self.angular_velocity, |axis| axis.rate)
    }

    /// The point of the moment balance: the held point, or G.
    pub fn center(&self, work: &Workspace) -> Point {
        let held = self.support.map(|support| support.offset);
        held.map_or(self.mass_center(work), |offset| {
            Point::Fixed(self.body, offset)
        })
    }

    /// The center of mass G, as a point.
    pub fn mass_center(&self, work: &Workspace) -> Point {
        Point::Fixed(self.body, work.graph.zeros())
    }

    /// The frame that a word in a description means.
    pub fn frame(&self, word: FrameWord) -> Frame {
        match word {
            FrameWord::World => Frame::WORLD,
            FrameWord::Body => self.body,
        }
    }

    /// Holds a point of the body: G moves as the body rotates about it.
    pub fn hold(&mut self, work: &mut Workspace, support: Support) {
        if let (Some(direction), Attitude::Axis { angle, .. }) =
            (support.direction, work.attitude(self.body))
        {
            work.set_attitude(self.body, Attitude::Axis { angle, direction });
            let along = |rate: Components| rate[2];
            let rates = [
                along(self.angular_velocity),
                along(self.angular_acceleration),
            ];
            let [velocity, acceleration] =
                rates.map(|rate| work.graph.scale_vector(rate, direction));
            self.angular_velocity = velocity;
            self.angular_acceleration = acceleration;
        }
        let graph = &mut work.graph;
        let arm = match support.direction {
            Some(direction) => graph.cross(direction, support.offset),
            None => support.offset,
        };
        self.swings = self.angle.is_some() && !graph.is_zero_vector(&arm);
        let (w, rate) = (self.angular_velocity, self.angular_acceleration);
        // c = G - P: v = w x c, a = w' x c + w x (w x c)
        let center = graph.negate_vector(support.offset);
        let velocity = graph.cross(w, center);
        let (driven, centripetal) = (graph.cross(rate, center), graph.cross(w, velocity));
        let acceleration = graph.add_vectors(driven, centripetal);
        let held = work.vector(Frame::WORLD, support.anchor);
        let from_held = work.vector(self.body, center);
        self.position = work.add(held, from_held);
        self.velocity = work.vector(self.body, velocity);
        self.acceleration = work.vector(self.body, acceleration);
        self.support = Some(support);
    }
}

/// The axis of a rod, in world axes.
#[derive(Clone, Copy, Debug)]
pub struct Axis {
    /// The unit vector u.
    pub unit: Components,
    /// u', perpendicular to u.
    pub rate: Components,
}

/// A point of the body that is held in space.
#[derive(Clone, Copy, Debug)]
pub struct Support {
    /// Its offset from G, in body axes.
    pub offset: Components,
    /// The point in space, in world axes.
    pub anchor: Components,
    /// The axis of rotation: a unit vector with the same components in body and world axes. `None`
    /// if the body rotates about a point.
    pub direction: Option<Components>,
}

/// The frame of a body, the symbols of its state, and its attitude as a function of them.
/// [`State::hold`] adds a support; until then, the axis of a hinge is z. The axis of a rod is added
/// with its direction.
pub fn state_symbols(motion: Motion, work: &mut Workspace) -> State {
    let body = work.new_frame(Frame::WORLD);
    let linear = motion.linear_axes();
    let angular = match motion.orientation {
        Orientation::Angle => 2..3,
        Orientation::Quaternion => 0..3,
        Orientation::Fixed | Orientation::Line => 0..0,
    };
    let time = work.symbol(Stage::State, Meaning::Time);
    let angle = attitude_symbols(motion.orientation, body, work);
    let mut components = |axes: &Range<usize>, variable: Variable| {
        let meaning = |axis| Meaning::Of(body, variable, axis);
        work.symbols(Stage::State, axes.clone(), meaning)
    };
    let position = components(&linear, Variable::Position);
    let velocity = components(&linear, Variable::Velocity);
    let mut angular_velocity = components(&angular, Variable::AngularVelocity);
    let acceleration = components(&linear, Variable::LinearAcceleration);
    let angle = angle.map(|angle| (angle, angular_velocity[2]));
    let mut angular_acceleration = components(&angular, Variable::AngularAcceleration);
    let mut axis = None;
    if motion.is_line() {
        let unit = components(&(0..3), Variable::Axis);
        let rate = components(&(0..3), Variable::AxisRate);
        let acceleration = components(&(0..3), Variable::AxisAcceleration);
        axis = Some(Axis { unit, rate });
        angular_velocity = work.graph.cross(unit, rate);
        angular_acceleration = work.graph.cross(unit, acceleration);
    }
    State {
        body,
        axes: if motion.is_line() { Frame::WORLD } else { body },
        time,
        position: work.vector(Frame::WORLD, position),
        velocity: work.vector(Frame::WORLD, velocity),
        acceleration: work.vector(Frame::WORLD, acceleration),
        angular_velocity,
        angular_acceleration,
        angle,
        axis,
        support: None,
        swings: false,
    }
}

/// Gives a frame the attitude that its symbols describe. Returns the angle, if there is one.
fn attitude_symbols(orientation: Orientation, body: Frame, work: &mut Workspace) -> Option<Id> {
    let mut symbol = |variable: Variable, part: usize| {
        work.symbol(Stage::State, Meaning::Of(body, variable, part))
    };
    match orientation {
        Orientation::Angle => {
            let angle = symbol(Variable::Angle, 0);
            let direction = work.graph.unit_vectors()[2];
            work.set_attitude(body, Attitude::Axis { angle, direction });
            Some(angle)
        }
        Orientation::Quaternion => {
            let scalar = symbol(Variable::Quaternion, 0);
            let vector = [1, 2, 3].map(|part| symbol(Variable::Quaternion, part));
            work.set_attitude(body, Attitude::Quaternion { scalar, vector });
            None
        }
        Orientation::Fixed | Orientation::Line => None,
    }
}
