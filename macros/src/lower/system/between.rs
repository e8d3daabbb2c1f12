//! What acts between bodies: tensions along a line, and moments.

use crate::errors::Errors;
use crate::families::Family;
use crate::lower::expressions::Lowering;
use crate::model::{Dimension, Frame, Load, Point, Vector};
use crate::symbolic::{Components, Id};
use crate::syntax::{Definition, Expression, Kind};

use super::drives::behind;
use super::reader::Reader;

impl Reader<'_> {
    /// The loads between points and bodies, each with the number of the body that it acts on.
    pub fn loads_between(&mut self, errors: &mut Errors) -> Option<Vec<(usize, Load)>> {
        let mut loads = Some(Vec::new());
        let system = self.system;
        let tensions = system.forces.iter().map(|load| (load, true));
        let couples = system.moments.iter().map(|load| (load, false));
        for (load, is_force) in tensions.chain(couples) {
            let found = if is_force {
                self.tension(load, errors)
            } else {
                self.couple(load, errors)
            };
            match (found, &mut loads) {
                (Some(found), Some(all)) => all.extend(found),
                _ => loads = None,
            }
        }
        loads
    }

    /// `tension.between(P, Q)`: along the line PQ, positive if it pulls them together.
    fn tension(&mut self, load: &Definition, errors: &mut Errors) -> Option<Vec<(usize, Load)>> {
        let value = load.value.as_ref()?;
        let Some((tension, [p, q])) = behind(value, "between") else {
            errors.push(
                value.extent,
                "a force of a system acts between two points: write `tension.between(P, Q)`; what acts \
                 on one body stands in its braces",
            );
            return None;
        };
        let (start, end) = (self.anchor(p, errors), self.anchor(q, errors));
        let (start, end) = (start?, end?);
        if start.0 == end.0 {
            errors.push(
                q.extent,
                "a tension acts between two bodies, or a body and the ground",
            );
            return None;
        }
        let places = [start, end].map(|(body, offset)| match body {
            None => self.work.vector(Frame::WORLD, offset),
            Some(body) => {
                let known = &self.members.bodies[body];
                let position = known.motion.map_or(Vector::ZERO, |motion| motion.position);
                let offset = self.work.vector(known.frame, offset);
                self.work.add(position, offset)
            }
        });
        if [start.0, end.0]
            .into_iter()
            .flatten()
            .any(|body| self.members.bodies[body].motion.is_none())
        {
            return None;
        }
        let size = self.at_top(errors, |lowering| {
            lowering.scalar(tension, Dimension::FORCE, "a tension")
        })?;
        let pull = self.along(places, size, q, errors)?;
        let opposite = self.work.graph.negate_vector(pull);
        let ends =
            [(start, pull), (end, opposite)]
                .into_iter()
                .filter_map(|((body, offset), force)| {
                    let force = self.work.vector(Frame::WORLD, force);
                    let point = Point::Fixed(self.members.bodies[body?].frame, offset);
                    Some((body?, given(load, force, point, Vector::ZERO)))
                });
        Some(ends.collect())
    }

    /// A force of this size, from the first place towards the second, world axes.
    fn along(
        &mut self,
        [start, end]: [Vector; 2],
        size: Id,
        written: &Expression,
        errors: &mut Errors,
    ) -> Option<Components> {
        let back = self.work.negate(start);
        let line = self.work.add(end, back);
        let line = self.work.components(line, Frame::WORLD);
        let graph = &mut self.work.graph;
        let line = graph.quantities(line);
        if graph.is_zero_vector(&line) {
            errors.push(
                written.extent,
                "the ends of a tension are at the same place: it has no direction",
            );
            return None;
        }
        let length = graph.norm(line);
        let length = graph.quantity(length);
        let share = graph.divide(size, length);
        let share = graph.quantity(share);
        let pull = graph.scale_vector(share, line);
        Some(graph.quantities(pull))
    }

    /// `moment(v).on(body)` and `moment(v).between(first, second)`, which acts on the second, and on
    /// the first with the opposite sign.
    fn couple(&mut self, load: &Definition, errors: &mut Errors) -> Option<Vec<(usize, Load)>> {
        let value = load.value.as_ref()?;
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
            errors.push(
                value.extent,
                "a moment of a system is `moment(v).on(body)` or `moment(v).between(first, second)`",
            );
            return None;
        };
        let numbers: Vec<Option<usize>> = bodies
            .iter()
            .map(|body| self.body_number(body, errors))
            .collect();
        let is_planar = self.system.is_planar;
        let vector = self.at_top(errors, |lowering| read_moment(lowering, moment, is_planar));
        let numbers: Vec<usize> = numbers.into_iter().collect::<Option<_>>()?;
        if let ([first, second], [_, again]) = (numbers.as_slice(), bodies)
            && first == second
        {
            errors.push(
                again.extent,
                "a moment between two bodies, and both are one: it cancels",
            );
            return None;
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
        let name = super::joints::first_name_of(written)
            .map(ToString::to_string)
            .unwrap_or_default();
        if self.scope.is_lost(&name) {
            return None;
        }
        let bodies = self.members.bodies.iter().map(|body| body.name.as_str());
        let message = if name == "world" {
            "the ground does not move, and needs no moment: write `moment(v).on(body)`".to_owned()
        } else if self.members.joints.iter().any(|joint| joint.name == name) {
            format!(
                "`{name}` is a joint, and a moment acts on bodies: write `v.on({name})` in `drives`"
            )
        } else {
            format!(
                "expected the name of a body{}",
                self.members.hint(&name, bodies)
            )
        };
        errors.push(written.extent, message);
        None
    }
}

fn read_moment(
    lowering: &mut Lowering<'_>,
    written: &Expression,
    is_planar: bool,
) -> Option<Vector> {
    if !is_planar {
        return lowering.vector(written, Dimension::MOMENT, "a moment");
    }
    let size: Id = lowering.scalar(written, Dimension::MOMENT, "a moment")?;
    let zero = lowering.work.graph.zero();
    let components: Components = [zero, zero, size];
    Some(lowering.work.vector(Frame::WORLD, components))
}

fn given(written: &Definition, force: Vector, point: Point, moment: Vector) -> Load {
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
