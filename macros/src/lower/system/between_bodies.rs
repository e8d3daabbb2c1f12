//! Loads between bodies: tensions along a line, cables, and moments.

use crate::errors::{Errors, every};
use crate::families::Family;
use crate::lower::expressions::{Lowering, missing_member};
use crate::model::{Dimension, Frame, Load, Point, Property, Tie, Vector};
use crate::symbolic::{Comparison, Components, Id, Number};
use crate::syntax::{Definition, Expression, Kind, call};

use super::joints::joint::End;
use super::load_methods::{behind, behind_operand, report_operand};
use super::reading::reader::Reader;
use super::ties::{LENGTH_OF_CABLE, STIFFNESS_OF_CABLE};

/// Loads, each with the index of its body.
type Loads = Vec<(usize, Load)>;

/// The loads between bodies.
#[derive(Default)]
pub struct Between {
    pub loads: Loads,
    /// The energies of cables.
    pub energies: Vec<Id>,
    pub cables: Vec<Tie>,
    pub properties: Vec<Property>,
}

impl Reader<'_> {
    /// The loads between points and bodies.
    pub fn loads_between(&mut self, errors: &mut Errors) -> Option<Between> {
        let (mut between, mut is_sound) = (Between::default(), true);
        let system = self.system;
        let tensions = system.forces.iter().map(|load| (load, true));
        let couples = system.moments.iter().map(|load| (load, false));
        for (load, is_force) in tensions.chain(couples) {
            let found = if is_force {
                self.tension(load, errors)
            } else {
                self.couple(load, errors)
            };
            is_sound &= found.is_some();
            between.loads.extend(found.unwrap_or_default());
        }
        for cable in &system.cables {
            is_sound &= self.cable(cable, &mut between, errors).is_some();
        }
        is_sound.then_some(between)
    }

    /// `tension.between(P, Q)`: a force along the line PQ, positive if it pulls the points
    /// together.
    fn tension(&mut self, load: &Definition, errors: &mut Errors) -> Option<Loads> {
        let value = load.value.as_ref()?;
        if let Some(word) = behind_operand(value, &["between"]) {
            return report_operand(word, errors);
        }
        let Some((tension, [p, q])) = behind(value, "between") else {
            return errors.report(
                value.extent,
                "a force of a system acts between two points: write `tension.between(P, Q)`; what acts \
                 on one body belongs in its braces",
            );
        };
        let ends = self.ends([p, q], "a tension", errors);
        let size = self.at_top(errors, |lowering| {
            lowering.scalar(tension, Dimension::FORCE, "a tension")
        });
        let (ends, line) = ends?;
        let size = size?;
        let graph = &mut self.work.graph;
        let length = graph.norm(line);
        let length = graph.quantity(length);
        let share = graph.divide(size, length);
        Some(self.pulls(load, ends, line, share))
    }

    /// `cable(P, Q, length, stiffness)`: the force, and its energy. The force is zero unless the
    /// line is longer than the cable, however short the line is.
    fn cable(&mut self, cable: &Definition, into: &mut Between, errors: &mut Errors) -> Option<()> {
        let value = cable.value.as_ref()?;
        let ((word, arguments), methods) = call(value)?;
        let form = "cable(P, Q, length, stiffness)";
        if let Some((method, _)) = methods.first() {
            return errors.report(method.span(), format!("nothing follows `{form}`"));
        }
        let [p, q, length, stiffness] = arguments else {
            let excess = arguments.get(4).map(|extra| extra.extent);
            let count = arguments.len();
            return errors.report(
                excess.unwrap_or(word.span().into()),
                format!("`{form}` takes 4 arguments, and this has {count}"),
            );
        };
        let ends = self.ends([p, q], "a cable", errors);
        let written = [(length, LENGTH_OF_CABLE), (stiffness, STIFFNESS_OF_CABLE)];
        let properties = written.map(|(value, sort)| self.property(cable, value, sort, errors));
        let [length, stiffness] = properties;
        let ((ends, line), properties) = (ends?, [length?, stiffness?]);
        let [length, stiffness] = properties.each_ref().map(|property| property.value);
        into.properties.extend(properties);
        let graph = &mut self.work.graph;
        let distance = graph.norm(line);
        let distance = graph.quantity(distance);
        let is_tight = graph.compare(Comparison::Less, length, distance);
        let stretch = graph.subtract(distance, length);
        let stretch = graph.quantity(stretch);
        let force = graph.multiply(stiffness, stretch);
        let half = graph.number(Number::ratio(1, 2));
        let energy = graph.multiply(force, stretch);
        let energy = graph.multiply(half, energy);
        let share = graph.divide(force, distance);
        let zero = graph.zero();
        let [energy, share] = [energy, share].map(|tight| graph.select(is_tight, tight, zero));
        let share = graph.quantity(share);
        for (id, what) in [(distance, "length"), (stretch, "stretch"), (share, "pull")] {
            self.work.labels.name(id, format!("{what}_{}", cable.name));
        }
        let system = self.system;
        let bodies = ends.map(|(body, _)| Some(system.bodies[body?].name.clone()));
        into.cables.push(Tie {
            name: cable.name.clone(),
            bodies,
        });
        into.energies.push(energy);
        into.loads.extend(self.pulls(cable, ends, line, share));
        Some(())
    }

    /// Two points of different bodies, or of a body and the ground, and the line between them in
    /// world axes.
    fn ends(
        &mut self,
        [p, q]: [&Expression; 2],
        what: &str,
        errors: &mut Errors,
    ) -> Option<([End; 2], Components)> {
        let (start, end) = (self.anchor(p, errors), self.anchor(q, errors));
        let (start, end) = (start?, end?);
        if start.0 == end.0 {
            let message = format!("{what} acts between two bodies, or a body and the ground");
            return errors.report(q.extent, message);
        }
        let [start_place, end_place] = [start, end].map(|end| self.place(end));
        let back = self.work.negate(start_place?);
        let line = self.work.add(end_place?, back);
        let line = self.work.components(line, Frame::WORLD);
        let line = self.work.graph.quantities(line);
        if self.work.graph.is_zero_vector(&line) {
            let message = format!("the ends of {what} are at the same place: it has no direction");
            return errors.report(q.extent, message);
        }
        Some(([start, end], line))
    }

    /// The place of a point; `None` if the motion of its body is unknown.
    fn place(&mut self, (body, offset): End) -> Option<Vector> {
        let Some(body) = body else {
            return Some(self.work.vector(Frame::WORLD, offset));
        };
        let known = &self.members.bodies[body];
        let position = known.motion?.position;
        let offset = self.work.vector(known.frame, offset);
        Some(self.work.add(position, offset))
    }

    /// A load along the line on its first end, and the opposite load on the other end.
    fn pulls(
        &mut self,
        load: &Definition,
        [start, end]: [End; 2],
        line: Components,
        share: Id,
    ) -> Loads {
        let graph = &mut self.work.graph;
        let share = graph.quantity(share);
        let pull = graph.scale_vector(share, line);
        let pull = graph.quantities(pull);
        let opposite = graph.negate_vector(pull);
        let mut loads = Vec::new();
        for ((body, offset), force) in [(start, pull), (end, opposite)] {
            if let Some(body) = body {
                let force = self.work.vector(Frame::WORLD, force);
                let point = Point::Fixed(self.members.bodies[body].frame, offset);
                loads.push((body, given(load, force, point, Vector::ZERO)));
            }
        }
        loads
    }

    /// `moment(v).on(body)` and `moment(v).between(first, second)`. The latter acts on the second
    /// body, and with the opposite sign on the first.
    fn couple(&mut self, load: &Definition, errors: &mut Errors) -> Option<Loads> {
        let value = load.value.as_ref()?;
        if let Some(word) = behind_operand(value, &["on", "between"]) {
            return report_operand(word, errors);
        }
        let on = behind(value, "on").filter(|(_, bodies)| bodies.len() == 1);
        let between = behind(value, "between").filter(|(_, bodies)| bodies.len() == 2);
        let written = on
            .or(between)
            .and_then(|(inner, bodies)| match &inner.kind {
                Kind::Call(word, arguments) if word == "moment" => match arguments.as_slice() {
                    [moment] => Some((moment, bodies)),
                    _ => None,
                },
                _ => None,
            });
        let Some((moment, bodies)) = written else {
            return errors.report(
                value.extent,
                "a moment of a system is `moment(v).on(body)` or `moment(v).between(first, second)`",
            );
        };
        let numbers = every(bodies.iter().map(|body| self.body_number(body, errors)));
        let is_planar = self.system.is_planar;
        let vector = self.at_top(errors, |lowering| {
            read_moment(lowering, moment, is_planar, "a moment")
        });
        let numbers = numbers?;
        if let ([first, second], [_, again]) = (numbers.as_slice(), bodies)
            && first == second
        {
            return errors.report(
                again.extent,
                "both bodies are the same, so the moment cancels",
            );
        }
        let vector = vector?;
        let zeros = self.work.graph.zeros();
        let center = |body: usize| Point::Fixed(self.members.bodies[body].frame, zeros);
        let opposite = self.work.negate(vector);
        Some(match *numbers.as_slice() {
            [first, second] => vec![
                (first, given(load, Vector::ZERO, center(first), opposite)),
                (second, given(load, Vector::ZERO, center(second), vector)),
            ],
            _ => vec![(
                numbers[0],
                given(load, Vector::ZERO, center(numbers[0]), vector),
            )],
        })
    }

    fn body_number(&self, written: &Expression, errors: &mut Errors) -> Option<usize> {
        if let Kind::Name(name) = &written.kind {
            let mut bodies = self.members.bodies.iter();
            if let Some(found) = bodies.position(|body| *name == body.name.as_str()) {
                return Some(found);
            }
        }
        let name = super::joints::joint::first_name_of(written)
            .map(ToString::to_string)
            .unwrap_or_default();
        if self.scope.is_lost(&name) {
            return None;
        }
        let bodies = self.members.bodies.iter().map(|body| body.name.as_str());
        let hint = self.members.hint(&name, bodies);
        let message = if name == "world" {
            "the ground does not move, and needs no moment: write `moment(v).on(body)`".to_owned()
        } else if self.members.joints.iter().any(|joint| joint.name == name) {
            format!(
                "`{name}` is a joint, and a moment acts on bodies: write `v.on({name})` in `drives`"
            )
        } else {
            if let (Kind::Name(name), true) = (&written.kind, hint.is_empty()) {
                return errors.undefined(name, &missing_member(name));
            }
            format!("expected the name of a body{hint}")
        };
        errors.report(written.extent, message)
    }
}

/// A moment; in the plane, a scalar.
pub fn read_moment(
    lowering: &mut Lowering<'_>,
    written: &Expression,
    is_planar: bool,
    what: &str,
) -> Option<Vector> {
    if !is_planar {
        return lowering.vector(written, Dimension::MOMENT, what);
    }
    let size: Id = lowering.scalar(written, Dimension::MOMENT, what)?;
    let zero = lowering.work.graph.zero();
    let components: Components = [zero, zero, size];
    Some(lowering.work.vector(Frame::WORLD, components))
}

/// A given load with the name of this definition.
pub fn given(written: &Definition, force: Vector, point: Point, moment: Vector) -> Load {
    Load {
        name: written.name.clone(),
        family: Family::Joint,
        force,
        point,
        moment,
        pull: None,
        potential: None,
        extent: written.name.span().into(),
        mention: None,
    }
}
