//! The value of an expression, from the values of its parts.

use std::slice;

use crate::errors::Extent;
use crate::model::Dimension;
use crate::symbolic::{Components, Graph, Id, Number};
use crate::syntax::{Expression, Kind, Operator, Step, UnitExpression};

use super::lowering::{AXES, Lowering, UNKNOWN, dimension};
use super::scope::Value;
use super::unit::{lower_unit, unquoted};

const CHARGES: &str = "a list of charges follows a field: `field.on([q.at(P)])`";

const POWER: &str = "`^` is a power only inside unit brackets: write `x.powi(2)`; of a vector \
                     `v.norm_squared()`, and along it `v.norm() * v`";

impl Lowering<'_> {
    /// A value, with its frame and dimension.
    pub fn value(&mut self, expression: &Expression) -> Option<Value> {
        let extent = expression.extent;
        if let Some(found) = self.of_member(expression) {
            return found;
        }
        let value = match &expression.kind {
            Kind::Number(digits) => self.number(digits, extent),
            Kind::Name(name) => self.name(name, Dimension::ANY),
            Kind::Poisoned => None,
            Kind::Placeholder => self.report(extent, UNKNOWN),
            Kind::Text(text) => self.report(extent, unquoted(text)),
            Kind::Tuple(_) => self.report(extent, AXES),
            Kind::List(_) => self.report(extent, CHARGES),
            Kind::Unit(operand, unit) => self.unit(operand, unit),
            Kind::Prefix(prefix, operand) => self.prefix(*prefix, operand),
            Kind::Chain(first, rest) => match rest.iter().find(|step| is_power(step)) {
                Some(power) => {
                    self.check_brackets_of_unit(first, rest)?;
                    self.visit_operands(first, rest);
                    self.report(power.place, POWER)
                }
                None => self.chain(first, rest),
            },
            Kind::Call(function, arguments) => self.call(function, arguments, extent),
            Kind::Method(receiver, method, arguments) => {
                if let Some(gradient) = self.gradient(receiver, method, arguments) {
                    return gradient;
                }
                let Some(value) = self.value(receiver) else {
                    self.visit(arguments);
                    return None;
                };
                self.method(value, receiver, method, arguments)
            }
            Kind::Field(receiver, field) => self.field(receiver, field),
            Kind::Record(name, _) if name == "tensor" || name == "products" => self.report(
                name.span(),
                format!("`{name} {{ .. }}` is an inertia: it goes after `inertia:`"),
            ),
            Kind::Record(name, _) => self.report(
                name.span(),
                format!("`{name} {{ .. }}` is not part of the language"),
            ),
            Kind::If(parts) => self.choice(parts),
        }?;
        let value = self.by_name(value);
        let undefined = |id: &Id| self.work.graph.is_undefined(*id);
        let is_undefined = match &value {
            Value::Scalar(id, _) | Value::Condition(id) => undefined(id),
            Value::Components(_, components, _) => components.iter().any(undefined),
            Value::Vector(vector, _) => self.work.entries(&[*vector]).iter().any(undefined),
            Value::Point(_) | Value::Carried(..) | Value::Attitude | Value::Function(_) => false,
        };
        if is_undefined {
            return self.report(
                extent,
                "this has no value: it leads to a division by zero, or beyond all bounds",
            );
        }
        Some(value)
    }

    /// The value, by the quantities that parts of it are already: what is computed twice is the same,
    /// and so its difference is zero.
    fn by_name(&mut self, value: Value) -> Value {
        let graph = &mut self.work.graph;
        match value {
            Value::Scalar(id, dimension) => Value::Scalar(graph.known_quantity(id), dimension),
            Value::Components(frame, components, dimension) => {
                let named = components.map(|id| graph.known_quantity(id));
                Value::Components(frame, named, dimension)
            }
            Value::Vector(vector, dimension) => {
                let named =
                    |graph: &mut Graph, part: Components| part.map(|id| graph.known_quantity(id));
                Value::Vector(self.work.map(vector, named), dimension)
            }
            other => other,
        }
    }

    /// Reports further errors in expressions that are not used because of an error around them. A
    /// name with a unit is meant as a declaration there.
    pub fn visit(&mut self, expressions: &[Expression]) {
        for expression in expressions {
            let expression = match &expression.kind {
                Kind::Unit(name, _) if matches!(name.kind, Kind::Name(_)) => name,
                _ => expression,
            };
            let is_value = !matches!(
                expression.kind,
                Kind::Tuple(_) | Kind::List(_) | Kind::Placeholder
            );
            let _ = is_value.then(|| self.value(expression));
        }
    }

    /// Reports errors in operands. Rust's `^` binds less than `+`: what it takes together means
    /// nothing.
    fn visit_operands(&mut self, first: &Expression, rest: &[Step]) {
        for operand in [first]
            .into_iter()
            .chain(rest.iter().map(|step| &step.operand))
        {
            match &operand.kind {
                Kind::Chain(first, rest) => self.visit_operands(first, rest),
                _ => self.visit(slice::from_ref(operand)),
            }
        }
    }

    fn number(&mut self, digits: &str, extent: Extent) -> Option<Value> {
        match Number::parse(digits) {
            Some(number) if number.fits_f64() => Some(Value::Scalar(
                self.work.graph.number(number),
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

    fn unit(&mut self, operand: &Expression, unit: &UnitExpression) -> Option<Value> {
        let value = self.value(operand);
        let (factor, dimension) = lower_unit(unit, self.errors)?;
        let factor = self.work.graph.number(factor);
        match value? {
            Value::Scalar(id, found) => {
                self.check_unitless(found, unit.extent)?;
                Some(Value::Scalar(
                    self.work.graph.multiply(factor, id),
                    dimension,
                ))
            }
            Value::Vector(vector, found) => {
                self.check_no_component(found, unit)?;
                Some(Value::Vector(self.work.scale(factor, vector), dimension))
            }
            Value::Components(frame, components, found) => {
                self.check_no_component(found, unit)?;
                Some(Value::Components(
                    frame,
                    self.work.graph.scale_vector(factor, components),
                    dimension,
                ))
            }
            other => self.report(unit.extent, format!("{} has no unit", other.kind())),
        }
    }

    /// One of two values, selected by a condition.
    fn choice(&mut self, [condition, first, second]: &[Expression; 3]) -> Option<Value> {
        let (chosen_by, a, b) = (self.value(condition), self.value(first), self.value(second));
        let Value::Condition(chosen_by) = chosen_by? else {
            return self.report(condition.extent, "expected a condition, such as `t < 1[s]`");
        };
        let (a, b) = (a?, b?);
        let (Some(of_a), Some(of_b)) = (dimension(a), dimension(b)) else {
            let (wrong, branch) = if dimension(a).is_none() {
                (a, first)
            } else {
                (b, second)
            };
            return self.report(
                branch.extent,
                format!(
                    "a branch is a scalar or a vector, and this is {}",
                    wrong.kind()
                ),
            );
        };
        let Some(dimension) = of_a.unify(of_b) else {
            let (branch, this, other) = if first.size() < second.size() {
                (first, of_a, of_b)
            } else {
                (second, of_b, of_a)
            };
            let place = self.culprit(branch, other);
            let (this, other) = (this.described(), other.described());
            return self.report(
                place,
                format!(
                    "both branches have one dimension: this is {this}, and the other is {other}"
                ),
            );
        };
        let graph = &mut self.work.graph;
        if let (Value::Scalar(a, _), Value::Scalar(b, _)) = (a, b) {
            return Some(Value::Scalar(graph.select(chosen_by, a, b), dimension));
        }
        let (Some(a), Some(b)) = (self.as_vector(a), self.as_vector(b)) else {
            return self.report(
                second.extent,
                "both branches are scalars, or both are vectors",
            );
        };
        let chosen = self.work.combine(&[a, b], |graph, parts| {
            [0, 1, 2].map(|i| graph.select(chosen_by, parts[0][i], parts[1][i]))
        });
        Some(Value::Vector(chosen, dimension))
    }
}

fn is_power(step: &Step) -> bool {
    step.operator == Operator::Power
}
