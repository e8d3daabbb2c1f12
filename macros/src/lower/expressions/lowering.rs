//! The context in which expressions are read, and conditions on values.
//!
//! Every method returns `None` if an error was reported, here or before. Nothing is reported twice.

use proc_macro2::Ident;

use crate::errors::{Errors, Extent};
use crate::model::{
    Composed, Defaults, Dimension, Doubtful, Drawn, Motion, State, Vector, Workspace, why_not,
};
use crate::symbolic::{Id, Number};
use crate::syntax::{Expression, Kind};

use super::scope::{Members, Scope, Value};
use super::written::{ONE_NUMBER, across_the_plane, axis_meant, short};

/// Messages that several places use.
pub const AXES: &str = "in which axes? write `body(..)` or `world(..)` in front of the parentheses";
pub const UNKNOWN: &str = "unknown components (`_`) stand alone in a reaction or a drive, or as `_ * direction`: write a \
     value here";

/// Which quantity of the motion of a point is requested.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum OfPoint {
    Position,
    Velocity,
    Acceleration,
}

impl OfPoint {
    pub fn dimension(self) -> Dimension {
        match self {
            Self::Position => Dimension::LENGTH,
            Self::Velocity => Dimension::VELOCITY,
            Self::Acceleration => Dimension::ACCELERATION,
        }
    }
}

/// Everything that an expression can see.
pub struct Lowering<'a> {
    pub work: &'a mut Workspace,
    pub scope: &'a mut Scope,
    pub errors: &'a mut Errors,
    pub motion: Motion,
    pub state: &'a mut State,
    /// The names of unknown reactions that loads may refer to, under constraints.
    pub reactions: Vec<String>,
    /// Whether there are constraints: then loads may depend on unknown reactions.
    pub is_constrained: bool,
    /// The drawing origin of a body composed of parts, once the parts are read.
    pub composed: Option<Composed>,
    /// Whether the body is composed.
    pub has_parts: bool,
    /// The drawing origin of any other body.
    pub drawn: Drawn,
    /// The bodies and joints of a system; empty for a single body.
    pub members: &'a Members,
    /// Whether the expression is outside the bodies of a system.
    pub is_whole: bool,
}

