//! Vectors of a rod: they are known along its axis alone.

use crate::symbolic::Components;

use super::attitude::Attitude;
use super::vector::Vector;
use super::workspace::Workspace;
use crate::model::words::Frame;

impl Workspace {
    /// A vector that is fixed in the body, from its components in body axes.
    pub fn fixed_in_body(&mut self, components: Components) -> Vector {
        let Attitude::Line { direction, axis } = self.attitude(Frame::BODY) else {
            return self.vector(Frame::BODY, components);
        };
        let along = self.graph.dot(direction, components);
        let world = self.graph.scale_vector(along, axis);
        self.vector(Frame::WORLD, world)
    }

    /// Remembers a product with the axis of a rod.
    pub fn note_swept(&mut self, a: Components, b: Components, product: Components) {
        let Attitude::Line { axis, .. } = self.attitude(Frame::BODY) else {
            return;
        };
        if a == axis {
            self.swept.push((product, b));
        } else if b == axis {
            let opposite = self.graph.negate_vector(a);
            self.swept.push((product, opposite));
        }
    }
}
