//! Calls: `world(..)` and `body(..)`, and the functions of scalars.

use proc_macro2::Ident;

use crate::errors::{Extent, function_meant, hint, vector_method_meant};
use crate::fraction::Fraction;
use crate::model::{Dimension, Frame, is_solid};
use crate::symbolic::{Function, Id, Number};
use crate::syntax::{Expression, Kind, NOT, Prefix};

use super::lowering::Lowering;
use super::scope::Value;
use super::unit::TOO_LARGE;
use super::written::as_method;

pub const VECTOR_METHODS: [&str; 7] = [
    "cross",
    "dot",
    "norm",
    "norm_squared",
    "normalize",
    "in_body",
    "in_world",
];
const SCALAR_METHODS: [&str; 3] = ["powi", "clamp", "recip"];

/// Whether a word is a function of scalars.
pub fn is_function(word: &str) -> bool {
    Function::from_name(word).is_some() || SCALAR_METHODS.contains(&word)
}

impl Lowering<'_> {
    pub fn call(
        &mut self,
        function: &Ident,
        arguments: &[Expression],
        extent: Extent,
    ) -> Option<Value> {
        let word = function.to_string();
        match word.as_str() {
            "body" | "world" => {
                self.check_has_body(function)?;
                let (components, dimension) = self.component_list(arguments, extent)?;
                let vector = if word == "body" {
                    self.body_vector(components, extent)?
                } else {
                    self.work.vector(Frame::WORLD, components)
                };
                Some(Value::Vector(vector, dimension))
            }
            "table" => self.table(function, arguments),
            "gradient" if self.scope.look_up(&word).is_none() => self.report(
                function.span(),
                "the gradient of a constraint is its method: write `name.gradient()`",
            ),
            "not" if self.scope.look_up(&word).is_none() => self.report(function.span(), NOT),
            "moment" => self.report(
                function.span(),
                "`moment(..)` stands alone after the name of a reaction or a field",
            ),
            word if is_solid(function) || matches!(word, "principal" | "tensor" | "products") => {
                self.report(
                    function.span(),
                    format!("`{word}(..)` is an inertia: it goes after `inertia:`"),
                )
            }
            _ if is_function(&word) => {
                let first = arguments.first().and_then(|first| self.value(first));
                let of_vector = first.and_then(|first| match first {
                    Value::Vector(..) | Value::Components(..) => vector_method_meant(&word),
                    _ => None,
                });
                let form = as_method(of_vector.unwrap_or(&word), arguments);
                self.report(
                    function.span(),
                    format!("functions are methods, as in Rust: write `{form}`"),
                )
            }
            _ if VECTOR_METHODS.contains(&word.as_str()) => {
                let form = as_method(&word, arguments);
                self.report(function.span(), format!("write `{form}`"))
            }
            _ => match self.scope.look_up(&word) {
                Some(Some(Value::Function(number))) => self.foreign(number, function, arguments),
                Some(None) => {
                    self.visit(arguments);
                    None
                }
                _ => self.unknown_function(function, arguments),
            },
        }
    }

    pub fn method(
        &mut self,
        value: Value,
        receiver: &Expression,
        method: &Ident,
        arguments: &[Expression],
    ) -> Option<Value> {
        let word = method.to_string();
        if let Value::Carried(body, offset) = value {
            return self.carried_point(body, offset, method, arguments);
        }
        match word.as_str() {
            "at" if matches!(value, Value::Scalar(..)) => {
                return self.report(
                    method.span(),
                    "`.at(P)` follows a load, which is a vector, and this is a scalar",
                );
            }
            "at" => {
                return self.report(
                    method.span(),
                    "`.at(P)` follows the whole load: put the vector in parentheses, \
                     `(..).at(P)`",
                );
            }
            "on" => {
                return self.report(
                    method.span(),
                    "`.on([..])` follows a whole field, in `fields`: put the vector in \
                     parentheses, `(..).on([q.at(P)])`",
                );
            }
            "about" => {
                return self.report(
                    method.span(),
                    "`.about(P)` belongs at the end of an inertia",
                );
            }
            _ => {}
        }
        match value {
            Value::Scalar(id, dimension) if word == "cross" && self.motion.is_planar => {
                self.planar_rotation(id, dimension, method, arguments)
            }
            Value::Scalar(id, dimension) => {
                self.scalar_method(id, dimension, receiver, method, arguments)
            }
            Value::Vector(..) | Value::Components(..) => {
                self.vector_method(value, method, arguments)
            }
            Value::Point(point) => self.point_method(point, method, arguments),
            Value::Attitude => self.report(
                method.span(),
                format!(
                    "the attitude has no method `{word}`: it has the parts `w`, `i`, `j` and `k`, and a \
                     direction of the body in world axes is `body(1, 0, 0).in_world()`"
                ),
            ),
            other => self.report(
                method.span(),
                format!("{} has no method `{word}`", other.kind()),
            ),
        }
    }

    fn scalar_method(
        &mut self,
        x: Id,
        of_x: Dimension,
        receiver: &Expression,
        method: &Ident,
        arguments: &[Expression],
    ) -> Option<Value> {
        let value = self.apply(x, of_x, receiver, method, arguments)?;
        if let Value::Scalar(id, _) = value {
            let mut operands = vec![x];
            if method == "powf"
                && let [exponent] = arguments
            {
                operands.push(self.scalar(exponent, Dimension::NONE, "an exponent")?);
            }
            self.check_value(&method.to_string(), &operands, id, method.span().into())?;
        }
        Some(value)
    }

    fn apply(
        &mut self,
        x: Id,
        of_x: Dimension,
        receiver: &Expression,
        method: &Ident,
        arguments: &[Expression],
    ) -> Option<Value> {
        let word = method.to_string();
        match word.as_str() {
            "powi" => {
                self.expect_arguments(method, arguments, 1)?;
                let exponent = self.whole_exponent(&arguments[0])?;
                let of_value = self.raised(of_x, Fraction::new(exponent.into(), 1), method)?;
                return Some(Value::Scalar(self.work.graph.powi(x, exponent), of_value));
            }
            "recip" => {
                self.expect_arguments(method, arguments, 0)?;
                let one = self.work.graph.one();
                let of_value = self.raised(of_x, Fraction::new(-1, 1), method)?;
                return Some(Value::Scalar(self.work.graph.divide(one, x), of_value));
            }
            "clamp" => return self.clamp(x, of_x, method, arguments),
            _ => {}
        }
        let Some(function) = Function::from_name(&word) else {
            return self.unknown_scalar_method(method);
        };
        self.expect_arguments(method, arguments, function.arity() - 1)?;
        if function == Function::Powf {
            return self.powf(x, of_x, receiver, &arguments[0]);
        }
        if !takes_dimensions(function) && !of_x.fits(Dimension::NONE) {
            let place = self.culprit(receiver, Dimension::NONE);
            let found = of_x.described();
            return self.report(
                place,
                format!("`{word}` takes a pure number, and this is {found}"),
            );
        }
        let mut operands = vec![x];
        let mut of_all = of_x;
        if let [second] = arguments {
            let (y, unified) = self.second_operand(of_x, second, &word)?;
            operands.push(y);
            of_all = unified;
        }
        let of_value = self.dimension_of(function, of_all, method)?;
        let value = self.work.graph.apply(function, &operands);
        Some(Value::Scalar(value, of_value))
    }

    /// The dimension of the value of a function, from the dimensions of its operands.
    fn dimension_of(
        &mut self,
        function: Function,
        operands: Dimension,
        method: &Ident,
    ) -> Option<Dimension> {
        match function {
            Function::Sqrt => self.raised(operands, Fraction::new(1, 2), method),
            Function::Cbrt => self.raised(operands, Fraction::new(1, 3), method),
            Function::Abs
            | Function::Floor
            | Function::Ceil
            | Function::Hypot
            | Function::Min
            | Function::Max => Some(operands),
            _ => Some(Dimension::NONE),
        }
    }

    /// The second argument of a function of two, and the dimension that both have in common.
    fn second_operand(
        &mut self,
        of_x: Dimension,
        second: &Expression,
        word: &str,
    ) -> Option<(Id, Dimension)> {
        let Value::Scalar(y, of_y) = self.value(second)? else {
            return self.report(second.extent, "expected a scalar");
        };
        let Some(unified) = of_x.unify(of_y) else {
            let place = self.culprit(second, of_x);
            let (this, other) = (of_y.described(), of_x.described());
            return self.report(
                place,
                format!(
                    "both arguments of `{word}` have one dimension: this is {this}, and the other \
                     is {other}"
                ),
            );
        };
        Some((y, unified))
    }

    fn clamp(
        &mut self,
        x: Id,
        of_x: Dimension,
        method: &Ident,
        arguments: &[Expression],
    ) -> Option<Value> {
        self.expect_arguments(method, arguments, 2)?;
        let (low, high) = (
            self.scalar(&arguments[0], of_x, "a bound"),
            self.scalar(&arguments[1], of_x, "a bound"),
        );
        let (low, high) = (low?, high?);
        let graph = &mut self.work.graph;
        if let (Some(least), Some(most)) = (graph.as_number(low), graph.as_number(high))
            && least > most
        {
            return self.report(
                method.span(),
                "the lower bound comes first, and here it is above the upper one",
            );
        }
        let above = graph.apply(Function::Max, &[x, low]);
        Some(Value::Scalar(
            graph.apply(Function::Min, &[above, high]),
            of_x,
        ))
    }

    fn unknown_scalar_method(&mut self, method: &Ident) -> Option<Value> {
        let word = method.to_string();
        if VECTOR_METHODS.contains(&word.as_str()) {
            return self.report(
                method.span(),
                format!("`{word}` is a method of vectors, and this is a scalar"),
            );
        }
        let known = Function::ALL
            .iter()
            .map(|(name, _)| *name)
            .chain(SCALAR_METHODS);
        let hint = match function_meant(&word) {
            Some(meant) => format!("; did you mean `{meant}`?"),
            None if word == "to_radians" => ": write the unit, `30[deg]`".to_owned(),
            None => hint(&word, known),
        };
        let message = format!("there is no function `{word}` of a scalar{hint}");
        self.report(method.span(), message)
    }

    fn whole_exponent(&mut self, expression: &Expression) -> Option<i32> {
        let (negative, digits) = match &expression.kind {
            Kind::Prefix(Prefix::Minus, inner) => (true, inner),
            _ => (false, &Box::new(expression.clone())),
        };
        let value = match &digits.kind {
            Kind::Number(digits) => Number::parse(digits)
                .and_then(|number| number.to_integer())
                .and_then(|value| i32::try_from(value).ok()),
            _ => None,
        };
        match value {
            Some(value) if value <= 64 => Some(if negative { -value } else { value }),
            _ if matches!(expression.kind, Kind::Poisoned) => None,
            _ => self.report(
                expression.extent,
                "the exponent of `powi` is a literal whole number from -64 to 64; others go to \
                 `powf`",
            ),
        }
    }

    fn raised(
        &mut self,
        dimension: Dimension,
        exponent: Option<Fraction>,
        method: &Ident,
    ) -> Option<Dimension> {
        let raised = exponent.and_then(|exponent| dimension.power(exponent));
        raised.or_else(|| self.report(method.span(), TOO_LARGE))
    }

    fn powf(
        &mut self,
        x: Id,
        of_x: Dimension,
        receiver: &Expression,
        exponent: &Expression,
    ) -> Option<Value> {
        let power = self.scalar(exponent, Dimension::NONE, "an exponent")?;
        let of_value = match self.work.graph.as_number(power) {
            Some(number) => of_x.power_of_number(number),
            None => (!of_x.is_known() || of_x == Dimension::NONE).then_some(of_x),
        };
        let Some(of_value) = of_value else {
            let message = format!(
                "only a pure number can be raised to this power, and this is {}",
                of_x.described()
            );
            return self.report(receiver.extent, message);
        };
        Some(Value::Scalar(
            self.work.graph.apply(Function::Powf, &[x, power]),
            of_value,
        ))
    }
}

fn takes_dimensions(function: Function) -> bool {
    matches!(
        function,
        Function::Sqrt
            | Function::Cbrt
            | Function::Abs
            | Function::Signum
            | Function::Atan2
            | Function::Hypot
            | Function::Min
            | Function::Max
    )
}
