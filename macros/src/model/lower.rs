//! Expressions: from what was written to the graph, with frames and dimensions checked.
//!
//! Every method returns `None` for what was reported, here or before; nothing is reported twice.

use proc_macro2::Ident;

use crate::errors::{Errors, Extent};
use crate::symbolic::{Comparison, Id, Number};
use crate::syntax::{Expression, Kind, Operator, Prefix};

use super::dimension::Dimension;
use super::frame::{Frame, Frames, Vector};
use super::motion::{Motion, State};
use super::scope::Scope;
use super::unit::lower_unit;
use super::value::{Point, Value};

/// All that an expression can see.
pub struct Lowering<'a> {
    pub frames: &'a mut Frames,
    pub scope: &'a mut Scope,
    pub errors: &'a mut Errors,
    pub motion: Motion,
    pub state: &'a State,
}

impl Lowering<'_> {
    pub fn report<T>(
        &mut self,
        place: impl Into<Extent>,
        message: impl core::fmt::Display,
    ) -> Option<T> {
        self.errors.push(place, message);
        None
    }

    /// A scalar that fits `dimension`.
    pub fn scalar(
        &mut self,
        expression: &Expression,
        dimension: Dimension,
        what: &str,
    ) -> Option<Id> {
        match self.value(expression)? {
            Value::Scalar(id, found) if found.fits(dimension) => Some(id),
            Value::Scalar(_, found) => self.report(
                expression.extent,
                format!("{what} is in {dimension}, and this is in {found}"),
            ),
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
            return self.report(
                expression.extent,
                "in which axes? write `body(..)` or `world(..)` in front of the parentheses",
            );
        }
        match self.value(expression)? {
            Value::Vector(vector, found) if found.fits(dimension) => Some(vector),
            Value::Components(frame, components, found) if found.fits(dimension) => {
                Some(self.frames.vector(frame, components))
            }
            Value::Vector(_, found) | Value::Components(_, _, found) => self.report(
                expression.extent,
                format!("{what} is in {dimension}, and this is in {found}"),
            ),
            Value::Scalar(..) => {
                let zeros = if self.motion.is_planar() {
                    "world(0, 0)"
                } else {
                    "world(0, 0, 0)"
                };
                self.report(expression.extent, format!("{what} is a vector, and this is a scalar: write `body(..)` or `{zeros}` with components"))
            }
            other => self.report(
                expression.extent,
                format!("{what} is a vector, and this is {}", other.kind()),
            ),
        }
    }

    /// A point: a name, `(x, y, z)` from G in body axes, or a vector that is fixed in its frame.
    pub fn point(&mut self, expression: &Expression) -> Option<Point> {
        if let Some((components, found)) = self.tuple(expression)? {
            return self.fixed_point(Point::Body(components), found, expression.extent);
        }
        match self.value(expression)? {
            Value::Point(point) => Some(point),
            Value::Components(Frame::Body, components, found) => {
                self.fixed_point(Point::Body(components), found, expression.extent)
            }
            Value::Components(Frame::World, components, found) => {
                self.fixed_point(Point::World(components), found, expression.extent)
            }
            Value::Vector(vector, found) => {
                let graph = &self.frames.graph;
                match (graph.is_zero_vector(&vector.body), graph.is_zero_vector(&vector.world)) {
                    (true, _) => self.fixed_point(Point::World(vector.world), found, expression.extent),
                    (_, true) => self.fixed_point(Point::Body(vector.body), found, expression.extent),
                    _ => self.report(expression.extent, "a point is fixed in the body or in space: write its offset in body axes alone, or its position in world axes alone"),
                }
            }
            other => self.report(
                expression.extent,
                format!("expected a point, and this is {}", other.kind()),
            ),
        }
    }

    fn fixed_point(&mut self, point: Point, found: Dimension, extent: Extent) -> Option<Point> {
        if !found.fits(Dimension::LENGTH) {
            return self.report(extent, format!("a point is in m, and this is in {found}"));
        }
        let (Point::Body(components) | Point::World(components)) = point;
        if components
            .iter()
            .any(|component| !self.frames.graph.is_early(*component))
        {
            return self.report(
                extent,
                "a point is fixed: it cannot depend on the time, the state or an input",
            );
        }
        Some(point)
    }

    /// `(x, y, z)` and `(x, y, z)[unit]`; the inner `None` is anything else.
    #[allow(clippy::option_option, reason = "outer: reported; inner: not a tuple")]
    fn tuple(
        &mut self,
        expression: &Expression,
    ) -> Option<Option<(crate::symbolic::Components, Dimension)>> {
        match &expression.kind {
            Kind::Tuple(parts) => self.component_list(parts, expression.extent).map(Some),
            Kind::Unit(inner, unit) if matches!(inner.kind, Kind::Tuple(_)) => {
                let (components, found) = self.tuple(inner)??;
                let (factor, dimension) = lower_unit(unit, self.errors)?;
                self.check_unitless(found, unit.extent)?;
                let factor = self.frames.graph.number(factor);
                Some(Some((
                    self.frames.graph.scale_vector(factor, components),
                    dimension,
                )))
            }
            _ => Some(None),
        }
    }

    /// The components of a vector: as many as the motion has axes, all of one dimension.
    pub fn component_list(
        &mut self,
        parts: &[Expression],
        extent: Extent,
    ) -> Option<(crate::symbolic::Components, Dimension)> {
        let axes = self.motion.axes();
        if parts.len() != axes {
            return self.report(
                extent,
                format!(
                    "a vector has {axes} components under `motion: {}`, and this has {}",
                    self.motion.word(),
                    parts.len()
                ),
            );
        }
        let values: Vec<Option<(Id, Dimension)>> = parts
            .iter()
            .map(|part| match self.value(part)? {
                Value::Scalar(id, dimension) => Some((id, dimension)),
                other => self.report(
                    part.extent,
                    format!("a component is a scalar, and this is {}", other.kind()),
                ),
            })
            .collect();
        let mut dimension = Dimension::ANY;
        let mut components = self.frames.graph.zeros();
        for (i, value) in values.into_iter().enumerate() {
            let (id, found) = value?;
            let Some(unified) = dimension.unify(found) else {
                return self.report(parts[i].extent, format!("components of one vector have one dimension: this is in {found}, those before in {dimension}"));
            };
            dimension = unified;
            components[i] = id;
        }
        Some((components, dimension))
    }

    pub fn value(&mut self, expression: &Expression) -> Option<Value> {
        let extent = expression.extent;
        let value = match &expression.kind {
            Kind::Number(digits) => self.number(digits, extent),
            Kind::Name(name) => self.name(name),
            Kind::Placeholder => self.report(extent, "unknown loads (`_`) are part of the language, but this version does not have them yet: write a value"),
            Kind::Tuple(_) => self.report(extent, "in which axes? write `body(..)` or `world(..)` in front of the parentheses"),
            Kind::Unit(operand, unit) => self.unit(operand, unit),
            Kind::Prefix(prefix, operand) => self.prefix(*prefix, operand),
            Kind::Chain(first, rest) => self.chain(first, rest),
            Kind::Call(function, arguments) => self.call(function, arguments, extent),
            Kind::Method(receiver, method, arguments) => {
                let receiver_value = self.value(receiver);
                self.method(receiver_value?, receiver, method, arguments)
            }
            Kind::Field(receiver, field) => self.field(receiver, field),
            Kind::Record(name, _) => self.report(extent, format!("`{name} {{ .. }}` is an inertia: it stands behind `inertia:`")),
            Kind::If(parts) => self.choice(parts),
        }?;
        let undefined = |id: &Id| self.frames.graph.is_undefined(*id);
        let is_undefined = match &value {
            Value::Scalar(id, _) | Value::Condition(id) => undefined(id),
            Value::Components(_, components, _) => components.iter().any(undefined),
            Value::Vector(vector, _) => vector.body.iter().chain(&vector.world).any(undefined),
            Value::Point(_) | Value::Attitude => false,
        };
        if is_undefined {
            return self.report(extent, "this has no value: a division by zero, a function outside its domain, or a number without bounds");
        }
        Some(value)
    }

    fn number(&mut self, digits: &str, extent: Extent) -> Option<Value> {
        match Number::parse(digits) {
            Some(number) if number.fits_f64() => Some(Value::Scalar(
                self.frames.graph.number(number),
                Dimension::ANY,
            )),
            _ => self.report(
                extent,
                format!(
                    "`{digits}` is out of the range of `f64`, which is about 5e-324 to 1.8e308"
                ),
            ),
        }
    }

    fn name(&mut self, name: &Ident) -> Option<Value> {
        let word = name.to_string();
        if let Some(value) = self.scope.look_up(&word) {
            return value;
        }
        let graph = &mut self.frames.graph;
        match word.as_str() {
            "t" => Some(Value::Scalar(self.state.time, Dimension::TIME)),
            "PI" => Some(Value::Scalar(graph.number(Number::pi()), Dimension::NONE)),
            "TAU" => Some(Value::Scalar(
                graph.number(Number::pi() * Number::integer(2)),
                Dimension::NONE,
            )),
            "G" => Some(Value::Point(Point::Body(graph.zeros()))),
            "position" | "velocity" => self.motion_of_center(name),
            "attitude" if !self.motion.has_attitude() => self.absent(name, "an attitude"),
            "attitude" => match self.frames.attitude {
                super::frame::Attitude::Angle(angle) => Some(Value::Scalar(angle, Dimension::NONE)),
                _ => Some(Value::Attitude),
            },
            "angular_velocity" if !self.motion.has_attitude() => {
                self.absent(name, "an angular velocity")
            }
            "angular_velocity" if self.motion.is_planar() => Some(Value::Scalar(
                self.state.angular_velocity[2],
                Dimension::FREQUENCY,
            )),
            "angular_velocity" => {
                let vector = self.frames.vector(Frame::Body, self.state.angular_velocity);
                Some(Value::Vector(vector, Dimension::FREQUENCY))
            }
            "mass" => self.report(name.span(), "this body has no mass: write `mass: ..`"),
            "body" | "world" => self.report(
                name.span(),
                format!("`{word}` makes a vector: write `{word}(..)` with components"),
            ),
            _ => {
                let hint = self.scope.hint(&word);
                self.report(
                    name.span(),
                    format!("nothing here is called `{word}`{hint}"),
                )
            }
        }
    }

    fn absent(&mut self, name: &Ident, what: &str) -> Option<Value> {
        self.report(
            name.span(),
            format!(
                "under `motion: {}` a body has not {what}",
                self.motion.word()
            ),
        )
    }

    fn motion_of_center(&mut self, name: &Ident) -> Option<Value> {
        if !self.motion.has_position() {
            return self.report(name.span(), format!("`{name}` is not known under `motion: rotation`: the motion of G is not modelled"));
        }
        let (components, dimension) = if name == "position" {
            (self.state.position, Dimension::LENGTH)
        } else {
            (self.state.velocity, Dimension::VELOCITY)
        };
        Some(Value::Vector(
            self.frames.vector(Frame::World, components),
            dimension,
        ))
    }

    fn check_unitless(&mut self, found: Dimension, place: Extent) -> Option<()> {
        if found.is_known() {
            return self.report(place, format!("this has a unit already: it is in {found}"));
        }
        Some(())
    }

    fn unit(
        &mut self,
        operand: &Expression,
        unit: &crate::syntax::UnitExpression,
    ) -> Option<Value> {
        let value = self.value(operand);
        let (factor, dimension) = lower_unit(unit, self.errors)?;
        let factor = self.frames.graph.number(factor);
        match value? {
            Value::Scalar(id, found) => {
                self.check_unitless(found, unit.extent)?;
                Some(Value::Scalar(
                    self.frames.graph.multiply(factor, id),
                    dimension,
                ))
            }
            Value::Vector(vector, found) => {
                self.check_unitless(found, unit.extent)?;
                Some(Value::Vector(self.frames.scale(factor, vector), dimension))
            }
            Value::Components(frame, components, found) => {
                self.check_unitless(found, unit.extent)?;
                Some(Value::Components(
                    frame,
                    self.frames.graph.scale_vector(factor, components),
                    dimension,
                ))
            }
            other => self.report(unit.extent, format!("{} has no unit", other.kind())),
        }
    }

    fn prefix(&mut self, prefix: Prefix, operand: &Expression) -> Option<Value> {
        match (prefix, self.value(operand)?) {
            (Prefix::Minus, Value::Scalar(id, dimension)) => {
                Some(Value::Scalar(self.frames.graph.negate(id), dimension))
            }
            (Prefix::Minus, Value::Vector(vector, dimension)) => {
                Some(Value::Vector(self.frames.negate(vector), dimension))
            }
            (Prefix::Minus, Value::Components(frame, components, dimension)) => {
                Some(Value::Components(
                    frame,
                    self.frames.graph.negate_vector(components),
                    dimension,
                ))
            }
            (Prefix::Not, Value::Condition(id)) => {
                Some(Value::Condition(self.frames.graph.not(id)))
            }
            (Prefix::Not, other) => self.report(
                operand.extent,
                format!("`!` negates a condition, and this is {}", other.kind()),
            ),
            (Prefix::Minus, other) => self.report(
                operand.extent,
                format!(
                    "`-` stands before a scalar or a vector, and this is {}",
                    other.kind()
                ),
            ),
        }
    }

    fn chain(&mut self, first: &Expression, rest: &[(Operator, Expression)]) -> Option<Value> {
        let mut value = self.value(first);
        let mut so_far = first.extent;
        for (operator, operand) in rest {
            let right = self.value(operand);
            value = match (value, right) {
                (Some(left), Some(right)) => {
                    self.operation(*operator, left, right, so_far, operand)
                }
                _ => None,
            };
            so_far = so_far.to(operand.extent);
        }
        value
    }

    fn operation(
        &mut self,
        operator: Operator,
        left: Value,
        right: Value,
        place: Extent,
        operand: &Expression,
    ) -> Option<Value> {
        match operator {
            Operator::Add | Operator::Subtract => self.sum(operator, left, right, place, operand),
            Operator::Multiply => self.product(left, right, operand.extent),
            Operator::Divide => self.quotient(left, right, operand.extent),
            Operator::And | Operator::Or => match (left, right) {
                (Value::Condition(a), Value::Condition(b)) => {
                    let graph = &mut self.frames.graph;
                    Some(Value::Condition(if operator == Operator::And {
                        graph.and(a, b)
                    } else {
                        graph.or(a, b)
                    }))
                }
                (Value::Condition(_), other) => self.report(
                    operand.extent,
                    format!("expected a condition, and this is {}", other.kind()),
                ),
                (other, _) => self.report(
                    place,
                    format!("expected a condition, and this is {}", other.kind()),
                ),
            },
            _ => self.comparison(operator, left, right, operand.extent),
        }
    }

    fn sum(
        &mut self,
        operator: Operator,
        left: Value,
        right: Value,
        place: Extent,
        operand: &Expression,
    ) -> Option<Value> {
        let verb = if operator == Operator::Add {
            "added to"
        } else {
            "subtracted from"
        };
        let (Some(a), Some(b)) = (dimension(left), dimension(right)) else {
            let (wrong, place) = if dimension(left).is_none() {
                (left, place)
            } else {
                (right, operand.extent)
            };
            return self.report(
                place,
                format!("{} cannot be added or subtracted", wrong.kind()),
            );
        };
        let unified = a.unify(b);
        let same_kind = matches!(left, Value::Scalar(..)) == matches!(right, Value::Scalar(..));
        if !same_kind {
            return self.report(
                operand.extent,
                format!("{} cannot be {verb} {}", right.kind(), left.kind()),
            );
        }
        let Some(dimension) = unified else {
            return self.report(
                operand.extent,
                format!("what is in {b} cannot be {verb} what is in {a}"),
            );
        };
        if let (Value::Scalar(a, _), Value::Scalar(b, _)) = (left, right) {
            let graph = &mut self.frames.graph;
            return Some(Value::Scalar(
                if operator == Operator::Add {
                    graph.add(a, b)
                } else {
                    graph.subtract(a, b)
                },
                dimension,
            ));
        }
        if let (Value::Components(f, a, _), Value::Components(g, b, _)) = (left, right)
            && f == g
        {
            let graph = &mut self.frames.graph;
            let sum = if operator == Operator::Add {
                graph.add_vectors(a, b)
            } else {
                graph.subtract_vectors(a, b)
            };
            return Some(Value::Components(f, sum, dimension));
        }
        let (a, b) = (self.as_vector(left)?, self.as_vector(right)?);
        let b = if operator == Operator::Add {
            b
        } else {
            self.frames.negate(b)
        };
        Some(Value::Vector(self.frames.add(a, b), dimension))
    }

    /// Vectors and components alike as a vector.
    pub fn as_vector(&mut self, value: Value) -> Option<Vector> {
        match value {
            Value::Vector(vector, _) => Some(vector),
            Value::Components(frame, components, _) => Some(self.frames.vector(frame, components)),
            _ => None,
        }
    }

    fn product(&mut self, left: Value, right: Value, place: Extent) -> Option<Value> {
        let (Some(a), Some(b)) = (dimension(left), dimension(right)) else {
            let wrong = if dimension(left).is_none() {
                left
            } else {
                right
            };
            return self.report(place, format!("{} cannot be multiplied", wrong.kind()));
        };
        let product = a.times(b);
        match (left, right) {
            (Value::Scalar(a, _), Value::Scalar(b, _)) => {
                Some(Value::Scalar(self.frames.graph.multiply(a, b), product))
            }
            (Value::Scalar(factor, _), vector) | (vector, Value::Scalar(factor, _)) => {
                self.scaled(factor, vector, product)
            }
            _ => self.report(
                place,
                "which product of two vectors? write `a.dot(b)` or `a.cross(b)`",
            ),
        }
    }

    pub fn scaled(&mut self, factor: Id, vector: Value, dimension: Dimension) -> Option<Value> {
        match vector {
            Value::Components(frame, components, _) => Some(Value::Components(
                frame,
                self.frames.graph.scale_vector(factor, components),
                dimension,
            )),
            other => {
                let vector = self.as_vector(other)?;
                Some(Value::Vector(self.frames.scale(factor, vector), dimension))
            }
        }
    }

    fn quotient(&mut self, left: Value, right: Value, place: Extent) -> Option<Value> {
        let Value::Scalar(divisor, b) = right else {
            return self.report(
                place,
                format!("a divisor is a scalar, and this is {}", right.kind()),
            );
        };
        let Some(a) = dimension(left) else {
            return self.report(place, format!("{} cannot be divided", left.kind()));
        };
        let quotient = a.over(b);
        if let Value::Scalar(dividend, _) = left {
            return Some(Value::Scalar(
                self.frames.graph.divide(dividend, divisor),
                quotient,
            ));
        }
        let one = self.frames.graph.one();
        let reciprocal = self.frames.graph.divide(one, divisor);
        self.scaled(reciprocal, left, quotient)
    }

    fn comparison(
        &mut self,
        operator: Operator,
        left: Value,
        right: Value,
        place: Extent,
    ) -> Option<Value> {
        let (Value::Scalar(a, of_a), Value::Scalar(b, of_b)) = (left, right) else {
            return self.report(
                place,
                format!(
                    "only scalars can be compared, not {} with {}",
                    left.kind(),
                    right.kind()
                ),
            );
        };
        if !of_a.fits(of_b) {
            return self.report(
                place,
                format!("what is in {of_b} cannot be compared with what is in {of_a}"),
            );
        }
        let graph = &mut self.frames.graph;
        Some(Value::Condition(match operator {
            Operator::Less => graph.compare(Comparison::Less, a, b),
            Operator::LessOrEqual => graph.compare(Comparison::LessOrEqual, a, b),
            Operator::Greater => graph.compare(Comparison::Less, b, a),
            Operator::GreaterOrEqual => graph.compare(Comparison::LessOrEqual, b, a),
            Operator::Equal => graph.compare(Comparison::Equal, a, b),
            _ => graph.compare(Comparison::NotEqual, a, b),
        }))
    }

    fn choice(&mut self, [condition, first, second]: &[Expression; 3]) -> Option<Value> {
        let (chosen_by, a, b) = (self.value(condition), self.value(first), self.value(second));
        let Value::Condition(chosen_by) = chosen_by? else {
            return self.report(condition.extent, "expected a condition, such as `t < 1[s]`");
        };
        let (a, b) = (a?, b?);
        let dimension = match (dimension(a), dimension(b)) {
            (Some(x), Some(y)) => match x.unify(y) {
                Some(dimension) => dimension,
                None => {
                    return self.report(
                        second.extent,
                        format!(
                            "both branches have one dimension: this is in {y}, the other in {x}"
                        ),
                    );
                }
            },
            _ => return self.report(second.extent, "a branch is a scalar or a vector"),
        };
        let graph = &mut self.frames.graph;
        if let (Value::Scalar(a, _), Value::Scalar(b, _)) = (a, b) {
            return Some(Value::Scalar(graph.select(chosen_by, a, b), dimension));
        }
        let (Some(a), Some(b)) = (self.as_vector(a), self.as_vector(b)) else {
            return self.report(
                second.extent,
                "both branches are scalars, or both are vectors",
            );
        };
        let graph = &mut self.frames.graph;
        let body = [0, 1, 2].map(|i| graph.select(chosen_by, a.body[i], b.body[i]));
        let world = [0, 1, 2].map(|i| graph.select(chosen_by, a.world[i], b.world[i]));
        Some(Value::Vector(Vector { body, world }, dimension))
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
