//! Points, and the components of points and vectors.

use crate::errors::{Extent, every, hint};
use crate::model::{Dimension, Drawn, Frame, FrameWord, Point};
use crate::symbolic::Components;
use crate::syntax::{Expression, Kind, key_meant};

use super::lowering::{Lowering, UNKNOWN};
use super::scope::Value;
use super::unit::lower_unit;
use super::written::written_frame;

impl Lowering<'_> {
    /// A point: a name; `(x, y, z)` in body axes, measured from G or, in a composition, from the
    /// drawing origin; or a vector that is fixed in its frame.
    pub fn point(&mut self, expression: &Expression) -> Option<Point> {
        if let Some((components, found)) = self.tuple(expression)? {
            return self.fixed_point(self.state.body, components, found, expression);
        }
        self.check_point_is_known(expression)?;
        match self.value(expression)? {
            Value::Point(point) => Some(point),
            Value::Components(frame, components, found) => {
                self.fixed_point(frame, components, found, expression)
            }
            Value::Vector(vector, found) => {
                let (frame, part) = match *self.work.parts(vector) {
                    [] => {
                        let word = written_frame(expression);
                        let frame = word.map(|word| self.state.frame(word));
                        (frame, self.work.graph.zeros())
                    }
                    [(frame, part)] => (Some(frame), part),
                    _ => {
                        return self.report(
                            expression.extent,
                            "a point is fixed in the body or in space: write its offset in body \
                             axes alone, or its position in world axes alone",
                        );
                    }
                };
                let graph = &self.work.graph;
                match frame {
                    None => self.report(
                        expression.extent,
                        "this is the zero vector, which points to G and to the origin alike: \
                         write `G` or `world(..)`",
                    ),
                    Some(Frame::WORLD) if self.motion.is_line() && !graph.is_early(part[0]) => self
                        .report(
                            expression.extent,
                            "a point of a rod is written with its coordinates in the body, `(x, y, \
                             z)`, or from another point, as `G + s * axis`",
                        ),
                    Some(frame) => self.fixed_point(frame, part, found, expression),
                }
            }
            Value::Carried(body, offset) if self.members.bodies[body].frame == self.state.body => {
                Some(if self.work.is_in(offset, self.state.body) {
                    Point::Fixed(self.state.body, self.work.part(offset, self.state.body))
                } else {
                    Point::Moving(offset)
                })
            }
            Value::Carried(..) => self.report(
                expression.extent,
                "this point is on another body: what is written in the braces of a body acts on that \
                 body alone",
            ),
            other => self.report(
                expression.extent,
                format!("expected a point, and this is {}", other.kind()),
            ),
        }
    }

    fn fixed_point(
        &mut self,
        frame: Frame,
        components: Components,
        found: Dimension,
        written: &Expression,
    ) -> Option<Point> {
        self.check_fixed(frame, &components, written)?;
        if !found.fits(Dimension::LENGTH) {
            let (place, found) = (self.culprit(written, Dimension::LENGTH), found.described());
            return self.report(place, format!("a point is in m, and this is {found}"));
        }
        let composed = self.composed.map(|composed| Drawn::From(composed.origin));
        let offset = match composed.unwrap_or(self.drawn) {
            Drawn::From(origin) if frame == self.state.body => {
                origin.offset(&mut self.work.graph, components)
            }
            Drawn::Lost if frame == self.state.body => return None,
            _ => components,
        };
        self.on_axis(Point::Fixed(frame, offset), written.extent)
    }

    /// Reports a point that moves in its frame: one written by its coordinates has to be fixed
    /// there.
    fn check_fixed(
        &mut self,
        frame: Frame,
        components: &Components,
        written: &Expression,
    ) -> Option<()> {
        if self.work.graph.are_early(components) {
            return Some(());
        }
        let moving = match frame {
            Frame::WORLD => "G + (world(..) - position)",
            _ => "G + body(..)",
        };
        let message = format!(
            "a point is fixed: it cannot depend on the time, the state or an input; a load may act at \
             `{moving}`, which moves"
        );
        let place = self.late_name(written);
        self.report(place, message)
    }

    /// The offset of a point of the body from G. Reports any other point as `what`.
    pub fn body_point(
        &mut self,
        written: &Expression,
        what: impl Fn(&str) -> String,
    ) -> Option<Components> {
        let point = self.point(written)?;
        let offset = point.offset(self.state.body);
        offset.or_else(|| self.report(written.extent, what(point.where_else())))
    }

    /// `(x, y, z)` or `body(x, y, z)`, with or without a unit. The inner `None` stands for anything
    /// else.
    #[allow(clippy::option_option, reason = "outer: reported; inner: not a tuple")]
    fn tuple(&mut self, expression: &Expression) -> Option<Option<(Components, Dimension)>> {
        match &expression.kind {
            Kind::Tuple(parts) => self.component_list(parts, expression.extent).map(Some),
            Kind::Call(word, parts) if word == "body" => {
                self.component_list(parts, expression.extent).map(Some)
            }
            Kind::Unit(inner, unit) if written_frame(inner) == Some(FrameWord::Body) => {
                let Some((components, found)) = self.tuple(inner)? else {
                    return Some(None);
                };
                let (factor, dimension) = lower_unit(unit, self.errors)?;
                self.check_unitless(found, unit.extent)?;
                let factor = self.work.graph.number(factor);
                Some(Some((
                    self.work.graph.scale_vector(factor, components),
                    dimension,
                )))
            }
            _ => Some(None),
        }
    }

    /// Checks that a vector has as many components as the motion has axes.
    pub fn check_count(&mut self, parts: &[Expression], extent: Extent) -> Option<()> {
        let axes = self.motion.axes();
        if parts.len() == axes {
            return Some(());
        }
        self.report(
            extent,
            format!(
                "a vector has {axes} components {}, and this has {}",
                self.under(),
                parts.len()
            ),
        )
    }

    /// Reports the name of a point that is not defined.
    fn check_point_is_known(&mut self, expression: &Expression) -> Option<()> {
        let Kind::Name(name) = &expression.kind else {
            return Some(());
        };
        let word = name.to_string();
        let is_known = self.is_whole
            || self.members.has(&word)
            || self.scope.look_up(&word).is_some()
            || self.scope.known().any(|known| known == word)
            || key_meant(&word).is_some()
            || !hint(&word, self.scope.known()).is_empty();
        if is_known {
            return Some(());
        }
        let place = if self.motion.is_planar {
            "(0.1, 0)"
        } else {
            "(0.1, 0, 0)"
        };
        let advice = format!("; declare it, as in `points: [{word} = {place}]`");
        self.errors.undefined(name, &advice)
    }

    /// The components of a vector: as many as the motion has axes, all of one dimension.
    pub fn component_list(
        &mut self,
        parts: &[Expression],
        extent: Extent,
    ) -> Option<(Components, Dimension)> {
        self.check_count(parts, extent)?;
        if let Some(unknown) = parts
            .iter()
            .find(|part| matches!(part.kind, Kind::Placeholder))
        {
            self.visit(parts);
            return self.report(unknown.extent, UNKNOWN);
        }
        let values = parts.iter().map(|part| match self.value(part)? {
            Value::Scalar(id, dimension) => Some((id, dimension)),
            other => self.report(
                part.extent,
                format!("a component is a scalar, and this is {}", other.kind()),
            ),
        });
        let values = every(values)?;
        let dimensions: Vec<Dimension> = values.iter().map(|(_, dimension)| *dimension).collect();
        if let Some((odd, other)) = odd_one_out(&dimensions) {
            let place = self.culprit(&parts[odd], other);
            let (found, other) = (dimensions[odd].described(), other.described());
            return self.report(
                place,
                format!(
                    "components of one vector have one dimension: this is {found}, and another \
                     is {other}"
                ),
            );
        }
        let unified = dimensions
            .into_iter()
            .try_fold(Dimension::ANY, Dimension::unify)?;
        let mut components = self.work.graph.zeros();
        for (component, (id, _)) in components.iter_mut().zip(values) {
            *component = id;
        }
        Some((components, unified))
    }
}

/// The dimension that disagrees with most of the others (in a tie, the last one), and one that it
/// disagrees with.
fn odd_one_out(dimensions: &[Dimension]) -> Option<(usize, Dimension)> {
    let strangers = |index: usize| {
        let own = dimensions[index];
        dimensions
            .iter()
            .copied()
            .filter(move |other| !own.fits(*other))
    };
    let odd = (0..dimensions.len()).max_by_key(|index| strangers(*index).count())?;
    Some((odd, strangers(odd).next()?))
}
