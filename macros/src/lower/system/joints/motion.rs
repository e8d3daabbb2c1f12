//! How the bodies of a tree move: their states, from the ground to the tips.

use crate::model::{
    Attitude, Coordinate, Frame, Meaning, Part, Rates, Shape, State, TreeJoint, Variable, Vector,
    Workspace,
};
use crate::symbolic::{Components, Function, Graph, Id, Stage};

use super::joint::Written;
use crate::lower::system::reading::body::Draft;
use crate::lower::system::reading::reader::{Reader, still};

/// The motion of a body in the making: where its joint is, and how that moves.
struct Moving {
    frame: Frame,
    position: Vector,
    velocity: Vector,
    /// In the axes of the frame.
    angular_velocity: Components,
}

impl Reader<'_> {
    /// Gives each body of the tree its state, by its joint.
    pub fn motions(
        &mut self,
        order: Vec<usize>,
        joints: Vec<Option<Written>>,
        drafts: &mut [Draft<'_>],
    ) -> Vec<TreeJoint> {
        let mut joints: Vec<Option<Written>> = joints;
        let mut tree = Vec::new();
        for index in order {
            let Some(written) = joints[index].take() else {
                continue;
            };
            let joint = self.motion(written, drafts);
            let names = self.joint_values(&joint);
            self.members.joints[index].values = names;
            self.members.joints[index].is_known = true;
            tree.push(joint);
        }
        tree
    }

    fn motion(&mut self, written: Written, drafts: &mut [Draft<'_>]) -> TreeJoint {
        let (kind, body) = (written.kind, drafts[written.carried].frame);
        let work = &mut self.work;
        let components = kind.shape.into_iter().flat_map(Shape::components);
        let coordinates = match &written.driven {
            Some(prescribed) => prescribed.clone(),
            None => symbols(work, body, components),
        };
        let carrier = written
            .carrier
            .and_then(|carrier| drafts[carrier].state.as_ref());
        let mut moving = Moving::at_joint(work, carrier, written.place);
        let frames = moving.through(work, body, &written, &coordinates);
        let [position, velocity] = moving.center(work, body, written.pin);
        let state = State {
            position,
            velocity,
            angular_velocity: moving.angular_velocity,
            ..still(body, self.time)
        };
        self.tell_of(written.carried, &state);
        drafts[written.carried].state = Some(state);
        self.define_attitude(&mut drafts[written.carried], kind.has_attitude());
        let turns = kind
            .parts
            .iter()
            .any(|part| !matches!(part, Part::Slide(_)));
        let is_carried = written.carrier.is_some_and(|carrier| self.turning[carrier]);
        self.turning[written.carried] = turns || is_carried;
        let freedoms = kind.freedoms(self.system.is_planar);
        let given = freedoms.iter().map(|(variable, part)| {
            let acceleration = match variable {
                Variable::Velocity => Variable::LinearAcceleration,
                _ => Variable::AngularAcceleration,
            };
            let driven = written.driven.as_ref();
            driven.and_then(|rates| rates.get(acceleration, *part))
        });
        TreeJoint {
            name: written.name,
            kind,
            carrier: written.carrier,
            carried: written.carried,
            place: written.place,
            pin: written.pin,
            directions: written.directions,
            pitch: written.pitch,
            turned: written.turned,
            frames,
            coordinates,
            given: given.collect(),
            armature: written.armature,
            drives: vec![self.work.graph.zero(); freedoms.len()],
            driven_by: Vec::new(),
            open: vec![None; freedoms.len()],
        }
    }
}

/// Symbols for the components of a state and its acceleration.
fn symbols(
    work: &mut Workspace,
    body: Frame,
    components: impl Iterator<Item = (Variable, usize)>,
) -> Rates {
    let all = components.map(|(variable, part)| Coordinate {
        variable,
        part,
        id: work.symbol(Stage::State, Meaning::Of(body, variable, part)),
    });
    Rates(all.collect())
}

impl Moving {
    /// Where a joint is on the ground, or on a body that moves so.
    fn at_joint(work: &mut Workspace, carrier: Option<&State>, place: Components) -> Self {
        let Some(state) = carrier else {
            return Self {
                frame: Frame::WORLD,
                position: work.vector(Frame::WORLD, place),
                velocity: Vector::ZERO,
                angular_velocity: work.graph.zeros(),
            };
        };
        let offset = work.vector(state.body, place);
        let swept = work.graph.cross(state.angular_velocity, place);
        let swept = work.vector(state.body, swept);
        Self {
            frame: state.body,
            position: work.add(state.position, offset),
            velocity: work.add(state.velocity, swept),
            angular_velocity: state.angular_velocity,
        }
    }

    /// Passes all parts of a joint, and returns their frames.
    fn through(
        &mut self,
        work: &mut Workspace,
        body: Frame,
        joint: &Written,
        coordinates: &Rates,
    ) -> Vec<Frame> {
        let zeros = work.graph.zeros();
        let mut frames = Vec::new();
        for &(direction, angle) in &joint.turned {
            let frame = work.new_frame(self.frame);
            work.set_attitude(frame, Attitude::Axis { angle, direction });
            self.enter(work, frame, zeros);
            frames.push(frame);
        }
        let parts = joint.kind.parts;
        for (place, part) in joint.kind.numbered().enumerate() {
            let is_last = place + 1 == parts.len();
            let frame = if is_last {
                body
            } else {
                work.new_frame(self.frame)
            };
            work.set_carrier(frame, self.frame);
            self.pass(work, frame, part, joint, coordinates);
            frames.push(frame);
        }
        if parts.is_empty() {
            work.set_carrier(body, self.frame);
            self.enter(work, body, zeros);
            frames.push(body);
        }
        frames
    }

    /// Position and velocity of G, from the point at which the joint holds the body.
    fn center(&self, work: &mut Workspace, body: Frame, pin: Components) -> [Vector; 2] {
        let back = work.graph.negate_vector(pin);
        let swept = work.graph.cross(self.angular_velocity, back);
        let (back, swept) = (work.vector(body, back), work.vector(body, swept));
        [
            work.add(self.position, back),
            work.add(self.velocity, swept),
        ]
    }

    /// Goes on in a frame that turns against the last one at a rate, in its axes.
    fn enter(&mut self, work: &mut Workspace, frame: Frame, rate: Components) {
        let carried = work.turn(self.angular_velocity, self.frame, frame);
        let whole = work.graph.add_vectors(carried, rate);
        self.angular_velocity = work.graph.quantities(whole);
        self.frame = frame;
    }

    /// Passes a part of a joint.
    fn pass(
        &mut self,
        work: &mut Workspace,
        frame: Frame,
        (part, coordinate): (Part, usize),
        joint: &Written,
        of: &Rates,
    ) {
        let zero = work.graph.zero();
        let get = |variable: Variable, part: usize| of.get(variable, part).unwrap_or(zero);
        match part {
            Part::Turn(number) => {
                let angle = get(Variable::Angle, coordinate);
                let rate = get(Variable::AngularVelocity, coordinate);
                let direction = joint.directions[number];
                set_angle(work, frame, angle, direction, &joint.name);
                let rate = work.graph.scale_vector(rate, direction);
                self.enter(work, frame, rate);
            }
            Part::Slide(number) => {
                self.slide(
                    work,
                    joint.directions[number],
                    get(Variable::Position, coordinate),
                    get(Variable::Velocity, coordinate),
                );
                let zeros = work.graph.zeros();
                self.enter(work, frame, zeros);
            }
            Part::Screw => {
                let (direction, pitch) = (joint.directions[0], joint.pitch.unwrap_or(zero));
                let [angle, rate] = [get(Variable::Angle, 0), get(Variable::AngularVelocity, 0)];
                let (distance, speed) = (
                    work.graph.multiply(pitch, angle),
                    work.graph.multiply(pitch, rate),
                );
                self.slide(work, direction, distance, speed);
                set_angle(work, frame, angle, direction, &joint.name);
                let rate = work.graph.scale_vector(rate, direction);
                self.enter(work, frame, rate);
            }
            Part::Ball => {
                set_quaternion(work, frame, get);
                let rate = [0, 1, 2].map(|axis| get(Variable::AngularVelocity, axis));
                self.enter(work, frame, rate);
            }
            Part::Free => self.float(work, frame, of),
        }
    }

    /// Moves as it may, in the plane or in space.
    fn float(&mut self, work: &mut Workspace, frame: Frame, of: &Rates) {
        let zero = work.graph.zero();
        let get = |variable: Variable, part: usize| of.get(variable, part).unwrap_or(zero);
        let vector = |variable: Variable| [0, 1, 2].map(|axis| get(variable, axis));
        let (position, velocity) = (vector(Variable::Position), vector(Variable::Velocity));
        self.position = work.vector(Frame::WORLD, position);
        self.velocity = work.vector(Frame::WORLD, velocity);
        let rate = if of.get(Variable::Quaternion, 0).is_some() {
            set_quaternion(work, frame, get);
            vector(Variable::AngularVelocity)
        } else {
            let direction = work.graph.unit_vectors()[2];
            let angle = get(Variable::Angle, 0);
            work.set_attitude(frame, Attitude::Axis { angle, direction });
            [zero, zero, get(Variable::AngularVelocity, 0)]
        };
        self.enter(work, frame, rate);
    }

    /// Moves along a direction that turns with the frame.
    fn slide(&mut self, work: &mut Workspace, direction: Components, distance: Id, speed: Id) {
        let graph: &mut Graph = &mut work.graph;
        let step = graph.scale_vector(distance, direction);
        let swept = graph.cross(self.angular_velocity, step);
        let slid = graph.scale_vector(speed, direction);
        let change = graph.add_vectors(swept, slid);
        let (step, change) = (
            work.vector(self.frame, step),
            work.vector(self.frame, change),
        );
        self.position = work.add(self.position, step);
        self.velocity = work.add(self.velocity, change);
    }
}

/// Turns a frame by an angle, whose sine and cosine are named after the joint.
fn set_angle(
    work: &mut Workspace,
    frame: Frame,
    angle: Id,
    direction: Components,
    joint: &proc_macro2::Ident,
) {
    work.set_attitude(frame, Attitude::Axis { angle, direction });
    for (function, name) in [(Function::Sin, "sine"), (Function::Cos, "cosine")] {
        let value = work.graph.apply(function, &[angle]);
        work.labels.name(value, format!("{name}_{joint}"));
    }
}

fn set_quaternion(work: &mut Workspace, frame: Frame, get: impl Fn(Variable, usize) -> Id) {
    let scalar = get(Variable::Quaternion, 0);
    let vector = [1, 2, 3].map(|part| get(Variable::Quaternion, part));
    work.set_attitude(frame, Attitude::Quaternion { scalar, vector });
}
