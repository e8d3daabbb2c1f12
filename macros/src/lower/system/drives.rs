//! What drives joints, and what acts between bodies.

use crate::errors::Errors;
use crate::families::Family;
use crate::lower::expressions::Lowering;
use crate::model::{Dimension, Frame, Load, Point, TreeJoint, Variable, Vector};
use crate::symbolic::{Components, Id};
use crate::syntax::{Definition, Expression, Kind};

use super::Reader;
use super::motion::freedoms;

/// `value.method(arguments)`
pub fn behind<'e>(
    value: &'e Expression,
    method: &str,
) -> Option<(&'e Expression, &'e [Expression])> {
    match &value.kind {
        Kind::Method(receiver, word, arguments) if word == method => Some((receiver, arguments)),
        _ => None,
    }
}

impl Reader<'_> {
    /// Puts the drives on the joints.
    pub fn drives(
        &mut self,
        mut joints: Vec<TreeJoint>,
        errors: &mut Errors,
    ) -> Option<Vec<TreeJoint>> {
        let mut is_sound = true;
        for drive in &self.system.drives {
            is_sound &= self.drive(drive, &mut joints, errors).is_some();
        }
        is_sound.then_some(joints)
    }

    fn drive(
        &mut self,
        drive: &Definition,
        joints: &mut [TreeJoint],
        errors: &mut Errors,
    ) -> Option<()> {
        let value = drive.value.as_ref()?;
        let Some((load, [target])) = behind(value, "on") else {
            let message = "a drive acts on a joint: write `torque.on(elbow)`";
            let place = match &value.kind {
                Kind::Method(_, word, arguments) if word != "on" && arguments.len() == 1 => {
                    word.span().into()
                }
                _ => value.extent,
            };
            errors.push(place, message);
            return None;
        };
        let (name, word) = match &target.kind {
            Kind::Name(name) => (name, None),
            Kind::Field(inner, word) => match &inner.kind {
                Kind::Name(name) => (name, Some(word)),
                _ => return self.refuse_target(target, errors),
            },
            _ => return self.refuse_target(target, errors),
        };
        let known = self
            .members
            .joints
            .iter()
            .find(|joint| *name == joint.name.as_str());
        let Some(known) = known else {
            if self.scope.is_lost(&name.to_string()) {
                return None;
            }
            let names = self.members.joints.iter().map(|joint| joint.name.as_str());
            let hint = crate::errors::hint(&name.to_string(), names);
            let message = if self.members.declared.contains(&name.to_string()) {
                format!("`{name}` is a body, and a drive acts on a joint")
            } else {
                format!("there is no joint `{name}`{hint}")
            };
            errors.push(name.span(), message);
            return None;
        };
        if !known.is_known {
            return None;
        }
        let joint = joints.iter_mut().find(|joint| joint.name == *name)?;
        let all = freedoms(joint.kind.parts, self.system.is_planar);
        if all.is_empty() || joint.kind.is_free() {
            let message = if all.is_empty() {
                format!("`{name}` does not move: there is nothing to drive")
            } else {
                format!(
                    "nothing holds `{name}`: what acts on its body is a force or a moment in its braces"
                )
            };
            errors.push(name.span(), message);
            return None;
        }
        let shape = joint.kind.shape?;
        let chosen: Vec<usize> = match word {
            None => (0..all.len()).collect(),
            Some(word) => {
                let mut fields = shape.fields.iter();
                let field =
                    fields.find(|field| *word == field.path && is_coordinate(field.variable));
                let rate = field.map(|field| match field.variable {
                    Variable::Position => (Variable::Velocity, field.first),
                    _ => (Variable::AngularVelocity, field.first),
                });
                let found = rate.and_then(|rate| all.iter().position(|one| *one == rate));
                let Some(found) = found else {
                    let words: Vec<&str> = shape
                        .fields
                        .iter()
                        .filter(|field| is_coordinate(field.variable))
                        .map(|field| field.path)
                        .collect();
                    let message = format!(
                        "a drive acts on a coordinate of `{name}`: `{}`",
                        words.join("`, `")
                    );
                    errors.push(word.span(), message);
                    return None;
                };
                vec![found]
            }
        };
        let is_ball = joint.kind.parts == [crate::model::Part::Ball];
        if chosen.len() > 1 && !is_ball {
            let fields = shape
                .fields
                .iter()
                .filter(|field| is_coordinate(field.variable));
            let words: Vec<String> = fields
                .map(|field| format!("{name}.{}", field.path))
                .collect();
            errors.push(
                target.extent,
                format!(
                    "along which coordinate? write `.on({})`",
                    words.join(")` or `.on(")
                ),
            );
            return None;
        }
        if matches!(load.kind, Kind::Placeholder) {
            if !self.is_inverse {
                errors.push(
                    load.extent,
                    "an unknown drive is for `outputs: [inverse]`: ask for that, or write a value",
                );
                return None;
            }
            if is_ball {
                errors.push(load.extent, "an open drive is on one coordinate, and a ball joint has three: prescribe its moments by inputs");
                return None;
            }
            let open = &mut joint.open[chosen[0]];
            if let Some(other) = open {
                let message = format!("`{other}` is open on this coordinate already");
                errors.push(drive.name.span(), message);
                return None;
            }
            *open = Some(drive.name.clone());
            return Some(());
        }
        let frame = joint.frames.last().copied()?;
        let parts = self.at_top(errors, |lowering| {
            if is_ball {
                let vector =
                    lowering.vector(load, Dimension::MOMENT, "the drive of a ball joint")?;
                return Some(lowering.work.components(vector, frame).to_vec());
            }
            let (expected, what) = match all[chosen[0]].0 {
                Variable::Velocity => (Dimension::FORCE, "the drive of a slide"),
                _ => (Dimension::MOMENT, "the drive of a hinge"),
            };
            Some(vec![lowering.scalar(load, expected, what)?])
        })?;
        for (freedom, part) in chosen.into_iter().zip(parts) {
            joint.drives[freedom] = self.work.graph.add(joint.drives[freedom], part);
        }
        Some(())
    }

    fn refuse_target(&self, target: &Expression, errors: &mut Errors) -> Option<()> {
        errors.push(
            target.extent,
            "a drive acts on a joint, by its name, or on one of its coordinates",
        );
        None
    }

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
        let back = self.work.negate(places[0]);
        let line = self.work.add(places[1], back);
        let line = self.work.components(line, Frame::WORLD);
        let line = self.work.graph.quantities(line);
        if self.work.graph.is_zero_vector(&line) {
            errors.push(
                q.extent,
                "the ends of a tension are at the same place: it has no direction",
            );
            return None;
        }
        let length = self.work.graph.norm(line);
        let length = self.work.graph.quantity(length);
        let share = self.work.graph.divide(size, length);
        let share = self.work.graph.quantity(share);
        let pull = self.work.graph.scale_vector(share, line);
        let pull = self.work.graph.quantities(pull);
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

fn is_coordinate(variable: Variable) -> bool {
    matches!(variable, Variable::Position | Variable::Angle)
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
