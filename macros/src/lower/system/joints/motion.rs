//! The motion of the bodies of a tree: their states, from the ground up.

use proc_macro2::Ident;

use crate::model::{
    Attitude, Connection, Coordinate, Frame, Meaning, Part, Rates, Shape, State, TreeJoint,
    Variable, Vector, Workspace,
};
use crate::symbolic::{Components, Function, Graph, Id, Stage};

use super::joint::ReadJoint;
use crate::lower::system::reading::body::Draft;
use crate::lower::system::reading::reader::{Reader, still};

/// The motion of a body while the parts of its joint are applied, and the place of the joint.
struct MotionInMaking {
    frame: Frame,
    position: Vector,
    velocity: Vector,
    /// In the axes of the frame.
    angular_velocity: Components,
    /// Present if loads depend on accelerations: that of the position, and the angular one in the
    /// axes of the frame.
    accelerations: Option<(Vector, Components)>,
}

/// The angular rate and its derivative; the displacement of a slide and both of its derivatives.
const TURNING: [Variable; 2] = [Variable::AngularVelocity, Variable::AngularAcceleration];
const SLIDING: [Variable; 3] = [
    Variable::Position,
    Variable::Velocity,
    Variable::LinearAcceleration,
];

impl Reader<'_> {
    /// Gives each body of the tree its state, which follows from its joint.
    pub fn motions(
        &mut self,
        order: Vec<usize>,
        mut joints: Vec<Option<ReadJoint>>,
        drafts: &mut [Draft<'_>],
    ) -> Vec<TreeJoint> {
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

    fn motion(&mut self, written: ReadJoint, drafts: &mut [Draft<'_>]) -> TreeJoint {
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
        let mut moving = MotionInMaking::at_joint(work, carrier, written.place);
        if self.system.mentions_accelerations {
            moving.accelerations = Some(accelerations_at(work, carrier, written.place));
        }
        let frames = moving.through(work, body, &written, &coordinates);
        let [position, velocity, acceleration] = moving.center(work, body, written.pin);
        let still = still(body, self.time);
        let arm = match written.directions.first() {
            Some(axis) if !self.system.is_planar => work.graph.cross(*axis, written.pin),
            _ => written.pin,
        };
        // a frame has no inertia about its own joint, and that of a rod may vanish about this axis
        let is_on_frame = written
            .carrier
            .is_some_and(|carrier| self.massless[carrier]);
        let state = State {
            swings: kind.is_hinge() && !is_on_frame && !work.graph.is_zero_vector(&arm),
            position,
            velocity,
            acceleration,
            angular_velocity: moving.angular_velocity,
            angular_acceleration: moving
                .accelerations
                .map_or(still.angular_acceleration, |(_, angular)| angular),
            ..still
        };
        self.tell_of(written.carried, &state);
        drafts[written.carried].state = Some(state);
        self.define_attitude(&mut drafts[written.carried], kind.has_attitude());
        let turns = kind.turns();
        let is_carried = written.carrier.is_some_and(|carrier| self.turning[carrier]);
        self.turning[written.carried] = turns || is_carried;
        let freedoms = kind.freedoms(self.system.is_planar);
        let given = freedoms.iter().map(|freedom| written.given(*freedom));
        let given: Vec<_> = given.collect();
        let moves = is_on_frame || given.iter().any(Option::is_none);
        self.massless[written.carried] = drafts[written.carried].description.is_frame && moves;
        TreeJoint {
            connection: written.connection,
            frames,
            coordinates,
            given,
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

/// The acceleration of a point of a body at this offset, and the angular acceleration of the body.
fn accelerations_at(
    work: &mut Workspace,
    carrier: Option<&State>,
    place: Components,
) -> (Vector, Components) {
    let Some(state) = carrier else {
        return (Vector::ZERO, work.graph.zeros());
    };
    let (w, rate) = (state.angular_velocity, state.angular_acceleration);
    let thrown = thrown(&mut work.graph, (w, rate), place);
    let thrown = work.vector(state.body, thrown);
    (work.add(state.acceleration, thrown), rate)
}

/// `w' x r + w x (w x r)`
fn thrown(
    graph: &mut Graph,
    (w, rate): (Components, Components),
    offset: Components,
) -> Components {
    let (driven, swept) = (graph.cross(rate, offset), graph.cross(w, offset));
    let drawn = graph.cross(w, swept);
    graph.add_vectors(driven, drawn)
}

impl MotionInMaking {
    /// The place of a joint on the ground, or on a body with this motion.
    fn at_joint(work: &mut Workspace, carrier: Option<&State>, place: Components) -> Self {
        let Some(state) = carrier else {
            return Self {
                frame: Frame::WORLD,
                position: work.vector(Frame::WORLD, place),
                velocity: Vector::ZERO,
                angular_velocity: work.graph.zeros(),
                accelerations: None,
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
            accelerations: None,
        }
    }

    /// Applies all parts of a joint, and returns the frames after them.
    fn through(
        &mut self,
        work: &mut Workspace,
        body: Frame,
        joint: &Connection,
        coordinates: &Rates,
    ) -> Vec<Frame> {
        let zeros = work.graph.zeros();
        let mut frames = Vec::new();
        for &(direction, angle) in &joint.turned {
            let frame = work.new_frame(self.frame);
            work.set_attitude(frame, Attitude::Axis { angle, direction });
            self.enter(work, frame, [zeros; 2]);
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
            self.enter(work, body, [zeros; 2]);
            frames.push(body);
        }
        frames
    }

    /// Position, velocity and acceleration of G. `pin` is the point at which the joint holds the
    /// body.
    fn center(&self, work: &mut Workspace, body: Frame, pin: Components) -> [Vector; 3] {
        let back = work.graph.negate_vector(pin);
        let swept = work.graph.cross(self.angular_velocity, back);
        let acceleration = self.accelerations.map(|(linear, rate)| {
            let thrown = thrown(&mut work.graph, (self.angular_velocity, rate), back);
            let thrown = work.vector(body, thrown);
            work.add(linear, thrown)
        });
        let (back, swept) = (work.vector(body, back), work.vector(body, swept));
        [
            work.add(self.position, back),
            work.add(self.velocity, swept),
            acceleration.unwrap_or(Vector::ZERO),
        ]
    }

    /// Continues in a frame that rotates relative to the last one. The rate of this rotation and
    /// its derivative are in the axes of the new frame.
    fn enter(&mut self, work: &mut Workspace, frame: Frame, [rate, second]: [Components; 2]) {
        let carried = work.turn(self.angular_velocity, self.frame, frame);
        if let Some((_, angular)) = &mut self.accelerations {
            let turned = work.turn(*angular, self.frame, frame);
            let graph = &mut work.graph;
            let swung = graph.cross(carried, rate);
            let own = graph.add_vectors(swung, second);
            let whole = graph.add_vectors(turned, own);
            *angular = graph.quantities(whole);
        }
        let whole = work.graph.add_vectors(carried, rate);
        self.angular_velocity = work.graph.quantities(whole);
        self.frame = frame;
    }

    /// Applies one part of a joint.
    fn pass(
        &mut self,
        work: &mut Workspace,
        frame: Frame,
        (part, coordinate): (Part, usize),
        joint: &Connection,
        of: &Rates,
    ) {
        let zero = work.graph.zero();
        let get = |variable: Variable, part: usize| of.get(variable, part).unwrap_or(zero);
        match part {
            Part::Turn(number) => {
                let angle = get(Variable::Angle, coordinate);
                let direction = joint.directions[number];
                set_angle(work, frame, angle, direction, &joint.name);
                let rates = TURNING.map(|variable| {
                    let rate = get(variable, coordinate);
                    work.graph.scale_vector(rate, direction)
                });
                self.enter(work, frame, rates);
            }
            Part::Slide(number) => {
                let moved = SLIDING.map(|variable| get(variable, coordinate));
                self.slide(work, joint.directions[number], moved);
                let zeros = work.graph.zeros();
                self.enter(work, frame, [zeros; 2]);
            }
            Part::Screw => {
                let (direction, pitch) = (joint.directions[0], joint.pitch.unwrap_or(zero));
                let (angle, rates) = (get(Variable::Angle, 0), TURNING.map(|rate| get(rate, 0)));
                let moved = [angle, rates[0], rates[1]];
                let moved = moved.map(|part| work.graph.multiply(pitch, part));
                self.slide(work, direction, moved);
                set_angle(work, frame, angle, direction, &joint.name);
                let rates = rates.map(|rate| work.graph.scale_vector(rate, direction));
                self.enter(work, frame, rates);
            }
            Part::Ball => {
                set_quaternion(work, frame, get);
                let rates = TURNING.map(|variable| [0, 1, 2].map(|axis| get(variable, axis)));
                self.enter(work, frame, rates);
            }
            Part::Free => self.float(work, frame, &joint.name, of),
        }
    }

    /// Applies a part that moves freely, in the plane or in space.
    fn float(&mut self, work: &mut Workspace, frame: Frame, joint: &Ident, of: &Rates) {
        let zero = work.graph.zero();
        let get = |variable: Variable, part: usize| of.get(variable, part).unwrap_or(zero);
        let vector = |variable: Variable| [0, 1, 2].map(|axis| get(variable, axis));
        let (position, velocity) = (vector(Variable::Position), vector(Variable::Velocity));
        self.position = work.vector(Frame::WORLD, position);
        self.velocity = work.vector(Frame::WORLD, velocity);
        if let Some((linear, _)) = &mut self.accelerations {
            *linear = work.vector(Frame::WORLD, vector(Variable::LinearAcceleration));
        }
        let rates = if of.get(Variable::Quaternion, 0).is_some() {
            set_quaternion(work, frame, get);
            TURNING.map(vector)
        } else {
            let direction = work.graph.unit_vectors()[2];
            let angle = get(Variable::Angle, 0);
            set_angle(work, frame, angle, direction, joint);
            TURNING.map(|variable| [zero, zero, get(variable, 0)])
        };
        self.enter(work, frame, rates);
    }

    /// Applies a slide along a direction that rotates with the frame: the distance and its
    /// derivatives.
    fn slide(
        &mut self,
        work: &mut Workspace,
        direction: Components,
        [distance, speed, second]: [Id; 3],
    ) {
        let graph: &mut Graph = &mut work.graph;
        let step = graph.scale_vector(distance, direction);
        let swept = graph.cross(self.angular_velocity, step);
        let slid = graph.scale_vector(speed, direction);
        let change = graph.add_vectors(swept, slid);
        if let Some((linear, rate)) = &mut self.accelerations {
            // w' x r + w x (w x r) + 2 w x v + r''
            let thrown = thrown(graph, (self.angular_velocity, *rate), step);
            let twice = graph.add_vectors(slid, slid);
            let coriolis = graph.cross(self.angular_velocity, twice);
            let own = graph.scale_vector(second, direction);
            let sum = graph.add_vectors(thrown, coriolis);
            let sum = graph.add_vectors(sum, own);
            let sum = work.vector(self.frame, sum);
            *linear = work.add(*linear, sum);
        }
        let (step, change) = (
            work.vector(self.frame, step),
            work.vector(self.frame, change),
        );
        self.position = work.add(self.position, step);
        self.velocity = work.add(self.velocity, change);
    }
}

/// Rotates a frame by an angle, whose sine and cosine are named after the joint.
fn set_angle(work: &mut Workspace, frame: Frame, angle: Id, direction: Components, joint: &Ident) {
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
