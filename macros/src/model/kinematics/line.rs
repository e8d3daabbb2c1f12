//! Vectors of a rod: they are known along its axis alone.

use crate::symbolic::Components;

use super::frame::{Attitude, Frame, Vector};
use super::workspace::Workspace;

impl Workspace {
    /// A vector that is fixed in the body, from its components in body axes.
    pub fn fixed_in_body(&mut self, components: Components) -> Vector {
        let Attitude::Line { direction, axis } = self.attitude else {
            return self.vector(Frame::Body, components);
        };
        let along = self.graph.dot(direction, components);
        let world = self.graph.scale_vector(along, axis);
        self.vector(Frame::World, world)
    }

    /// Remembers a product with the axis of a rod.
    pub fn note_swept(&mut self, a: Vector, b: Vector, product: Components) {
        let Attitude::Line { axis, .. } = self.attitude else {
            return;
        };
        if a.world == axis {
            self.swept.push((product, b.world));
        } else if b.world == axis {
            let opposite = self.graph.negate_vector(a.world);
            self.swept.push((product, opposite));
        }
    }
}
