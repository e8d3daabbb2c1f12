//! A body in a state: the values of the names in its description.

use std::cell::Cell;

use crate::description::body::{Input, Local, Motion, Param};
use crate::description::expression::{Axes, Place, Scalar, Vector as Written};
use crate::given::Given;
use crate::wide::Wide;

use super::arithmetic::Values;
use super::constants::{Constants, multiplied};
use super::inertia::{Components, turn};
use super::number::Number;
use super::vector::{Vector, dot};

/// A time and the coordinates of a state, to 106 bits.
#[derive(Clone, Debug)]
pub struct Instant {
    pub time: Wide,
    pub state: Vec<Wide>,
    /// The states of one's own.
    pub own: Vec<Wide>,
}

impl Instant {
    pub fn of(given: &Given) -> Self {
        Self {
            time: given.time.into(),
            state: given.state.iter().map(|x| Wide::from(*x)).collect(),
            own: given.own.iter().map(|x| Wide::from(*x)).collect(),
        }
    }

    /// In doubles, the time first.
    pub fn high(&self) -> Vec<f64> {
        let all = std::iter::once(&self.time).chain(&self.state);
        all.map(|x| x.high).collect()
    }
}

pub struct Scene<'a> {
    pub constants: &'a Constants<'a>,
    given: &'a Given,
    time: Number,
    own: Vec<Wide>,
    frame: Frame,
    attitude: [Number; 4],
    pub angle: Number,
    pub center: Vector,
    pub velocity: Vector,
    /// World axes.
    pub angular_velocity: Vector,
    /// Of a rod.
    pub axis: Vector,
    pub axis_rate: Vector,
    locals: Vec<Value>,
    /// Of each load, if some mention them.
    reactions: Vec<Vector>,
    near_switch: Cell<bool>,
    /// The accelerations that loads follow: of G and angular, world axes.
    following: Cell<[Vector; 2]>,
}

/// How what is fixed in the body lies in the world.
enum Frame {
    Fixed,
    Turned([[Wide; 3]; 3]),
    /// Of a rod nothing is known but what is along it.
    Line([Wide; 3]),
}

#[derive(Clone, Copy)]
enum Value {
    Scalar(Number),
    Vector(Vector),
}

impl Values for Scene<'_> {
    fn scalar(&self, scalar: &Scalar) -> Number {
        let constants = self.constants;
        match scalar {
            Scalar::Param(i) => Number::exactly(constants.params[constants.param_offsets[*i]]),
            Scalar::Input(i) => Number::given(self.given.inputs[constants.input_offsets[*i]]),
            Scalar::Local(i) => match self.locals[*i] {
                Value::Scalar(number) => number,
                Value::Vector(_) => unreachable!("a scalar"),
            },
            Scalar::State(i) => Number::exactly(self.own[*i]),
            Scalar::Time => self.time,
            Scalar::Reaction(load, axis) => {
                let known = self.reactions.get(*load);
                known.map_or(Number::ZERO, |reaction| reaction.component(*axis))
            }
            Scalar::Mass => constants.mass,
            Scalar::Angle => self.angle,
            Scalar::AngularRate => self.angular_velocity.component(2),
            Scalar::AngularAcceleration => self.following.get()[1].component(2),
            Scalar::Attitude(i) => self.attitude[*i],
            Scalar::Component(vector, axes, i) => {
                let vector = self.vector(vector);
                match axes {
                    Axes::World => vector.component(*i),
                    Axes::Body => self.in_body(vector).component(*i),
                }
            }
            Scalar::Dot(a, b) => self.vector(a).dot(self.vector(b)),
            Scalar::PlaneCross(a, b) => self.vector(a).cross(self.vector(b)).component(2),
            Scalar::Norm(vector) => self.vector(vector).norm(),
            Scalar::NormSquared(vector) => {
                let vector = self.vector(vector);
                vector.dot(vector)
            }
            other => self.operation(other),
        }
    }

    fn near_switch(&self) -> &Cell<bool> {
        &self.near_switch
    }
}

impl<'a> Scene<'a> {
    pub fn new(constants: &'a Constants<'a>, given: &'a Given) -> Self {
        Self::at(constants, given, &Instant::of(given))
    }

    /// At another time and in another state than those that are given.
    pub fn at(constants: &'a Constants<'a>, given: &'a Given, instant: &Instant) -> Self {
        let mut scene = Self {
            constants,
            given,
            time: Number::exactly(instant.time),
            own: instant.own.clone(),
            frame: Frame::Fixed,
            attitude: [Number::ZERO; 4],
            angle: Number::ZERO,
            center: Vector::ZERO,
            velocity: Vector::ZERO,
            angular_velocity: Vector::ZERO,
            axis: Vector::ZERO,
            axis_rate: Vector::ZERO,
            locals: Vec::new(),
            reactions: Vec::new(),
            near_switch: Cell::new(false),
            following: Cell::default(),
        };
        scene.place_body(&instant.state);
        for local in &constants.body.locals {
            let value = match local {
                Local::Scalar(scalar) => Value::Scalar(scene.scalar(scalar)),
                Local::Vector(vector) => Value::Vector(scene.vector(vector)),
            };
            scene.locals.push(value);
        }
        scene
    }

