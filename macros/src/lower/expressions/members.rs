//! The meanings of names of bodies and joints in a system: `upper.tip`, `elbow.angle`.

use std::collections::HashSet;

use proc_macro2::Ident;

use crate::errors::{hint, name_meant};
use crate::model::{Frame, Vector};
use crate::syntax::{Expression, Kind};

use super::lowering::{Lowering, OfPoint};
use super::scope::Value;
use super::scope::{JointNames, Offset};

/// The most points that a message lists.
const LISTED: usize = 8;

impl Lowering<'_> {
    /// The value of an expression that begins with the name of a body or of a joint. The outer
    /// `None` stands for any other expression.
    #[allow(
        clippy::option_option,
        reason = "outer: another expression; inner: reported"
    )]
    pub fn of_member(&mut self, expression: &Expression) -> Option<Option<Value>> {
        let members = self.members;
        let is_own = |name: &Ident| !self.is_whole && self.scope.knows(&name.to_string());
        let (receiver, word, arguments) = match &expression.kind {
            Kind::Name(name) if members.has(&name.to_string()) && !is_own(name) => {
                // an ambiguous name is already reported
                if self.scope.is_lost(&name.to_string()) {
                    return Some(None);
                }
                let joint = members.joint(&name.to_string());
                if joint.is_some_and(|joint| joint.closes) {
                    return Some(self.report(name.span(), closes(name)));
                }
                let coordinate = joint.and_then(|joint| joint.values.first());
                let (word, form) = match (joint, coordinate) {
                    (None, _) => ("body", "position"),
                    (_, Some((form, _))) => ("joint", *form),
                    _ => ("joint", "angle"),
                };
                let message = format!(
                    "`{name}` is a {word}: name one of its quantities, such as `{name}.{form}`"
                );
                return Some(self.report(name.span(), message));
            }
            Kind::Field(receiver, word) => (receiver, word, None),
            Kind::Method(receiver, word, arguments) => (receiver, word, Some(arguments)),
            _ => return None,
        };
        let Kind::Name(name) = &receiver.kind else {
            return None;
        };
        if is_own(name) {
            return None;
        }
        let named = name.to_string();
        if let Some(body) = members.body(&named) {
            return Some(match arguments {
                Some(arguments) if word == "body" => {
                    self.vector_of_body(body, arguments, expression)
                }
                Some(_) => self.part_of_body(body, word).and_then(|_| {
                    let message = format!("write `{named}.{word}`, without parentheses");
                    self.report(word.span(), message)
                }),
                None => self.part_of_body(body, word),
            });
        }
        if named == self.scope.name && !members.has(&named) && self.scope.look_up(&named).is_none()
        {
            let message = if members.is_system() {
                format!("`{named}` is the whole system: write the name of a body or a joint")
            } else {
                format!("`{named}` is this body: leave `{named}.` out")
            };
            return Some(self.report(name.span(), message));
        }
        let Some(joint) = members.joint(&named) else {
            let is_missing = self.is_missing(&named);
            return is_missing.then(|| self.errors.undefined(name, &missing_member(name)));
        };
        Some(self.part_of_joint((name, joint), word, arguments.is_some()))
    }

    /// Whether a name in front of a point or a coordinate is that of a body or a joint which is not
    /// described.
    fn is_missing(&mut self, name: &str) -> bool {
        let members = self.members;
        let mut others = members
            .declared
            .iter()
            .chain(&members.late)
            .chain(&self.reactions);
        let is_known = others.any(|known| known == name)
            || name == "ground"
            || name.starts_with("r#")
            || self.scope.known().any(|known| known == name)
            || self.scope.look_up(name).is_some();
        members.is_system() && !is_known && members.hint(name, self.scope.known()).is_empty()
    }

    /// `elbow.angle`
    fn part_of_joint(
        &mut self,
        (name, joint): (&Ident, &JointNames),
        word: &Ident,
        is_called: bool,
    ) -> Option<Value> {
        if !self.members.are_moving {
            let message = format!(
                "this is fixed, and `{name}` moves: it cannot depend on how the system moves"
            );
            return self.report(name.span(), message);
        }
        let written = word.to_string();
        let found = joint.values.iter().find(|(name, _)| *name == written);
        if let (Some((_, value)), false) = (found, is_called) {
            return Some(*value);
        }
        let is_load = ["force", "moment"].contains(&written.as_str());
        if found.is_none() && is_load && !self.members.are_loaded {
            let message = format!(
                "a load does not follow that of a joint: write what `{name}` holds as a constraint, \
                 whose name then is its load"
            );
            return self.report(word.span(), message);
        }
        if joint.closes {
            return self.report(name.span(), closes(name));
        }
        if !joint.is_known {
            return None;
        }
        let message = match found {
            Some(_) => format!("write `{name}.{written}`, without parentheses"),
            None if joint.values.is_empty() => {
                format!("`{name}` does not move: it has no `{written}`")
            }
            None => {
                let words: Vec<&str> = joint.values.iter().map(|(name, _)| *name).collect();
                let hint = hint_of_name(&written, words.iter().copied());
                format!(
                    "the joint `{name}` has `{}`, and no `{written}`{hint}",
                    words.join("`, `")
                )
            }
        };
        self.report(word.span(), message)
    }

    /// `upper.body(x, y, z)`: a vector in the axes of a body.
    fn vector_of_body(
        &mut self,
        body: usize,
        arguments: &[Expression],
        expression: &Expression,
    ) -> Option<Value> {
        let (components, dimension) = self.component_list(arguments, expression.extent)?;
        let vector = self
            .work
            .vector(self.members.bodies[body].frame, components);
        Some(Value::Vector(vector, dimension))
    }

    /// `upper.tip`, `upper.G`, `upper.angular_velocity`
    fn part_of_body(&mut self, body: usize, word: &Ident) -> Option<Value> {
        let known = &self.members.bodies[body];
        let written = word.to_string();
        if written == "G" {
            return Some(Value::Carried(body, Vector::ZERO));
        }
        if let Some((_, value)) = known.values.iter().find(|(name, _)| *name == written) {
            return Some(*value);
        }
        if let Some((_, offset)) = known.points.iter().find(|(name, _)| *name == written) {
            self.members.used.borrow_mut().insert((body, written));
            return match offset {
                Offset::Known(offset) => Some(Value::Carried(body, *offset)),
                Offset::Late => {
                    let message = "this is fixed, and this point moves in its body: it cannot depend on how the system moves";
                    self.report(word.span(), message)
                }
                Offset::Reported => None,
            };
        }
        let of_state = [
            "position",
            "velocity",
            "acceleration",
            "attitude",
            "angular_velocity",
            "angular_acceleration",
            "mass",
        ];
        if written.starts_with("r#") {
            return self.errors.undefined(word, "");
        }
        let name = &known.name;
        let is_unknown = known.motion.is_none() && of_state.contains(&written.as_str());
        if is_unknown && self.members.are_moving {
            // why the motion of this body is unknown is already reported
            return None;
        }
        let message = if is_unknown {
            "this is fixed: it cannot depend on how the system moves".to_owned()
        } else if ["attitude", "angle", "rotation", "orientation"].contains(&written.as_str()) {
            let angle = self.members.with_joint("angle");
            let angle = angle.map_or(String::new(), |angle| format!(", such as `{angle}`"));
            let axis = if self.motion.is_planar {
                "1, 0"
            } else {
                "1, 0, 0"
            };
            format!(
                "the attitude of `{name}` follows from its joints: write their angles{angle}, or a direction of \
                 `{name}`, `{name}.body({axis}).in_world()`"
            )
        } else {
            let points = ["G"].into_iter();
            let points = points.chain(known.points.iter().map(|(name, _)| name.as_str()));
            let mut hint = hint_of_name(&written, points.clone().chain(of_state));
            if hint.is_empty() {
                let mut seen = HashSet::new();
                let points = points.filter(|point| seen.insert(*point));
                let all: Vec<&str> = points.take(LISTED).collect();
                hint = format!("; it has `{}`", all.join("`, `"));
            }
            format!("`{name}` has no point `{written}`{hint}")
        };
        self.report(word.span(), message)
    }

    /// `.position()`, `.velocity()` and `.acceleration()` of a point of a body of the system.
    pub fn carried_point(
        &mut self,
        body: usize,
        offset: Vector,
        method: &Ident,
        arguments: &[Expression],
    ) -> Option<Value> {
        let asked = self.of_point(method, arguments)?;
        let known = &self.members.bodies[body];
        let Some(motion) = known.motion else {
            if self.members.are_moving {
                return None;
            }
            return self.report(
                method.span(),
                "this is fixed: it cannot depend on how the system moves",
            );
        };
        let frame = known.frame;
        let (whole, part) = match asked {
            OfPoint::Position => (motion.position, offset),
            OfPoint::Velocity => {
                let swept = self.swept(offset, motion.angular_velocity, frame);
                (motion.velocity, swept)
            }
            OfPoint::Acceleration => {
                let turning = (motion.angular_velocity, motion.angular_acceleration);
                (motion.acceleration, self.thrown(offset, turning, frame))
            }
        };
        Some(Value::Vector(self.work.add(whole, part), asked.dimension()))
    }

    /// The body that `.in_body(upper)` names.
    pub fn named_body(&mut self, argument: &Expression) -> Option<Frame> {
        let Kind::Name(name) = &argument.kind else {
            return self.report(argument.extent, "expected the name of a body");
        };
        match self.members.body(&name.to_string()) {
            Some(body) => Some(self.members.bodies[body].frame),
            None if self.scope.is_lost(&name.to_string()) => None,
            None => {
                let hint = self.members.hint(&name.to_string(), core::iter::empty());
                self.report(name.span(), format!("there is no body `{name}`{hint}"))
            }
        }
    }
}

/// The end of the error for the name of a body or a joint that is not described.
pub fn missing_member(name: &Ident) -> String {
    format!(
        ": bodies belong in `bodies`, as `{name} {{ mass: 1[kg], .. }}`, and joints in `joints`"
    )
}

/// The end of a message about an unknown word: one of `known` that it means or resembles.
fn hint_of_name<'a>(word: &str, known: impl Iterator<Item = &'a str> + Clone) -> String {
    match name_meant(word).filter(|meant| known.clone().any(|known| known == *meant)) {
        Some(meant) => format!("; did you mean `{meant}`?"),
        None => hint(word, known),
    }
}

/// The error for using a coordinate of a joint that closes a loop.
fn closes(name: &Ident) -> String {
    format!(
        "`{name}` closes a loop: the state has no coordinates of it; write it before the other joint of \
         the body that it carries, which then closes the loop"
    )
}
