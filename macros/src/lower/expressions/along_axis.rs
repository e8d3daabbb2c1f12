//! Rods: their attitude is only an axis u, a unit vector in world axes.
//!
//! The rotation of a rod about its axis is not known. So a vector v of the body is known only if it
//! is along the axis, whose direction in the body is e: then it is `(e . v) u`. It becomes this
//! vector in world axes where it is read. Only the offsets of points stay in body axes, because the
//! inertia is computed from them.

use crate::errors::Extent;
use crate::model::{Attitude, Defaults, Point, Vector};
use crate::symbolic::Components;
use crate::syntax::{Description, Support};

use super::lowering::Lowering;

/// Why a quantity of a rod is not known.
pub const UNTURNED: &str = "the rotation of a rod about its axis is not known";

impl Lowering<'_> {
    /// Reads the direction of `rod(direction)`. From here on, vectors of the body must be along it.
    pub fn axis(&mut self, description: &Description, defaults: &Defaults) -> Option<()> {
        let written = description.motion.as_ref()?.support.as_ref()?;
        let Support {
            arguments, anchor, ..
        } = written;
        if let Some(anchor) = anchor {
            let place = anchor
                .as_ref()
                .map_or(written.extent, |anchor| anchor.extent);
            return self.report(
                place,
                "a rod moves freely, and nothing holds it: leave `.at(..)` out",
            );
        }
        let [direction] = arguments.as_slice() else {
            let place = match arguments.as_slice() {
                [_, Some(excess)] => excess.extent,
                _ => written.extent,
            };
            return self.report(
                place,
                "write `rod(body(1, 0, 0))`: the direction of the axis in the body",
            );
        };
        let direction = self.direction(direction.as_ref()?, defaults)?;
        let axis = self.state.axis?;
        let axis_of_rod = Attitude::Line {
            direction,
            axis: axis.unit,
        };
        self.work.set_attitude(self.state.body, axis_of_rod);
        let swept = (self.state.angular_velocity, axis.rate);
        self.work.swept.push(swept);
        Some(())
    }

    /// `body(x, y, z)`: for a rod, a vector along its axis.
    pub fn body_vector(&mut self, components: Components, place: Extent) -> Option<Vector> {
        if !self.is_along_axis(components) {
            return self.report(
                place,
                format!(
                    "{UNTURNED}, and this vector has a part across it: write a multiple of the \
                     axis, such as `2 * axis`, or world axes"
                ),
            );
        }
        Some(self.work.fixed_in(self.state.body, components))
    }

    /// A point; for a rod it must be on the axis.
    pub fn on_axis(&mut self, point: Point, place: Extent) -> Option<Point> {
        // offsets from G are known only after the parts are
        let is_known = self.composed.is_some() || !self.has_parts;
        match point.offset(self.state.body) {
            Some(offset) if is_known && !self.is_along_axis(offset) => self.report(
                place,
                format!("{UNTURNED}, and this point is not on it: write a point of the axis, or `world(..)`"),
            ),
            _ => Some(point),
        }
    }

    /// Whether a vector of a rod is along its axis; true for other bodies.
    pub fn is_along_axis(&mut self, components: Components) -> bool {
        let Attitude::Line { direction, .. } = self.work.attitude(self.state.body) else {
            return true;
        };
        let graph = &mut self.work.graph;
        let across = graph.cross(direction, components);
        across
            .into_iter()
            .all(|component| graph.vanishes(component))
    }
}
