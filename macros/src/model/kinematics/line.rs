//! Vectors of a rod, which are known only along its axis.

use crate::model::words::Frame;
use crate::symbolic::Components;

use super::attitude::Attitude;
use super::vector::Vector;
use super::workspace::Workspace;

impl Workspace {
    /// A vector fixed in the body, from its components in body axes.
    pub fn fixed_in(&mut self, body: Frame, components: Components) -> Vector {
        let Attitude::Line { direction, axis } = self.attitude(body) else {
            return self.vector(body, components);
        };
        let along = self.graph.dot(direction, components);
        let world = self.graph.scale_vector(along, axis);
        self.vector(Frame::WORLD, world)
    }

    /// Records a cross product with the axis of a rod.
    pub fn note_swept(&mut self, a: Components, b: Components, product: Components) {
        let is_axis = |v: Components| {
            let mut attitudes = self.attitudes.iter();
            attitudes.any(|known| matches!(known, Attitude::Line { axis, .. } if *axis == v))
        };
        if is_axis(a) {
            self.swept.push((product, b));
        } else if is_axis(b) {
            let opposite = self.graph.negate_vector(a);
            self.swept.push((product, opposite));
        }
    }
}
