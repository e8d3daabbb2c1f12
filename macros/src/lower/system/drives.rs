//! What drives joints, and what acts between bodies.

use proc_macro2::Ident;

use crate::errors::{Errors, hint};
use crate::families::Family;
use crate::lower::expressions::Lowering;
use crate::model::{Dimension, Field, Frame, Load, Part, Point, TreeJoint, Variable, Vector};
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

/// `elbow`, or `gimbal.angle_1`: the joint, and its coordinate.
fn joint_named<'e>(
    target: &'e Expression,
    errors: &mut Errors,
) -> Option<(&'e Ident, Option<&'e Ident>)> {
    match &target.kind {
        Kind::Name(name) => return Some((name, None)),
        Kind::Field(inner, word) => {
            if let Kind::Name(name) = &inner.kind {
                return Some((name, Some(word)));
            }
        }
        _ => {}
    }
    errors.push(
        target.extent,
        "a drive acts on a joint, by its name, or on one of its coordinates",
    );
    None
}

fn is_ball(joint: &TreeJoint) -> bool {
    joint.kind.parts == [Part::Ball]
}

/// The coordinates of a joint, by the fields of its state.
fn coordinates(joint: &TreeJoint) -> impl Iterator<Item = &'static Field> {
    let fields = joint.kind.shape.into_iter().flat_map(|shape| shape.fields);
    fields.filter(|field| matches!(field.variable, Variable::Position | Variable::Angle))
}

/// The freedoms that a drive acts along: that of the coordinate which is named, or the only one; of a
/// ball joint all three.
fn chosen(
    joint: &TreeJoint,
    all: &[(Variable, usize)],
    word: Option<&Ident>,
    target: &Expression,
    errors: &mut Errors,
) -> Option<Vec<usize>> {
    let name = &joint.name;
    if all.is_empty() || joint.kind.is_free() {
        let place = joint_named(target, errors)?.0.span();
        let message = if all.is_empty() {
            format!("`{name}` does not move: there is nothing to drive")
        } else {
            format!(
                "nothing holds `{name}`: what acts on its body is a force or a moment in its braces"
            )
        };
        errors.push(place, message);
        return None;
    }
    let words: Vec<&str> = coordinates(joint).map(|field| field.path).collect();
    let Some(word) = word else {
        if all.len() == 1 || is_ball(joint) {
            return Some((0..all.len()).collect());
        }
        let words: Vec<String> = words.iter().map(|word| format!("{name}.{word}")).collect();
        let all = words.join(")` or `.on(");
        errors.push(
            target.extent,
            format!("along which coordinate? write `.on({all})`"),
        );
        return None;
    };
    let field = coordinates(joint).find(|field| *word == field.path);
    let rate = field.map(|field| match field.variable {
        Variable::Position => (Variable::Velocity, field.first),
        _ => (Variable::AngularVelocity, field.first),
    });
    let found = rate.and_then(|rate| all.iter().position(|one| *one == rate));
    if found.is_none() {
        let all = words.join("`, `");
        errors.push(
            word.span(),
            format!("a drive acts on a coordinate of `{name}`: `{all}`"),
        );
    }
    found.map(|found| vec![found])
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
        let (name, word) = joint_named(target, errors)?;
        self.check_joint(name, errors)?;
        let joint = joints.iter_mut().find(|joint| joint.name == *name)?;
        let all = freedoms(joint.kind.parts, self.system.is_planar);
        let chosen = chosen(joint, &all, word, target, errors)?;
        if matches!(load.kind, Kind::Placeholder) {
            return self.open(drive, load, joint, &chosen, errors);
        }
        let frame = joint.frames.last().copied()?;
        let is_ball = is_ball(joint);
        let parts = self.at_top(errors, |lowering| {
            if is_ball {
                let what = "the drive of a ball joint";
                let vector = lowering.vector(load, Dimension::MOMENT, what)?;
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

    /// Whether a drive names a joint that is known; `None` if that is reported.
    fn check_joint(&self, name: &Ident, errors: &mut Errors) -> Option<()> {
        let mut joints = self.members.joints.iter();
        if let Some(known) = joints.find(|joint| *name == joint.name.as_str()) {
            return known.is_known.then_some(());
        }
        if self.scope.is_lost(&name.to_string()) {
            return None;
        }
        let names = self.members.joints.iter().map(|joint| joint.name.as_str());
        let hint = hint(&name.to_string(), names);
        let message = if self.members.declared.contains(&name.to_string()) {
            format!("`{name}` is a body, and a drive acts on a joint")
        } else {
            format!("there is no joint `{name}`{hint}")
        };
        errors.push(name.span(), message);
        None
    }

    /// Leaves the load along a coordinate open, for inverse dynamics.
    fn open(
        &self,
        drive: &Definition,
        load: &Expression,
        joint: &mut TreeJoint,
        chosen: &[usize],
        errors: &mut Errors,
    ) -> Option<()> {
        if !self.is_inverse {
            errors.push(
                load.extent,
                "an unknown drive is for `outputs: [inverse]`: ask for that, or write a value",
            );
            return None;
        }
        if is_ball(joint) {
            errors.push(
                load.extent,
                "an open drive is on one coordinate, and a ball joint has three: prescribe its \
                 moments by inputs",
            );
            return None;
        }
        let open = &mut joint.open[*chosen.first()?];
        if let Some(other) = open {
            let message = format!("`{other}` is open on this coordinate already");
            errors.push(drive.name.span(), message);
            return None;
        }
        *open = Some(drive.name.clone());
        Some(())
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
