//! Loads with unknown components, `body(_, _, 0).at(P)` and `moment(body(_, _, 0))`, or along a
//! given direction, `_ * direction`. They are reactions, or drives that inverse dynamics solves
//! for.

use proc_macro2::Ident;

use crate::errors::every;
use crate::families::LoadKind;
use crate::lower::expressions::{
    Lowering, UNTURNED, Value, direction, is_unknown, lower_unit, of_gradient, placeholders,
};
use crate::model::{Dimension, Frame, Meaning, Point, Reaction, Vector};
use crate::symbolic::{Components, Id, Stage};
use crate::syntax::{self, Description, Expression, Kind, UnitExpression};

impl Lowering<'_> {
    /// A reaction with unknown components; `index` is its index among the reactions.
    pub fn reaction(&mut self, index: usize, written: &syntax::Load) -> Option<Reaction> {
        let point = self.point_of_reaction(written);
        let reaction = self.open_load(written, point, |_, _| Some(()))?;
        let axes = self.motion.axes_of(written.kind);
        let meaning = |axis| Meaning::Reaction(index, axis);
        let symbols = self.work.symbols(Stage::State, axes, meaning);
        Some(Reaction {
            symbols: self.work.vector(Frame::WORLD, symbols),
            ..reaction
        })
    }

    /// A drive with unknown components. For the accelerations, they are zero.
    pub fn drive(&mut self, written: &syntax::Load, is_asked_for: bool) -> Option<Reaction> {
        let value = written.vector.as_ref()?;
        let place = placeholders(value).next()?.1;
        if !is_asked_for {
            return self.report(
                place,
                "an unknown drive is solved for by `outputs: [inverse]`: ask for it, make this an input, \
                 or put it among `reactions` if a support makes it",
            );
        }
        let point = self.point_of_load(written);
        self.open_load(written, point, |lowering, known| {
            if lowering.work.graph.is_zero_vector(&known) {
                return Some(());
            }
            lowering.report(
                value.extent,
                "what is known of a drive is a load of its own: write 0 here",
            )
        })
    }

    /// A load with unknown components, if its known part is valid.
    fn open_load(
        &mut self,
        written: &syntax::Load,
        point: Option<Point>,
        check: impl Fn(&mut Self, Components) -> Option<()>,
    ) -> Option<Reaction> {
        let value = written.vector.as_ref()?;
        let along = match direction(value) {
            Some(direction) => Some(self.direction_in("world", direction, Dimension::NONE)?),
            None => None,
        };
        let (frame, known) = match along {
            Some(_) => (Frame::WORLD, self.work.graph.zeros()),
            None => self.known_part(value, written.kind)?,
        };
        check(self, known)?;
        let entries = self.work.entries(&[along.unwrap_or(Vector::ZERO)]);
        let parts = [&known[..], &entries].concat();
        self.check_no_acceleration(value, &parts, "a load with unknown components")?;
        // in the plane, a moment has one component, about the normal
        let first = self.motion.axes_of(written.kind).start;
        let unknown = placeholders(value);
        Some(Reaction {
            name: written.name.clone(),
            kind: written.kind,
            point: point?,
            frame,
            known,
            unknown: unknown.map(|(axis, place)| (first + axis, place)).collect(),
            along,
            gradient_of: direction(value).and_then(of_gradient),
            symbols: Vector::ZERO,
        })
    }

    /// The point of action of a reaction. Unless there are constraints, it must be a point of the
    /// body.
    fn point_of_reaction(&mut self, written: &syntax::Load) -> Option<Point> {
        let value = written.vector.as_ref()?;
        if written.kind == LoadKind::Force && !self.motion.knows_position() {
            let place = placeholders(value).next()?.1;
            return self.report(
                place,
                "an unknown force follows from the motion of G, which is not modeled under \
                 `motion: rotation`: hold a point by `motion: fixed_point(P)`",
            );
        }
        match (self.point_of_load(written)?, &written.point) {
            (Point::Fixed(Frame::WORLD, _), Some(Some(point))) if !self.is_constrained => self.report(
                point.extent,
                "an unknown reaction acts at a point of the body, and this one is fixed in space",
            ),
            (point, _) => Some(point),
        }
    }

    /// The components that are known, and their axes.
    fn known_part(&mut self, value: &Expression, kind: LoadKind) -> Option<(Frame, Components)> {
        let expected = if kind == LoadKind::Force {
            Dimension::FORCE
        } else {
            Dimension::MOMENT
        };
        let (inner, unit) = match &value.kind {
            Kind::Unit(inner, unit) => (&**inner, Some(unit)),
            _ => (value, None),
        };
        let factor = match unit {
            None => self.work.graph.one(),
            Some(unit) => self.unit_of_reaction(unit, expected)?,
        };
        let zeros = self.work.graph.zeros();
        let components = self.motion.axes_of(kind).len();
        let Kind::Call(word, parts) = &inner.kind else {
            return if components == 1 {
                Some((self.state.body, zeros))
            } else {
                self.report(
                    inner.extent,
                    "in which axes is it unknown? write `body(_, _, _)` or `world(_, _, _)`",
                )
            };
        };
        let frame = self.frame_of_reaction(word)?;
        if parts.len() != components || components == 1 {
            let form = match components {
                1 => "a moment is one scalar",
                2 => "a vector has two components",
                _ => "a vector has three components",
            };
            return self.report(
                inner.extent,
                format!("{form} under `motion: {}`", self.motion.word),
            );
        }
        let of_component = unit.map_or(expected, |_| Dimension::NONE);
        let known = parts.iter().map(|part| match part.kind {
            Kind::Placeholder => Some(zeros[0]),
            _ => self.scalar(part, of_component, "a component"),
        });
        let mut components = zeros;
        for (component, known) in components.iter_mut().zip(every(known)?) {
            *component = self.work.graph.multiply(factor, known);
        }
        Some((frame, components))
    }

    fn unit_of_reaction(&mut self, unit: &UnitExpression, expected: Dimension) -> Option<Id> {
        let (factor, found) = lower_unit(unit, self.errors)?;
        if !found.fits(expected) {
            let (expected, found) = (expected.described(), found.described());
            return self.report(
                unit.extent,
                format!("a reaction is {expected}, and this is {found}"),
            );
        }
        Some(self.work.graph.number(factor))
    }

    fn frame_of_reaction(&mut self, word: &Ident) -> Option<Frame> {
        if word != "body" {
            return Some(Frame::WORLD);
        }
        if self.motion.is_line() {
            return self.report(
                word.span(),
                format!("{UNTURNED}: write `world(_, _, _)`, or `_ * axis` along it"),
            );
        }
        Some(self.state.body)
    }

    /// Defines the names of unknown reactions: under constraints, loads such as friction may depend
    /// on them.
    pub fn name_reactions(&mut self, description: &Description, reactions: &[Option<Reaction>]) {
        if !self.is_constrained {
            return;
        }
        let unknown = description.loads.iter().filter(|load| is_unknown(load));
        for (written, reaction) in unknown.zip(reactions) {
            let name = written.name.to_string();
            let Some(reaction) = reaction else {
                self.scope.define(&name, None);
                continue;
            };
            let symbols = reaction.symbols;
            let value = match reaction.kind {
                LoadKind::Force => Value::Vector(symbols, Dimension::FORCE),
                LoadKind::Moment if self.motion.is_planar => {
                    let about_normal = self.work.part(symbols, Frame::WORLD)[2];
                    Value::Scalar(about_normal, Dimension::MOMENT)
                }
                LoadKind::Moment => Value::Vector(symbols, Dimension::MOMENT),
            };
            self.scope.define(&name, Some(value));
        }
    }
}
