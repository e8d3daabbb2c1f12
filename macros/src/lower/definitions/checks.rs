//! Checks: claims, and the states for which they are made.

use crate::errors::Extent;
use crate::families::LoadKind;
use crate::lower::expressions::{Lowering, Value};
use crate::model::{Answers, Check, Checks, Claim, Dimension, Frame, Meaning, Variable};
use crate::symbolic::{Comparison, Components, Function, Id, Node, Number, Stage};
use crate::syntax::{self, Description, Expression, Kind, Operator};

use super::names::check_distinct;

/// A quantity that can be given a value.
enum Target {
    Scalar(Id, Dimension),
    /// The symbols along the axes that exist; other axes have none.
    Vector(Frame, Components, Dimension),
    /// The quaternion of a frame, with its scalar part first.
    Attitude(Frame, [Id; 4]),
}

const TURNED: &str =
    "an attitude is given by an axis and an angle: write `turned(world(0, 0, 1), 30[deg])`";

impl Lowering<'_> {
    /// All checks. Quantities that the description does not define get symbols.
    pub fn checks(&mut self, description: &Description) -> Checks {
        let before = self.errors.count();
        check_distinct(
            "check",
            description.checks.iter().map(|check| &check.name),
            self.errors,
        );
        if description.checks.is_empty() {
            return Checks::default();
        }
        let answers = self.name_answers();
        let list = description.checks.iter();
        let list = list.filter_map(|check| self.check(check)).collect();
        Checks {
            list,
            mistakes: self.errors.count() - before,
            answers: Some(answers),
            held: Vec::new(),
        }
    }

    fn name_answers(&mut self) -> Answers {
        let energy = Dimension::MOMENT;
        let mut scalar = |name: &str| {
            let id = self.work.symbol(Stage::State, Meaning::Virtual);
            self.scope.define(name, Some(Value::Scalar(id, energy)));
            id
        };
        let [kinetic, potential] = ["kinetic_energy", "potential_energy"].map(&mut scalar);
        let whole = self.work.graph.add(kinetic, potential);
        self.scope
            .define("energy", Some(Value::Scalar(whole, energy)));
        let linear = Dimension::base([1, 1, -1, 0, 0, 0, 0]);
        let angular = Dimension::base([1, 2, -1, 0, 0, 0, 0]);
        let is_planar = self.motion.is_planar;
        let [linear_momentum, angular_momentum] = [LoadKind::Force, LoadKind::Moment].map(|kind| {
            let axes = kind.axes(is_planar);
            self.work.symbols(Stage::State, axes, |_| Meaning::Virtual)
        });
        let vector = self.work.vector(Frame::WORLD, linear_momentum);
        self.scope
            .define("linear_momentum", Some(Value::Vector(vector, linear)));
        let value = if is_planar {
            Value::Scalar(angular_momentum[2], angular)
        } else {
            Value::Vector(self.work.vector(Frame::WORLD, angular_momentum), angular)
        };
        self.scope.define("angular_momentum", Some(value));
        Answers {
            kinetic,
            potential,
            linear_momentum,
            angular_momentum,
        }
    }

    fn check(&mut self, written: &syntax::Check) -> Option<Check> {
        let claims = written.claims.iter().map(|claim| self.claim(claim));
        let claims: Vec<Option<Claim>> = claims.collect();
        let given = written.given.iter().map(|given| self.given(given));
        let given: Vec<_> = given.collect();
        let given: Vec<(Id, Id, Extent)> = given.into_iter().collect::<Option<Vec<_>>>()?.concat();
        for (number, (symbol, _, place)) in given.iter().enumerate() {
            if given[..number].iter().any(|(other, ..)| other == symbol) {
                return self.report(*place, "this is given already: leave one of them out");
            }
        }
        Some(Check {
            name: written.name.clone(),
            claims: claims.into_iter().collect::<Option<_>>()?,
            given,
        })
    }

    fn claim(&mut self, written: &syntax::Claim) -> Option<Claim> {
        let syntax::Claim { left, step, extent } = written;
        // it must be valid as a condition, too
        self.chain(left, core::slice::from_ref(step))?;
        let sides = [self.value(left)?, self.value(&step.operand)?];
        let [Value::Scalar(a, _), Value::Scalar(b, _)] = sides else {
            return None;
        };
        let (comparison, is_turned) = match step.operator {
            Operator::Less => (Comparison::Less, false),
            Operator::LessOrEqual => (Comparison::LessOrEqual, false),
            Operator::Greater => (Comparison::Less, true),
            Operator::GreaterOrEqual => (Comparison::LessOrEqual, true),
            Operator::Equal => (Comparison::Equal, false),
            _ => (Comparison::NotEqual, false),
        };
        Some(Claim {
            comparison,
            sides: if is_turned { [b, a] } else { [a, b] },
            is_turned,
            place: *extent,
        })
    }

    /// The symbols of a given quantity, and their values.
    fn given(&mut self, written: &syntax::Given) -> Option<Vec<(Id, Id, Extent)>> {
        let (target, value) = (self.target(&written.target)?, &written.value);
        let (place, what) = (written.target.extent, "what is given");
        match target {
            Target::Scalar(symbol, dimension) => {
                let value = self.scalar(value, dimension, what)?;
                Some(vec![(symbol, value, place)])
            }
            Target::Vector(frame, symbols, dimension) => {
                let vector = self.vector(value, dimension, what)?;
                let components = self.work.components(vector, frame);
                let pairs = symbols.into_iter().zip(components);
                let pairs = pairs.filter(|(symbol, _)| !self.work.graph.is_zero(*symbol));
                Some(
                    pairs
                        .map(|(symbol, value)| (symbol, value, place))
                        .collect(),
                )
            }
            Target::Attitude(frame, symbols) => {
                let quaternion = self.quaternion(value, frame)?;
                let pairs = symbols.into_iter().zip(quaternion);
                Some(
                    pairs
                        .map(|(symbol, value)| (symbol, value, place))
                        .collect(),
                )
            }
        }
    }

    /// `turned(axis, angle)`, as the quaternion of a frame.
    fn quaternion(&mut self, written: &Expression, frame: Frame) -> Option<[Id; 4]> {
        let (axis, angle) = match &written.kind {
            Kind::Call(word, arguments) if word == "turned" => match arguments.as_slice() {
                [axis, angle] => (axis, angle),
                _ => return self.report(written.extent, TURNED),
            },
            _ => return self.report(written.extent, TURNED),
        };
        let vector = self.vector(axis, Dimension::ANY, "an axis");
        let angle = self.scalar(angle, Dimension::NONE, "an angle");
        let (vector, angle) = (vector?, angle?);
        // the axis of a rotation has the same components in both frames
        let axes = [frame, self.work.carrier(frame)];
        let components = match *self.work.parts(vector) {
            [(from, components)] if axes.contains(&from) => components,
            [] => return self.report(axis.extent, "the axis of a turn is not zero"),
            _ => {
                let message = "write the axis of this turn in the axes of the body that turns, or of what \
                               carries it";
                return self.report(axis.extent, message);
            }
        };
        let graph = &mut self.work.graph;
        let half = graph.number(Number::ratio(1, 2));
        let half = graph.multiply(half, angle);
        let sine = graph.apply(Function::Sin, &[half]);
        let cosine = graph.apply(Function::Cos, &[half]);
        let norm = graph.norm(components);
        let size = graph.divide(sine, norm);
        let [x, y, z] = graph.scale_vector(size, components);
        Some([cosine, x, y, z])
    }

    fn target(&mut self, written: &Expression) -> Option<Target> {
        if let Some(target) = self.turning_target(written) {
            return Some(target);
        }
        let value = self.value(written)?;
        let is_symbol = |id: Id| matches!(self.work.graph.node(id), Node::Symbol(_));
        let is_free = |id: &Id| self.work.graph.is_zero(*id) || is_symbol(*id);
        let found = match value {
            Value::Scalar(id, dimension) if is_symbol(id) => Some(Target::Scalar(id, dimension)),
            Value::Components(frame, components, dimension) if components.iter().all(is_free) => {
                Some(Target::Vector(frame, components, dimension))
            }
            Value::Vector(vector, dimension) => match *self.work.parts(vector) {
                [(frame, components)] if components.iter().all(is_free) => {
                    Some(Target::Vector(frame, components, dimension))
                }
                _ => None,
            },
            _ => None,
        };
        let found = found.filter(|target| !self.is_answer(target));
        if found.is_none() {
            let message = "this follows from other quantities: inputs, params, `t` and what is in the state can be given";
            return self.report(written.extent, message);
        }
        found
    }

    /// Whether a quantity follows from the motion; such a quantity cannot be given.
    fn is_answer(&self, target: &Target) -> bool {
        let follows = |id: &Id| match self.work.meaning(*id) {
            Some(Meaning::Of(_, variable, _)) => variable.is_acceleration(),
            Some(Meaning::Virtual | Meaning::Reaction(..)) => true,
            _ => false,
        };
        match target {
            Target::Scalar(id, _) => follows(id),
            Target::Vector(_, components, _) => components.iter().any(follows),
            Target::Attitude(..) => false,
        }
    }

    /// The angle, the attitude or the angular velocity, by its name in a state.
    fn turning_target(&mut self, written: &Expression) -> Option<Target> {
        let frame = match &written.kind {
            Kind::Name(name) if !self.is_whole => {
                let word = name.to_string();
                if let Some((angle, rate)) = self.state.angle {
                    return match word.as_str() {
                        "angle" if !self.scope.knows("angle") => {
                            Some(Target::Scalar(angle, Dimension::NONE))
                        }
                        "angular_velocity" => Some(Target::Scalar(rate, Dimension::FREQUENCY)),
                        _ => None,
                    };
                }
                (word == "attitude").then_some(self.state.body)?
            }
            Kind::Field(receiver, word) if word == "attitude" => {
                let Kind::Name(name) = &receiver.kind else {
                    return None;
                };
                let joint = self.members.joint(&name.to_string())?;
                let mut values = joint.values.iter();
                let (_, rate) = values.find(|(name, _)| *name == "angular_velocity")?;
                let Value::Vector(rate, _) = rate else {
                    return None;
                };
                self.work.parts(*rate).first()?.0
            }
            _ => return None,
        };
        let symbols = [0, 1, 2, 3].map(|part| {
            let meaning = Meaning::Of(frame, Variable::Quaternion, part);
            self.work.symbol_of(meaning)
        });
        let [Some(w), Some(x), Some(y), Some(z)] = symbols else {
            return None;
        };
        Some(Target::Attitude(frame, [w, x, y, z]))
    }
}
