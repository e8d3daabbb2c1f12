//! What others see of a body that moves, and of its joint.

use crate::lower::expressions::{BodyMotion, Value};
use crate::model::{Attitude, Dimension, Frame, Part, Rates, State, TreeJoint, Variable, Vector};
use crate::symbolic::{Components, Id};

use crate::lower::system::reading::body::Draft;
use crate::lower::system::reading::reader::Reader;

impl Reader<'_> {
    /// Others may ask how the body moves.
    pub fn tell_of(&mut self, body: usize, state: &State) {
        let values = self.values_of_motion(state);
        let known = &mut self.members.bodies[body];
        known.motion = Some(BodyMotion {
            position: state.position,
            velocity: state.velocity,
            angular_velocity: state.angular_velocity,
        });
        known.values.extend(values);
    }

    /// What of a motion has a name behind that of the body.
    pub fn values_of_motion(&mut self, state: &State) -> Vec<(&'static str, Value)> {
        let turning = if self.system.is_planar {
            Value::Scalar(state.angular_velocity[2], Dimension::FREQUENCY)
        } else {
            let vector = self.work.vector(state.body, state.angular_velocity);
            Value::Vector(vector, Dimension::FREQUENCY)
        };
        vec![
            ("position", Value::Vector(state.position, Dimension::LENGTH)),
            (
                "velocity",
                Value::Vector(state.velocity, Dimension::VELOCITY),
            ),
            ("angular_velocity", turning),
        ]
    }

    /// `attitude`, of a body in the plane the sum of the angles that carry it.
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

    /// The coordinates of a joint and their rates, by the names that its state has for them.
    pub fn joint_values(&mut self, joint: &TreeJoint) -> Vec<(&'static str, Value)> {
        self.values_of_joint(joint, &joint.coordinates)
    }

    /// The same, of these coordinates.
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
            let parts = (0..field.names.len())
                .map(|part| coordinates.get(field.variable, field.first + part));
            let parts: Vec<Id> = parts.flatten().collect();
            let value = match *parts.as_slice() {
                [scalar] => Value::Scalar(scalar, dimension),
                _ => Value::Vector(self.vector_of(joint, field.variable, &parts), dimension),
            };
            values.push((field.path, value));
        }
        values
    }

    /// The vector that several components of a state are.
    fn vector_of(&mut self, joint: &TreeJoint, variable: Variable, parts: &[Id]) -> Vector {
        let body = joint.frames.last().copied().unwrap_or(Frame::WORLD);
        if variable == Variable::AngularVelocity {
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

    /// The directions in which a joint slides, and the frame that they are fixed in.
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
