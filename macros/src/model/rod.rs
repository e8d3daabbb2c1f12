//! Rods: of the attitude there is the axis u alone, a unit vector in world axes.
//!
//! How a rod is turned about its axis is not known, so that a vector v of the body is known only if it
//! is along the direction e of the axis in the body: it is `(e . v) u`. It becomes this vector in world
//! axes where it is read. Only the offsets of points stay in body axes, from which inertia is made.

use crate::errors::Extent;
use crate::symbolic::{Components, Id, Number};
use crate::syntax::{Description, Support};

use super::draft::Draft;
use super::frame::{Attitude, Frame, Vector, Workspace};
use super::inertia::Inertia;
use super::lower::Lowering;
use super::parameters::Defaults;
use super::value::Point;

/// How the inertia of a rod is written.
pub const FORMS: &str =
    "write the one moment across its axis, `rod(l)`, or `compose([..])` of rods and points";

/// Why something is not known of a rod.
pub const UNTURNED: &str = "how a rod is turned about its axis is not known";

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

impl Lowering<'_> {
    /// Reads the direction of `rod(direction)`: from here on, vectors of the body are along it.
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
        self.work.attitude = Attitude::Line {
            direction,
            axis: axis.unit,
        };
        let swept = (self.state.angular_velocity, axis.rate);
        self.work.swept.push(swept);
        Some(())
    }

    /// `body(x, y, z)`: of a rod, a vector along its axis.
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
        Some(self.work.fixed_in_body(components))
    }

    /// A point, of a rod one that is on its axis.
    pub fn on_axis(&mut self, point: Point, place: Extent) -> Option<Point> {
        // no offset from G is known before the parts are
        let is_known = self.composed.is_some() || !self.has_parts;
        match point {
            Point::Body(offset) if is_known && !self.is_along_axis(offset) => self.report(
                place,
                format!("{UNTURNED}, and this point is not on it: write a point of the axis, or `world(..)`"),
            ),
            _ => Some(point),
        }
    }

    /// Whether a vector of the body is along the axis, if it is a rod.
    pub fn is_along_axis(&mut self, components: Components) -> bool {
        let Attitude::Line { direction, .. } = self.work.attitude else {
            return true;
        };
        let graph = &mut self.work.graph;
        let across = graph.cross(direction, components);
        across
            .into_iter()
            .all(|component| graph.vanishes(component))
    }

    /// The inertia of a rod as one moment J: `J (1 - e e)` is the only tensor that it can have.
    pub fn across_axis(&mut self, draft: Draft) -> Option<Draft> {
        let Inertia::Spatial(rows) = draft.inertia else {
            return Some(draft);
        };
        // what is wrong with the direction is reported
        let Attitude::Line { direction, .. } = self.work.attitude else {
            return None;
        };
        let graph = &mut self.work.graph;
        let trace = graph.sum(&[rows[0][0], rows[1][1], rows[2][2]]);
        let half = graph.number(Number::ratio(1, 2));
        let moment = graph.distribute(half, trace);
        let mut rest: Vec<Id> = Vec::new();
        for i in 0..3 {
            for j in 0..3 {
                // J e e, less J if i = j, and the entry
                let dyad = graph.multiply(direction[i], direction[j]);
                let dyad = graph.multiply(moment, dyad);
                let sum = graph.add(rows[i][j], dyad);
                rest.push(if i == j {
                    graph.subtract(sum, moment)
                } else {
                    sum
                });
            }
        }
        if !rest.into_iter().all(|entry| graph.vanishes(entry)) {
            return self.report(
                draft.extent,
                format!(
                    "a rod has no moment of inertia about its axis, and the same one about every axis \
                     across it: {FORMS}"
                ),
            );
        }
        Some(Draft {
            inertia: Inertia::Scalar(moment),
            ..draft
        })
    }
}