    /// With the values of the loads that others follow.
    pub fn with_reactions(self, reactions: Vec<Vector>) -> Self {
        Self { reactions, ..self }
    }

    /// Loads follow these accelerations from now on.
    pub fn follow(&self, [acceleration, turning]: [Vector; 2]) {
        self.following.set([acceleration, turning]);
    }

    /// Whether rounding may decide a condition in this state, or its side of a pole.
    pub fn is_near_switch(&self) -> bool {
        self.near_switch.get()
    }

    fn place_body(&mut self, state: &[Wide]) {
        let constants = self.constants;
        let three = |from: usize| Vector::exactly([state[from], state[from + 1], state[from + 2]]);
        let two = |from: usize| Vector::exactly([state[from], state[from + 1], Wide::ZERO]);
        match &constants.body.motion {
            Motion::Spatial => {
                (self.center, self.velocity) = (three(0), three(7));
                self.turn_by(&state[3..7]);
                self.angular_velocity = self.turned(three(10));
            }
            Motion::Rotation => {
                self.turn_by(&state[..4]);
                self.angular_velocity = self.turned(three(4));
            }
            Motion::Translation => (self.center, self.velocity) = (three(0), three(3)),
            Motion::PlanarTranslation => (self.center, self.velocity) = (two(0), two(2)),
            Motion::Planar => {
                (self.center, self.velocity) = (two(0), two(3));
                self.turn_about(state[2], state[5]);
            }
            Motion::Pivot(_) | Motion::FixedAxis(..) => {
                self.turn_about(state[0], state[1]);
                self.hold();
            }
            Motion::FixedPoint(_) => {
                self.turn_by(&state[..4]);
                self.angular_velocity = self.turned(three(4));
                self.hold();
            }
            Motion::Rod(_) => {
                (self.center, self.velocity) = (three(0), three(6));
                (self.axis, self.axis_rate) = (three(3).normalized(), three(9));
                self.frame = Frame::Line(self.axis.value);
                self.angular_velocity = self.axis.cross(self.axis_rate);
            }
        }
    }

    /// By a quaternion, its scalar last, that is unit to rounding.
    fn turn_by(&mut self, quaternion: &[Wide]) {
        let q: [Wide; 4] = std::array::from_fn(|i| quaternion[i]);
        let norm = q.iter().map(|x| *x * *x).sum::<Wide>().sqrt();
        let [x, y, z, w] = q.map(|x| x / norm);
        let twice = |a: Wide, b: Wide| a * b * 2.0;
        let one = Wide::ONE;
        self.attitude = [w, x, y, z].map(|part| Number::made(part, 0.0, false));
        self.frame = Frame::Turned([
            [
                one - twice(y, y) - twice(z, z),
                twice(x, y) - twice(w, z),
                twice(x, z) + twice(w, y),
            ],
            [
                twice(x, y) + twice(w, z),
                one - twice(z, z) - twice(x, x),
                twice(y, z) - twice(w, x),
            ],
            [
                twice(x, z) - twice(w, y),
                twice(y, z) + twice(w, x),
                one - twice(x, x) - twice(y, y),
            ],
        ]);
    }

    fn turn_about(&mut self, angle: Wide, rate: Wide) {
        let axis = self
            .constants
            .direction
            .map(|x| Number::made(x, 0.0, false));
        self.angle = Number::exactly(angle);
        let matrix = turn(axis, self.angle);
        self.frame = Frame::Turned(matrix.map(|row| row.map(|entry| entry.value)));
        self.angular_velocity = Vector::new(axis).scaled(Number::exactly(rate));
    }

    /// Position and velocity of G by the point that is held.
    fn hold(&mut self) {
        let arm = self.fixed_in_body(self.constants.held_to_center);
        self.center = Vector::new(self.constants.anchor) + arm;
        self.velocity = self.angular_velocity.cross(arm);
    }

    /// From components in body axes.
    pub fn fixed_in_body(&self, components: Components) -> Vector {
        self.turned(Vector::new(components))
    }

    pub fn turned(&self, vector: Vector) -> Vector {
        let value = match &self.frame {
            Frame::Fixed => vector.value,
            Frame::Turned(matrix) => multiplied(matrix, vector.value),
            Frame::Line(axis) => {
                let along = dot(self.constants.direction, vector.value);
                axis.map(|x| x * along)
            }
        };
        Vector { value, ..vector }
    }

    /// In body axes.
    pub fn in_body(&self, vector: Vector) -> Vector {
        let value = match &self.frame {
            Frame::Fixed => vector.value,
            Frame::Turned(m) => [0, 1, 2].map(|i| (0..3).map(|k| m[k][i] * vector.value[k]).sum()),
            Frame::Line(_) => unreachable!("of a rod no axes turn with it"),
        };
        Vector { value, ..vector }
    }

