//! Loads, and the pole of the moment balance.

use crate::families::LoadKind;
use crate::lower::expressions::Lowering;
use crate::model::{Dimension, Frame, Load, Point};
use crate::syntax::{self, Written};

impl Lowering<'_> {
    pub fn load(&mut self, written: &syntax::Load) -> Option<Load> {
        let value = written.vector.as_ref();
        let vector = value.and_then(|value| match written.kind {
            LoadKind::Force => self.vector(value, Dimension::FORCE, "a force"),
            LoadKind::Moment if self.motion.is_planar => {
                let moment = self.scalar(value, Dimension::MOMENT, "a moment")?;
                let zero = self.work.graph.zero();
                Some(self.work.vector(self.state.axes, [zero, zero, moment]))
            }
            LoadKind::Moment => self.vector(value, Dimension::MOMENT, "a moment"),
        });
        let point = self.point_of_load(written);
        let (name, vector) = (written.name.clone(), vector?);
        let mention = value.and_then(|value| {
            let parts = self.work.entries(&[vector]);
            let reaction = self.mentioned_reaction(value);
            reaction.or_else(|| self.mentioned_acceleration(value, &parts))
        });
        Some(Load {
            mention,
            ..Load::new(name, written.family, written.kind, vector, point?)
        })
    }

    /// The point of action of a load; G without `.at(..)`.
    pub fn point_of_load(&mut self, written: &syntax::Load) -> Option<Point> {
        match &written.point {
            Some(None) => None,
            Some(Some(point)) => self.point(point).and_then(|found| match found {
                Point::Fixed(Frame::WORLD, _) if !self.motion.knows_position() => self.report(
                    point.extent,
                    "where this point is relative to the body is not known under `motion: \
                     rotation`: the motion of G is not modeled",
                ),
                found => Some(found),
            }),
            None => Some(self.state.mass_center(self.work)),
        }
    }

    pub fn pole(&mut self, written: Option<&Written>) -> Option<Point> {
        let Some(written) = written else {
            return Some(self.state.mass_center(self.work));
        };
        let value = written.value.as_ref()?;
        let point = self.point(value)?;
        let offset = point.offset(self.state.body);
        let is_center = offset.is_some_and(|offset| self.work.graph.is_zero_vector(&offset));
        if !self.motion.knows_position() && !is_center {
            return self.report(
                value.extent,
                "under `motion: rotation` the moment balance is written about G: the motion of G \
                 is not modeled",
            );
        }
        Some(point)
    }
}
