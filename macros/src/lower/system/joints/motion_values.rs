//! The quantities of a moving body, and of its joint, that others can use.

use crate::lower::expressions::{BodyMotion, Value};
use crate::model::{
    Attitude, Dimension, Field, Frame, Part, Rates, State, TreeJoint, Variable, Vector,
};
use crate::symbolic::{Components, Id};

use crate::lower::system::reading::body::Draft;
use crate::lower::system::reading::reader::Reader;

impl Reader<'_> {
    /// Registers the motion of a body, for others to use.
    pub fn tell_of(&mut self, body: usize, state: &State) {
        let values = self.values_of_motion(state);
        let known = &mut self.members.bodies[body];
        known.motion = Some(BodyMotion {
            position: state.position,
            velocity: state.velocity,
            acceleration: state.acceleration,
            angular_velocity: state.angular_velocity,
            angular_acceleration: state.angular_acceleration,
        });
        known.values.extend(values);
    }

    /// The quantities of a motion, by the words that follow the name of the body.
    pub fn values_of_motion(&mut self, state: &State) -> Vec<(&'static str, Value)> {
        let mut turning = |components: Components, dimension: Dimension| {
            if self.system.is_planar {
                return Value::Scalar(components[2], dimension);
            }
            Value::Vector(self.work.vector(state.body, components), dimension)
        };
        let (w, rate) = (state.angular_velocity, state.angular_acceleration);
        let rate = turning(rate, Dimension::ANGULAR_ACCELERATION);
        vec![
            ("position", Value::Vector(state.position, Dimension::LENGTH)),
            (
                "velocity",
                Value::Vector(state.velocity, Dimension::VELOCITY),
            ),
            (
                "acceleration",
                Value::Vector(state.acceleration, Dimension::ACCELERATION),
            ),
            ("angular_velocity", turning(w, Dimension::FREQUENCY)),
            ("angular_acceleration", rate),
        ]
    }

    /// Defines `attitude`; for a planar body, it is the sum of the angles of the joints that carry
    /// it.
    pub fn define_attitude(&mut self, draft: &mut Draft<'_>, is_told: bool) {
        let value = if self.system.is_planar {
            let mut angles = Vec::new();
            let mut frame = draft.frame;
            while frame != Frame::WORLD {
                if let Attitude::Axis { angle, .. } = self.work.attitude(frame) {
                    angles.push(angle);
                }
                frame = self.work.carrier(frame);
            }
            Value::Scalar(self.work.graph.sum(&angles), Dimension::NONE)
        } else if is_told {
            Value::Attitude
        } else {
            return;
        };
        draft.scope.define("attitude", Some(value));
        let name = draft.description.name.to_string();
        for body in &mut self.members.bodies {
            if body.name == name && self.system.is_planar {
                body.values.push(("attitude", value));
            }
        }
    }

    /// The coordinates of a joint with their rates, by their names in its state, and the
    /// accelerations.
    pub fn joint_values(&mut self, joint: &TreeJoint) -> Vec<(&'static str, Value)> {
        self.values_of_joint(joint, &joint.coordinates)
    }

    /// The same for these coordinates.
    pub fn values_of_joint(
        &mut self,
        joint: &TreeJoint,
        coordinates: &Rates,
    ) -> Vec<(&'static str, Value)> {
        let Some(shape) = joint.kind.shape else {
            return Vec::new();
        };
        let mut values = Vec::new();
        for field in shape.fields {
            let dimension = match field.variable {
                Variable::Position => Dimension::LENGTH,
                Variable::Velocity => Dimension::VELOCITY,
                Variable::AngularVelocity => Dimension::FREQUENCY,
                _ => Dimension::NONE,
            };
            if field.variable == Variable::Quaternion {
                continue;
            }
            let value = self.value_of_field(joint, coordinates, (field, field.variable, dimension));
            values.push((field.path, value));
            if let Some((word, variable, dimension)) = second(field) {
                let value = self.value_of_field(joint, coordinates, (field, variable, dimension));
                values.push((word, value));
            }
        }
        values
    }

    /// A scalar or a vector of a joint: the components of this variable that belong to a field.
    fn value_of_field(
        &mut self,
        joint: &TreeJoint,
        coordinates: &Rates,
        (field, variable, dimension): (&Field, Variable, Dimension),
    ) -> Value {
        let parts =
            (0..field.names.len()).map(|part| coordinates.get(variable, field.first + part));
        let parts: Vec<Id> = parts.flatten().collect();
        match *parts.as_slice() {
            [scalar] => Value::Scalar(scalar, dimension),
            _ => Value::Vector(self.vector_of(joint, variable, &parts), dimension),
        }
    }

    /// The vector made of several components of a state.
    fn vector_of(&mut self, joint: &TreeJoint, variable: Variable, parts: &[Id]) -> Vector {
        let body = joint.frames.last().copied().unwrap_or(Frame::WORLD);
        if matches!(
            variable,
            Variable::AngularVelocity | Variable::AngularAcceleration
        ) {
            let mut components = self.work.graph.zeros();
            components[..parts.len()].copy_from_slice(parts);
            return self.work.vector(body, components);
        }
        let (frame, directions) = self.slides(joint);
        let mut whole = Vector::ZERO;
        for (part, direction) in parts.iter().zip(directions) {
            let along = self.work.graph.scale_vector(*part, direction);
            let along = self.work.vector(frame, along);
            whole = self.work.add(whole, along);
        }
        whole
    }

    /// The directions in which a joint slides, and their frame.
    pub fn slides(&self, joint: &TreeJoint) -> (Frame, Vec<Components>) {
        if joint.kind.is_free() {
            return (Frame::WORLD, joint.directions.clone());
        }
        let parts = joint.kind.parts;
        let slides = parts.iter().filter_map(|part| match part {
            Part::Slide(number) => Some(joint.directions[*number]),
            _ => None,
        });
        let first = joint.frames.len() - parts.len();
        let frame = self.work.carrier(joint.frames[first]);
        (frame, slides.collect())
    }
}

/// The derivative of a rate: its word, its variable and its dimension.
fn second(rate: &Field) -> Option<(&'static str, Variable, Dimension)> {
    let (linear, angular) = (Variable::LinearAcceleration, Variable::AngularAcceleration);
    let turned = |word| Some((word, angular, Dimension::ANGULAR_ACCELERATION));
    match rate.path {
        "velocity" => Some(("acceleration", linear, Dimension::ACCELERATION)),
        "angular_velocity" => turned("angular_acceleration"),
        "angular_velocity_1" => turned("angular_acceleration_1"),
        "angular_velocity_2" => turned("angular_acceleration_2"),
        _ => None,
    }
}