    /// From G, world axes.
    pub fn arm(&self, place: &Place) -> Vector {
        match place {
            Place::Center => Vector::ZERO,
            Place::Named(i) => match self.constants.body.points[*i].axes {
                Axes::Body => self.fixed_in_body(self.constants.points[*i]),
                Axes::World => Vector::new(self.constants.points[*i]) - self.center,
            },
            Place::Shifted(place, vector) => self.arm(place) + self.vector(vector),
        }
    }

    /// From the point that is held, world axes.
    pub fn arm_from_held(&self, place: &Place) -> Vector {
        let constants = self.constants;
        match place {
            Place::Center => self.fixed_in_body(constants.held_to_center),
            Place::Named(i) => {
                let point = constants.points[*i];
                match constants.body.points[*i].axes {
                    Axes::Body => {
                        let held = constants.held_to_center;
                        self.fixed_in_body([0, 1, 2].map(|axis| point[axis] + held[axis]))
                    }
                    Axes::World => {
                        let anchor = constants.anchor;
                        Vector::new([0, 1, 2].map(|axis| point[axis] - anchor[axis]))
                    }
                }
            }
            Place::Shifted(place, vector) => self.arm_from_held(place) + self.vector(vector),
        }
    }

    pub fn position(&self, place: &Place) -> Vector {
        match place {
            Place::Named(i) if self.constants.body.points[*i].axes == Axes::World => {
                Vector::new(self.constants.points[*i])
            }
            _ => self.center + self.arm(place),
        }
    }

    fn point_velocity(&self, place: &Place) -> Vector {
        match place {
            Place::Named(i) if self.constants.body.points[*i].axes == Axes::World => Vector::ZERO,
            _ => self.velocity + self.angular_velocity.cross(self.arm(place)),
        }
    }

    fn listed(&self, numbers: impl Fn(usize) -> Wide) -> Vector {
        let axes = self.constants.body.axes();
        let number = |i: usize| if i < axes { numbers(i) } else { Wide::ZERO };
        Vector::exactly([0, 1, 2].map(number))
    }

    pub fn written(&self, axes: Axes, components: &[Scalar; 3]) -> Vector {
        let vector = Vector::new([0, 1, 2].map(|i| self.scalar(&components[i])));
        self.written_in(axes, vector)
    }

    pub fn written_in(&self, axes: Axes, vector: Vector) -> Vector {
        match axes {
            Axes::World => vector,
            Axes::Body => self.turned(vector),
        }
    }

    pub fn vector(&self, vector: &Written) -> Vector {
        let body = self.constants.body;
        match vector {
            Written::Written(axes, components) => self.written(*axes, components),
            Written::Param(i) => {
                let Param::Vector(axes, _) = body.params[*i] else {
                    unreachable!("a vector")
                };
                let from = self.constants.param_offsets[*i];
                self.written_in(axes, self.listed(|i| self.constants.params[from + i]))
            }
            Written::Input(i) => {
                let Input::Vector(axes) = body.inputs[*i] else {
                    unreachable!("a vector")
                };
                let from = self.constants.input_offsets[*i];
                self.written_in(axes, self.listed(|i| self.given.inputs[from + i].into()))
            }
            Written::Local(i) => match self.locals[*i] {
                Value::Vector(vector) => vector,
                Value::Scalar(_) => unreachable!("a vector"),
            },
            Written::Position => self.center,
            Written::Velocity => self.velocity,
            Written::AngularVelocity => self.angular_velocity,
            Written::Acceleration => self.following.get()[0],
            Written::AngularAcceleration => self.following.get()[1],
            Written::PointAcceleration(place) => {
                let (arm, w) = (self.arm(place), self.angular_velocity);
                let [linear, turning] = self.following.get();
                linear + turning.cross(arm) + w.cross(w.cross(arm))
            }
            Written::Axis => self.axis,
            Written::AxisRate => self.axis_rate,
            Written::PointPosition(place) => self.position(place),
            Written::PointVelocity(place) => self.point_velocity(place),
            Written::Sum(a, b) => self.vector(a) + self.vector(b),
            Written::Difference(a, b) => self.vector(a) - self.vector(b),
            Written::Negative(a) => -self.vector(a),
            Written::Scaled(factor, a) => self.vector(a).scaled(self.scalar(factor)),
            Written::Over(a, divisor) => self.vector(a).over(self.divisor(self.scalar(divisor))),
            Written::Cross(a, b) => self.vector(a).cross(self.vector(b)),
            Written::Turned(z, a) => Vector::normal(self.scalar(z)).cross(self.vector(a)),
            Written::Normalized(a) => {
                let vector = self.vector(a);
                self.is_near(vector.norm());
                vector.normalized()
            }
            Written::If(condition, a, b) => self.vector(if self.holds(condition) { a } else { b }),
        }
    }
}
