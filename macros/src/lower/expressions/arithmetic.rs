//! Signs, sums, products, comparisons and choices.

use crate::errors::Extent;
use crate::model::{Dimension, Frame, Point, Vector};
use crate::symbolic::{Comparison, Id};
use crate::syntax::{Expression, Kind, Operator, Prefix, Step};

use super::lowering::{Lowering, dimension};
use super::scope::Value;
use super::unit::TOO_LARGE;

impl Lowering<'_> {
    pub fn prefix(&mut self, prefix: Prefix, operand: &Expression) -> Option<Value> {
        match (prefix, self.value(operand)?) {
            (Prefix::Minus, Value::Scalar(id, dimension)) => {
                Some(Value::Scalar(self.work.graph.negate(id), dimension))
            }
            (Prefix::Minus, Value::Vector(vector, dimension)) => {
                Some(Value::Vector(self.work.negate(vector), dimension))
            }
            (Prefix::Minus, Value::Components(frame, components, dimension)) => Some(
                Value::Components(frame, self.work.graph.negate_vector(components), dimension),
            ),
            (Prefix::Not, Value::Condition(id)) => Some(Value::Condition(self.work.graph.not(id))),
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

    pub fn chain(&mut self, first: &Expression, rest: &[Step]) -> Option<Value> {
        self.check_brackets_of_unit(first, rest)?;
        let mut left = Side {
            value: self.value(first),
            written: Some(first),
            extent: first.extent,
            size: first.size(),
        };
        for step in rest {
            let right = self.value(&step.operand);
            left.value = match (left.value, right) {
                (Some(value), Some(right)) => {
                    let sides = Sides { left: &left, step };
                    self.operation(value, right, sides)
                }
                _ => None,
            };
            left.extent = left.extent.to(step.operand.extent);
            left.size += step.operand.size();
            left.written = None;
        }
        left.value
    }

    fn operation(&mut self, left: Value, right: Value, sides: Sides<'_>) -> Option<Value> {
        let operator = sides.step.operator;
        match operator {
            Operator::Add | Operator::Subtract => self.sum(left, right, sides),
            Operator::Multiply => self.product(left, right, sides),
            Operator::Divide => self.quotient(left, right, sides),
            // reported
            Operator::Power => None,
            Operator::And | Operator::Or => match (left, right) {
                (Value::Condition(a), Value::Condition(b)) => {
                    let graph = &mut self.work.graph;
                    Some(Value::Condition(if operator == Operator::And {
                        graph.and(a, b)
                    } else {
                        graph.or(a, b)
                    }))
                }
                (Value::Condition(_), other) => self.report(
                    sides.step.operand.extent,
                    format!("expected a condition, and this is {}", other.kind()),
                ),
                (other, _) => self.report(
                    sides.left.extent,
                    format!("expected a condition, and this is {}", other.kind()),
                ),
            },
            _ => self.comparison(left, right, sides),
        }
    }

    /// Reports two dimensions that do not fit. The error underlines the smaller side; if a unit was
    /// written there, only the unit.
    fn unequal<T>(
        &mut self,
        (a, b): (Dimension, Dimension),
        what: (&str, &str),
        sides: Sides<'_>,
    ) -> Option<T> {
        let Sides { left, step } = sides;
        let (place, this, other, what) = if left.size < step.operand.size() {
            let place = left
                .written
                .map_or(left.extent, |written| self.culprit(written, b));
            (place, a, b, what.0)
        } else {
            (self.culprit(&step.operand, a), b, a, what.1)
        };
        let (this, other) = (this.described(), other.described());
        self.report(place, format!("this is {this}, and what {what} is {other}"))
    }

    fn sum(&mut self, left: Value, right: Value, sides: Sides<'_>) -> Option<Value> {
        let is_sum = sides.step.operator == Operator::Add;
        if let (Value::Point(point), Some(vector)) = (left, self.as_vector(right))
            && !matches!(point, Point::Fixed(Frame::WORLD, _))
        {
            return self.point_beside(point, vector, dimension(right)?, sides);
        }
        let (Some(a), Some(b)) = (dimension(left), dimension(right)) else {
            return self.no_summands(left, right, sides);
        };
        if matches!(left, Value::Scalar(..)) != matches!(right, Value::Scalar(..)) {
            return self.unlike(left, right, sides);
        }
        let Some(dimension) = a.unify(b) else {
            let what = if is_sum {
                ("is added to it", "it is added to")
            } else {
                ("is subtracted from it", "it is subtracted from")
            };
            return self.unequal((a, b), what, sides);
        };
        if let (Value::Scalar(a, _), Value::Scalar(b, _)) = (left, right) {
            let graph = &mut self.work.graph;
            return Some(Value::Scalar(
                if is_sum {
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
            let graph = &mut self.work.graph;
            let sum = if is_sum {
                graph.add_vectors(a, b)
            } else {
                graph.subtract_vectors(a, b)
            };
            return Some(Value::Components(f, sum, dimension));
        }
        let (a, b) = (self.as_vector(left)?, self.as_vector(right)?);
        let b = if is_sum { b } else { self.work.negate(b) };
        Some(Value::Vector(self.work.add(a, b), dimension))
    }

    /// Reports each side of a sum that is neither a scalar nor a vector.
    fn no_summands(&mut self, left: Value, right: Value, sides: Sides<'_>) -> Option<Value> {
        let operand = &sides.step.operand;
        let both = [
            (left, sides.left.extent, sides.left.written),
            (right, operand.extent, Some(operand)),
        ];
        let verb = match sides.step.operator {
            Operator::Add => "added",
            _ => "subtracted",
        };
        for (value, place, written) in both {
            if dimension(value).is_none() {
                let instead = self.instead(value, written);
                self.errors
                    .push(place, format!("{} cannot be {verb}{instead}", value.kind()));
            }
        }
        None
    }

    /// Reports the sum of a scalar and a vector. The error underlines the smaller side.
    fn unlike(&mut self, left: Value, right: Value, sides: Sides<'_>) -> Option<Value> {
        let (place, this, other) = if sides.left.size < sides.step.operand.size() {
            (sides.left.extent, left.kind(), right.kind())
        } else {
            (sides.step.operand.extent, right.kind(), left.kind())
        };
        let message = format!("this is {this}, and the other side of the sum is {other}");
        self.report(place, message)
    }

    /// What to write instead of a point where a vector is meant.
    fn instead(&self, value: Value, written: Option<&Expression>) -> String {
        if matches!(value, Value::Carried(..)) {
            let zero = if self.motion.is_planar { "" } else { ", 0" };
            return format!(
                ": name the point in the braces of its body, as in `points: [tip = G + body(0.1, 0{zero})]`"
            );
        }
        if !matches!(value, Value::Point(_)) {
            return String::new();
        }
        if self.motion.is_supported() && self.state.support.is_none() {
            return ": write a vector, `body(x, y, z)` or `world(x, y, z)`".to_owned();
        }
        let advice = match written.map(|written| &written.kind) {
            Some(Kind::Name(name)) => format!("write `{name}.position()`"),
            _ => "take its `.position()`".to_owned(),
        };
        format!(": {advice}, the vector to it from the origin of the world")
    }

    /// `P + v`: the material point of the body at this offset from one of its points.
    fn point_beside(
        &mut self,
        point: Point,
        vector: Vector,
        found: Dimension,
        sides: Sides<'_>,
    ) -> Option<Value> {
        if !found.fits(Dimension::LENGTH) {
            let place = self.culprit(&sides.step.operand, Dimension::LENGTH);
            let found = found.described();
            return self.report(
                place,
                format!("from a point to a point is in m, and this is {found}"),
            );
        }
        let vector = match sides.step.operator {
            Operator::Add => vector,
            _ => self.work.negate(vector),
        };
        let from_center = match point {
            Point::Moving(offset) => offset,
            Point::Fixed(body, offset) => self.work.fixed_in(body, offset),
        };
        let offset = self.work.add(from_center, vector);
        let body = self.state.body;
        let part = self.work.part(offset, body);
        let is_fixed = self.work.is_in(offset, body) && self.work.graph.are_early(&part);
        Some(Value::Point(if is_fixed {
            Point::Fixed(body, part)
        } else {
            Point::Moving(offset)
        }))
    }

    /// A value as a vector, also if its components can be read.
    pub fn as_vector(&mut self, value: Value) -> Option<Vector> {
        match value {
            Value::Vector(vector, _) => Some(vector),
            Value::Components(frame, components, _) => Some(self.work.vector(frame, components)),
            _ => None,
        }
    }

    fn product(&mut self, left: Value, right: Value, sides: Sides<'_>) -> Option<Value> {
        let (Some(a), Some(b)) = (dimension(left), dimension(right)) else {
            let (wrong, place) = if dimension(left).is_none() {
                (left, sides.left.extent)
            } else {
                (right, sides.step.operand.extent)
            };
            return self.report(place, format!("{} cannot be multiplied", wrong.kind()));
        };
        let Some(product) = a.times(b) else {
            return self.report(sides.step.place, TOO_LARGE);
        };
        match (left, right) {
            (Value::Scalar(a, _), Value::Scalar(b, _)) => {
                Some(Value::Scalar(self.work.graph.multiply(a, b), product))
            }
            (Value::Scalar(factor, _), vector) | (vector, Value::Scalar(factor, _)) => {
                self.scaled(factor, vector, product)
            }
            _ => self.report(
                sides.step.place,
                "which product of two vectors? write `a.dot(b)` or `a.cross(b)`",
            ),
        }
    }

    pub fn scaled(&mut self, factor: Id, vector: Value, dimension: Dimension) -> Option<Value> {
        match vector {
            Value::Components(frame, components, _) => Some(Value::Components(
                frame,
                self.work.graph.scale_vector(factor, components),
                dimension,
            )),
            other => {
                let vector = self.as_vector(other)?;
                Some(Value::Vector(self.work.scale(factor, vector), dimension))
            }
        }
    }

    fn quotient(&mut self, left: Value, right: Value, sides: Sides<'_>) -> Option<Value> {
        let place = sides.step.operand.extent;
        let Value::Scalar(divisor, b) = right else {
            return self.report(
                place,
                format!("a divisor is a scalar, and this is {}", right.kind()),
            );
        };
        let Some(a) = dimension(left) else {
            let message = format!("{} cannot be divided", left.kind());
            return self.report(sides.left.extent, message);
        };
        if self.work.graph.is_zero(divisor) {
            return self.report(place, "this is zero, and nothing can be divided by it");
        }
        if let Some(number) = self.work.graph.as_number(divisor)
            && number.is_undecided()
        {
            return self.report(
                place,
                "this cannot be told from zero, and nothing can be divided by that",
            );
        }
        let Some(quotient) = a.over(b) else {
            return self.report(sides.step.place, TOO_LARGE);
        };
        let one = self.work.graph.one();
        if self.work.graph.is_early(divisor) {
            let reciprocal = self.work.graph.divide(one, divisor);
            self.check_value("/", &[divisor], reciprocal, place)?;
        }
        if let Value::Scalar(dividend, _) = left {
            return Some(Value::Scalar(
                self.work.graph.divide(dividend, divisor),
                quotient,
            ));
        }
        let reciprocal = self.work.graph.divide(one, divisor);
        self.scaled(reciprocal, left, quotient)
    }

    fn comparison(&mut self, left: Value, right: Value, sides: Sides<'_>) -> Option<Value> {
        let (Value::Scalar(a, of_a), Value::Scalar(b, of_b)) = (left, right) else {
            return self.report(
                sides.step.place,
                format!(
                    "only scalars can be compared, not {} with {}",
                    left.kind(),
                    right.kind()
                ),
            );
        };
        if !of_a.fits(of_b) {
            let what = ("it is compared with", "it is compared with");
            return self.unequal((of_a, of_b), what, sides);
        }
        let operator = sides.step.operator;
        let graph = &mut self.work.graph;
        Some(Value::Condition(match operator {
            Operator::Less => graph.compare(Comparison::Less, a, b),
            Operator::LessOrEqual => graph.compare(Comparison::LessOrEqual, a, b),
            Operator::Greater => graph.compare(Comparison::Less, b, a),
            Operator::GreaterOrEqual => graph.compare(Comparison::LessOrEqual, b, a),
            Operator::Equal => graph.compare(Comparison::Equal, a, b),
            _ => graph.compare(Comparison::NotEqual, a, b),
        }))
    }
}

/// One side of an operator.
struct Side<'e> {
    value: Option<Value>,
    /// The expression, if it is one.
    written: Option<&'e Expression>,
    extent: Extent,
    size: usize,
}

/// Both sides of an operator.
#[derive(Clone, Copy)]
struct Sides<'e> {
    left: &'e Side<'e>,
    step: &'e Step,
}
