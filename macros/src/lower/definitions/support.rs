//! Supports: `pivot(P)`, `fixed_point(P)`, `fixed_axis(P, direction)`, held at the world origin or
//! `.at(world(..))`.

use crate::lower::expressions::{Lowering, dimension};
use crate::model::{Defaults, Dimension, Frame, Support};
use crate::syntax::{self, Description, Expression, Kind};

impl Lowering<'_> {
    /// Reads the support that `motion` names, and lets it hold the body.
    pub fn support(&mut self, description: &Description, defaults: &Defaults) -> Option<()> {
        let motion = description.motion.as_ref()?;
        let word = motion.word.to_string();
        let found = self.read_support(motion.support.as_ref()?, &word, defaults);
        // the error is reported: some other support stands in, so that everything else is read
        let is_reported = found.is_none();
        let support = found.unwrap_or_else(|| self.any_support());
        self.state.hold(self.work, support);
        // no inertia is wrong because of it
        self.state.swings |= is_reported;
        Some(())
    }

    /// A support at the origin, about z.
    fn any_support(&mut self) -> Support {
        let graph = &mut self.work.graph;
        let zeros = graph.zeros();
        let direction = [graph.zero(), graph.zero(), graph.one()];
        Support {
            offset: zeros,
            anchor: zeros,
            direction: self.motion.has_written_axis().then_some(direction),
        }
    }

    fn read_support(
        &mut self,
        written: &syntax::Support,
        word: &str,
        defaults: &Defaults,
    ) -> Option<Support> {
        let (point, direction) = match (
            written.arguments.as_slice(),
            self.motion.has_written_axis(),
        ) {
            ([point, direction], true) => (point, Some(direction)),
            ([point], false) => (point, None),
            (arguments, has_axis) => {
                let (count, form) = if has_axis {
                    (2, "fixed_axis(P, body(0, 0, 1))`: a point of the body and the direction of the axis".to_owned())
                } else {
                    (1, format!("{word}(P)`: one point of the body"))
                };
                let excess = arguments
                    .get(count..)
                    .into_iter()
                    .flatten()
                    .flatten()
                    .next();
                let place = excess.map_or(written.extent, |argument| argument.extent);
                return self.report(place, format!("write `{form}"));
            }
        };
        let anchor = match &written.anchor {
            None => Some(self.work.graph.zeros()),
            Some(anchor) => anchor.as_ref().and_then(|anchor| self.anchor(anchor)),
        };
        let offset = point.as_ref().and_then(|point| self.held_point(point));
        let direction = match direction {
            None => Some(None),
            Some(direction) => direction
                .as_ref()
                .and_then(|direction| self.direction(direction, defaults))
                .map(Some),
        };
        Some(Support {
            offset: offset?,
            anchor: anchor?,
            direction: direction?,
        })
    }

    fn held_point(&mut self, written: &Expression) -> Option<crate::symbolic::Components> {
        self.body_point(written, |place| {
            format!(
                "a support holds a point of the body, and this one is {place}: name the point of \
                 the body, and where it is held as `.at(world(..))`"
            )
        })
    }

    fn anchor(&mut self, written: &Expression) -> Option<crate::symbolic::Components> {
        let position = self.point(written)?.offset(Frame::WORLD);
        position.or_else(|| {
            self.report(
                written.extent,
                "a support is held at a point in space: write `.at(world(..))`",
            )
        })
    }

    /// Reports a written unit. A direction has none, while a difference of points keeps the unit of
    /// the points.
    fn check_no_unit(&mut self, written: &Expression) -> Option<()> {
        let found = self.value(written).and_then(dimension)?;
        let mut unit = None;
        written.visit(|part| {
            if let Kind::Unit(_, own) = &part.kind {
                unit = unit.or(Some(own.extent));
            }
        });
        match unit {
            Some(unit) if !found.fits(Dimension::NONE) => {
                self.report(unit, "a direction has no unit: leave this out")
            }
            _ => Some(()),
        }
    }

    /// A unit vector along `written`. At angle zero, body and world axes agree, so it does not
    /// matter which are written. The direction of a rod is written in body axes.
    pub fn direction(
        &mut self,
        written: &Expression,
        defaults: &Defaults,
    ) -> Option<crate::symbolic::Components> {
        let (_, direction) = self.framed_direction(written, defaults)?;
        Some(direction)
    }

    /// The same, with the axes in which it is written.
    pub fn framed_direction(
        &mut self,
        written: &Expression,
        defaults: &Defaults,
    ) -> Option<(Frame, crate::symbolic::Components)> {
        let axes = if self.motion.is_line() {
            "body"
        } else {
            "world"
        };
        let vector = self.direction_in(axes, written, Dimension::ANY)?;
        self.check_no_unit(written)?;
        let (frame, components) = match *self.work.parts(vector) {
            [(Frame::WORLD, _)] if self.motion.is_line() => {
                return self.report(
                    written.extent,
                    "the axis of a rod has a direction in the body: write `body(..)`",
                );
            }
            [part] => part,
            [] => {
                return self.report(
                    written.extent,
                    "an axis has a direction, and this vector is zero",
                );
            }
            _ => {
                return self.report(
                    written.extent,
                    "write the direction of the axis in body axes alone, or in world axes alone",
                );
            }
        };
        let graph = &mut self.work.graph;
        if !graph.are_early(&components) {
            let place = self.late_name(written);
            return self.report(
                place,
                "the direction of an axis is fixed: it cannot depend on the time, the state or an input",
            );
        }
        let known = graph.substitute(&components, |id| defaults.get(&id).copied());
        if known.into_iter().all(|component| graph.is_zero(component)) {
            return self.report(
                written.extent,
                "an axis has a direction, and this vector is zero with the defaults of its parameters",
            );
        }
        let norm = graph.norm(components);
        let one = graph.one();
        let reciprocal = graph.divide(one, norm);
        Some((frame, graph.scale_vector(reciprocal, components)))
    }
}