impl Lowering<'_> {
    pub fn report<T>(
        &mut self,
        place: impl Into<Extent>,
        message: impl core::fmt::Display,
    ) -> Option<T> {
        self.errors.report(place, message)
    }

    /// The motion in words, for messages. For a system: whether it is in the plane or in space.
    pub fn under(&self) -> String {
        if !self.members.is_system() {
            return format!("under `motion: {}`", self.motion.word);
        }
        let place = if self.motion.is_planar {
            "in the plane"
        } else {
            "in space"
        };
        place.to_owned()
    }

    /// A scalar that fits `dimension`.
    pub fn scalar(
        &mut self,
        expression: &Expression,
        dimension: Dimension,
        what: &str,
    ) -> Option<Id> {
        if let Kind::Tuple(parts) = &expression.kind {
            let count = parts.len();
            return self.report(
                expression.extent,
                format!("{what} is a scalar, and this has {count} components"),
            );
        }
        if let Some(vector) = across_the_plane(expression).filter(|_| self.motion.is_planar) {
            return self.report(vector.extent, format!("{what} {ONE_NUMBER}"));
        }
        let value = match &expression.kind {
            Kind::Name(name) if !self.members.has(&name.to_string()) => self.name(name, dimension),
            _ => self.value(expression),
        };
        match value? {
            Value::Scalar(id, found) if found.fits(dimension) => Some(id),
            Value::Scalar(_, found) => self.mismatch(expression, dimension, found, what),
            other => self.report(
                expression.extent,
                format!("{what} is a scalar, and this is {}", other.kind()),
            ),
        }
    }

    /// A vector that fits `dimension`.
    pub fn vector(
        &mut self,
        expression: &Expression,
        dimension: Dimension,
        what: &str,
    ) -> Option<Vector> {
        if let Kind::Tuple(_) = expression.kind {
            return self.report(expression.extent, AXES);
        }
        match self.value(expression)? {
            Value::Vector(vector, found) if found.fits(dimension) => Some(vector),
            Value::Components(frame, components, found) if found.fits(dimension) => {
                Some(self.work.vector(frame, components))
            }
            Value::Vector(_, found) | Value::Components(_, _, found) => {
                self.mismatch(expression, dimension, found, what)
            }
            Value::Scalar(_, found)
                if found == Dimension::MOMENT && dimension == Dimension::FORCE =>
            {
                self.report(
                    expression.extent,
                    format!(
                        "{what} is a vector, and this is a moment: moments belong in `moments`"
                    ),
                )
            }
            Value::Scalar(..) => {
                let text = short(expression);
                let axes = match text {
                    Some(_) if !self.is_whole && !self.motion.is_line() => "body",
                    _ => "world",
                };
                let zeros = if self.motion.is_planar { "0" } else { "0, 0" };
                let form = match text {
                    Some(text) => format!("{axes}({zeros}, {text})"),
                    None => format!("(..) * {axes}({zeros}, 1)"),
                };
                self.report(
                    expression.extent,
                    format!("{what} is a vector, and this is a scalar: write for example `{form}`"),
                )
            }
            other => self.report(
                expression.extent,
                format!("{what} is a vector, and this is {}", other.kind()),
            ),
        }
    }

    /// A direction of any length. If it is only the name of an axis, the error writes it out in
    /// these axes.
    pub fn direction_in(
        &mut self,
        axes: &str,
        expression: &Expression,
        dimension: Dimension,
    ) -> Option<Vector> {
        let names = expression.names();
        let is_known = names.iter().any(|name| self.scope.knows(&name.to_string()));
        match axis_meant(expression, self.motion.axes()) {
            Some(axis) if !is_known => {
                let message =
                    format!("a direction is a vector: write for example `{axes}({axis})`");
                self.report(expression.extent, message)
            }
            _ => self.vector(expression, dimension, "a direction"),
        }
    }

    /// Reports an expression without a value, at its word. If that depends on parameters, it is
    /// recorded for later.
    pub fn check_value(
        &mut self,
        word: &str,
        operands: &[Id],
        value: Id,
        place: Extent,
    ) -> Option<()> {
        let graph = &self.work.graph;
        if graph.is_undefined(value) {
            let numbers = operands.iter().map(|id| graph.as_number(*id).cloned());
            let why = numbers.collect::<Option<Vec<_>>>();
            let why = why.map_or_else(
                || format!("`{word}` has no value"),
                |all| why_not(word, &all),
            );
            return self.report(place, why);
        }
        if graph.is_early(value) && graph.as_number(value).is_none() {
            self.work.doubtful.push(Doubtful {
                word: word.to_owned(),
                operands: operands.to_vec(),
                value,
                place,
            });
        }
        Some(())
    }

    fn mismatch<T>(
        &mut self,
        expression: &Expression,
        expected: Dimension,
        found: Dimension,
        what: &str,
    ) -> Option<T> {
        let place = self.culprit(expression, expected);
        let is_weight = (expected, found) == (Dimension::FORCE, Dimension::ACCELERATION);
        let (expected, found) = (expected.described(), found.described());
        let mut message = format!("{what} is {expected}, and this is {found}");
        if is_weight {
            message += ": multiply it by a mass";
        }
        self.report(place, message)
    }

    /// The part of an otherwise correct expression that gives it a dimension other than `expected`.
    pub fn culprit(&mut self, expression: &Expression, expected: Dimension) -> Extent {
        let mut expression = expression;
        loop {
            expression = match &expression.kind {
                Kind::Unit(_, unit) => return unit.extent,
                Kind::Prefix(_, operand) => operand,
                // the values are the last argument that is not a word
                Kind::Call(word, parts) if word == "table" => {
                    let is_word = |part: &&Expression| matches!(part.kind, Kind::Name(_));
                    let values = parts.iter().rev().find(|part| !is_word(part));
                    return match values.map(|values| &values.kind) {
                        Some(Kind::Unit(_, unit)) => unit.extent,
                        _ => word.span().into(),
                    };
                }
                // a Rust function has its own unit, whatever its arguments are
                Kind::Call(word, _)
                    if matches!(self.scope.peek(&word.to_string()), Some(Value::Function(_))) =>
                {
                    return word.span().into();
                }
                Kind::Call(_, parts) | Kind::Tuple(parts) => {
                    let wrong = parts.iter().filter(|part| match self.value(part) {
                        Some(Value::Scalar(_, found)) => !found.fits(expected),
                        _ => false,
                    });
                    match wrong.collect::<Vec<_>>().as_slice() {
                        [part] => part,
                        _ => return expression.extent,
                    }
                }
                _ => return expression.extent,
            }
        }
    }

    /// The first name in `expression` whose value is not known before the body moves.
    pub fn late_name(&mut self, expression: &Expression) -> Extent {
        let late = |name: &&&proc_macro2::Ident| {
            let word = name.to_string();
            match self.scope.peek(&word) {
                Some(Value::Scalar(id, _)) => !self.work.graph.is_early(id),
                Some(Value::Components(_, components, _)) => {
                    !components.iter().all(|id| self.work.graph.is_early(*id))
                }
                Some(Value::Vector(vector, _)) => {
                    !self.work.graph.are_early(&self.work.entries(&[vector]))
                }
                Some(_) => false,
                None => Scope::is_changing(&word),
            }
        };
        let names = expression.names();
        let found = names.iter().find(late);
        found.map_or(expression.extent, |name| name.span().into())
    }

    /// Reports mass properties that depend on the motion or on inputs. Time and user-defined states
    /// are allowed.
    pub fn check_course(&mut self, written: &Expression, ids: &[Id], rule: &str) -> Option<()> {
        if !self.work.follows_motion(ids) {
            return Some(());
        }
        let mut place = written.extent;
        for name in written.names() {
            let word = name.to_string();
            let is_other = match self.scope.peek(&word) {
                Some(Value::Scalar(id, _)) => self.work.follows_motion(&[id]),
                Some(_) => false,
                None => word != "t" && Scope::is_changing(&word),
            };
            if is_other {
                place = name.span().into();
                break;
            }
        }
        self.report(
            place,
            format!("{rule}, or follows time and states of one's own: no input, and no part of the motion"),
        )
    }

    /// Reports fixed quantities that are not known before the body moves; `rule` gives the reason.
    pub fn check_early(&mut self, written: &Expression, ids: &[Id], rule: &str) -> Option<()> {
        if ids.iter().all(|id| self.work.graph.is_early(*id)) {
            return Some(());
        }
        let place = self.late_name(written);
        self.report(
            place,
            format!("{rule}: it cannot depend on the time, the state or an input"),
        )
    }

    /// The numerical values of expressions, with the defaults of parameters. `None` if any
    /// expression has no such value.
    pub fn all_known(&mut self, ids: &[Id], defaults: &Defaults) -> Option<Vec<Number>> {
        let graph = &mut self.work.graph;
        let known = graph.substitute(ids, |id| defaults.get(&id).copied());
        known
            .iter()
            .map(|id| graph.as_number(*id).cloned())
            .collect()
    }

    pub fn known(&mut self, id: Id, defaults: &Defaults) -> Option<Number> {
        match self.work.graph.as_number(id) {
            Some(number) => Some(number.clone()),
            None => self.all_known(&[id], defaults)?.pop(),
        }
    }

    /// The quantity of the motion of a point that a method requests.
    pub fn of_point(&mut self, method: &Ident, arguments: &[Expression]) -> Option<OfPoint> {
        let asked = match method.to_string().as_str() {
            "position" => OfPoint::Position,
            "velocity" => OfPoint::Velocity,
            "acceleration" => OfPoint::Acceleration,
            _ => {
                return self.report(
                    method.span(),
                    format!(
                        "a point has `.position()`, `.velocity()` and `.acceleration()`, and no \
                         `{method}`"
                    ),
                );
            }
        };
        self.expect_arguments(method, arguments, 0)?;
        Some(asked)
    }

    pub fn expect_arguments(
        &mut self,
        method: &Ident,
        arguments: &[Expression],
        count: usize,
    ) -> Option<()> {
        if arguments.len() == count {
            return Some(());
        }
        let expected = match count {
            0 => "no argument".to_owned(),
            1 => "one argument".to_owned(),
            _ => format!("{count} arguments"),
        };
        self.report(
            method.span(),
            format!(
                "`{method}` takes {expected}, and this has {}",
                arguments.len()
            ),
        )
    }
}

/// The dimension of a scalar or a vector.
pub fn dimension(value: Value) -> Option<Dimension> {
    match value {
        Value::Scalar(_, dimension)
        | Value::Vector(_, dimension)
        | Value::Components(_, _, dimension) => Some(dimension),
        _ => None,
    }
}
