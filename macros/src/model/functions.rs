//! What is called: `world(..)` and `body(..)`, the functions of scalars, the methods of vectors
//! and points, the components of vectors.

use proc_macro2::Ident;

use crate::errors::{Extent, hint};
use crate::symbolic::{Components, Function, Id, Number};
use crate::syntax::{Expression, Kind, Prefix};

use super::dimension::Dimension;
use super::frame::{Attitude, Frame, Vector};
use super::lower::{Lowering, dimension};
use super::value::{Point, Value};

const VECTOR_METHODS: [&str; 7] = [
    "cross",
    "dot",
    "norm",
    "norm_squared",
    "normalize",
    "in_body",
    "in_world",
];
const SCALAR_METHODS: [&str; 3] = ["powi", "clamp", "recip"];

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
                let frame = if word == "body" {
                    Frame::Body
                } else {
                    Frame::World
                };
                let (components, dimension) = self.component_list(arguments, extent)?;
                Some(Value::Vector(
                    self.frames.vector(frame, components),
                    dimension,
                ))
            }
            "moment" => self.report(
                function.span(),
                "`moment(..)` stands alone behind the name of a reaction or a field",
            ),
            "principal" => self.report(
                function.span(),
                "`principal(..)` is an inertia: it stands behind `inertia:`",
            ),
            _ if Function::from_name(&word).is_some()
                || SCALAR_METHODS.contains(&word.as_str()) =>
            {
                self.report(
                    function.span(),
                    format!("functions are methods, as in Rust: write `x.{word}(..)`"),
                )
            }
            _ if VECTOR_METHODS.contains(&word.as_str()) => {
                self.report(function.span(), format!("write `a.{word}(..)`"))
            }
            _ => {
                let known = ["body", "world"];
                self.report(
                    function.span(),
                    format!("there is no function `{word}` here{}", hint(&word, known)),
                )
            }
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
        match word.as_str() {
            "at" => return self.report(method.span(), "`.at(P)` stands at the end of a load"),
            "about" => {
                return self.report(method.span(), "`.about(P)` stands at the end of an inertia");
            }
            _ => {}
        }
        match value {
            Value::Scalar(id, dimension) if word == "cross" && self.motion.is_planar() => {
                self.planar_rotation(id, dimension, method, arguments)
            }
            Value::Scalar(id, dimension) => {
                self.scalar_method(id, dimension, receiver, method, arguments)
            }
            Value::Vector(..) | Value::Components(..) => {
                self.vector_method(value, method, arguments)
            }
            Value::Point(point) => self.point_method(point, method, arguments),
            other => self.report(
                method.span(),
                format!("{} has no method `{word}`", other.kind()),
            ),
        }
    }

    fn expect_arguments(
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

    fn scalar_method(
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
                return Some(Value::Scalar(
                    self.frames.graph.powi(x, exponent),
                    of_x.power(exponent, 1),
                ));
            }
            "recip" => {
                self.expect_arguments(method, arguments, 0)?;
                let one = self.frames.graph.one();
                return Some(Value::Scalar(
                    self.frames.graph.divide(one, x),
                    of_x.power(-1, 1),
                ));
            }
            "clamp" => {
                self.expect_arguments(method, arguments, 2)?;
                let (low, high) = (
                    self.scalar(&arguments[0], of_x, "a bound"),
                    self.scalar(&arguments[1], of_x, "a bound"),
                );
                let above = self.frames.graph.apply(Function::Max, &[x, low?]);
                return Some(Value::Scalar(
                    self.frames.graph.apply(Function::Min, &[above, high?]),
                    of_x,
                ));
            }
            _ => {}
        }
        let Some(function) = Function::from_name(&word) else {
            return self.unknown_scalar_method(method);
        };
        self.expect_arguments(method, arguments, function.arity() - 1)?;
        if function == Function::Powf {
            return self.powf(x, of_x, receiver, &arguments[0]);
        }
        let needs_number = !matches!(
            function,
            Function::Sqrt
                | Function::Cbrt
                | Function::Abs
                | Function::Signum
                | Function::Floor
                | Function::Ceil
                | Function::Atan2
                | Function::Hypot
                | Function::Min
                | Function::Max
        );
        if needs_number && !of_x.fits(Dimension::NONE) {
            return self.report(
                receiver.extent,
                format!("`{word}` takes a pure number, and this is in {of_x}"),
            );
        }
        let mut operands = vec![x];
        let mut of_all = of_x;
        if let [second] = arguments {
            let Value::Scalar(y, of_y) = self.value(second)? else {
                return self.report(second.extent, "expected a scalar");
            };
            let Some(unified) = of_x.unify(of_y) else {
                return self.report(second.extent, format!("both arguments of `{word}` have one dimension: this is in {of_y}, the other in {of_x}"));
            };
            operands.push(y);
            of_all = unified;
        }
        let of_value = match function {
            Function::Sqrt => of_all.power(1, 2),
            Function::Cbrt => of_all.power(1, 3),
            Function::Abs
            | Function::Floor
            | Function::Ceil
            | Function::Hypot
            | Function::Min
            | Function::Max => of_all,
            _ => Dimension::NONE,
        };
        Some(Value::Scalar(
            self.frames.graph.apply(function, &operands),
            of_value,
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
        self.report(
            method.span(),
            format!(
                "there is no function `{word}` of a scalar{}",
                hint(&word, known)
            ),
        )
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
            _ => self.report(expression.extent, "the exponent of `powi` is a literal whole number from -64 to 64; others go to `powf`"),
        }
    }

    fn powf(
        &mut self,
        x: Id,
        of_x: Dimension,
        receiver: &Expression,
        exponent: &Expression,
    ) -> Option<Value> {
        let power = self.scalar(exponent, Dimension::NONE, "an exponent")?;
        let whole = self
            .frames
            .graph
            .as_number(power)
            .map(|number| number.clone() * Number::integer(12))
            .and_then(|twelfths| twelfths.to_integer());
        let of_value = match whole.and_then(|twelfths| i32::try_from(twelfths).ok()) {
            _ if of_x == Dimension::NONE => Dimension::NONE,
            Some(twelfths) => of_x.power(twelfths, 12),
            None if !of_x.is_known() => Dimension::ANY,
            None => {
                return self.report(
                    receiver.extent,
                    format!(
                        "only a pure number can be raised to this power, and this is in {of_x}"
                    ),
                );
            }
        };
        Some(Value::Scalar(
            self.frames.graph.apply(Function::Powf, &[x, power]),
            of_value,
        ))
    }

    /// In the plane: `w.cross(v)` of a scalar `w` about z.
    fn planar_rotation(
        &mut self,
        w: Id,
        of_w: Dimension,
        method: &Ident,
        arguments: &[Expression],
    ) -> Option<Value> {
        self.expect_arguments(method, arguments, 1)?;
        let (vector, of_vector) = self.vector_argument(&arguments[0])?;
        let zero = self.frames.graph.zero();
        let axis = [zero, zero, w];
        let graph = &mut self.frames.graph;
        let turned = Vector {
            body: graph.cross(axis, vector.body),
            world: graph.cross(axis, vector.world),
        };
        Some(Value::Vector(turned, of_w.times(of_vector)))
    }

    fn vector_argument(&mut self, argument: &Expression) -> Option<(Vector, Dimension)> {
        let value = self.value(argument)?;
        match (self.as_vector(value), dimension(value)) {
            (Some(vector), Some(dimension)) => Some((vector, dimension)),
            _ => self.report(
                argument.extent,
                format!("expected a vector, and this is {}", value.kind()),
            ),
        }
    }

    fn vector_method(
        &mut self,
        value: Value,
        method: &Ident,
        arguments: &[Expression],
    ) -> Option<Value> {
        let word = method.to_string();
        let (vector, of_vector) = (self.as_vector(value)?, dimension(value)?);
        if !VECTOR_METHODS.contains(&word.as_str()) {
            return self.report(
                method.span(),
                format!(
                    "there is no method `{word}` of a vector{}",
                    hint(&word, VECTOR_METHODS)
                ),
            );
        }
        let count = usize::from(matches!(word.as_str(), "cross" | "dot"));
        self.expect_arguments(method, arguments, count)?;
        match word.as_str() {
            "cross" => {
                let (other, of_other) = self.vector_argument(&arguments[0])?;
                let product = self.frames.cross(vector, other);
                Some(self.moment_value(product, of_vector.times(of_other)))
            }
            "dot" => {
                let (other, of_other) = self.vector_argument(&arguments[0])?;
                Some(Value::Scalar(
                    self.frames.dot(vector, other),
                    of_vector.times(of_other),
                ))
            }
            "norm" => Some(Value::Scalar(self.frames.norm(vector), of_vector)),
            "norm_squared" => Some(Value::Scalar(
                self.frames.norm_squared(vector),
                of_vector.power(2, 1),
            )),
            "normalize" => {
                let norm = self.frames.norm(vector);
                let one = self.frames.graph.one();
                let reciprocal = self.frames.graph.divide(one, norm);
                let reciprocal = self.frames.graph.quantity(reciprocal);
                self.scaled(reciprocal, value, Dimension::NONE)
            }
            frame => {
                let frame = if frame == "in_body" {
                    Frame::Body
                } else {
                    Frame::World
                };
                let components = self.frames.components(vector, frame);
                Some(Value::Components(frame, components, of_vector))
            }
        }
    }

    /// A cross product: in the plane, its component along z.
    fn moment_value(&mut self, product: Vector, dimension: Dimension) -> Value {
        if self.motion.is_planar() {
            Value::Scalar(
                self.frames.graph.add(product.body[2], product.world[2]),
                dimension,
            )
        } else {
            Value::Vector(product, dimension)
        }
    }

    fn point_method(
        &mut self,
        point: Point,
        method: &Ident,
        arguments: &[Expression],
    ) -> Option<Value> {
        let word = method.to_string();
        if !matches!(word.as_str(), "position" | "velocity") {
            return self.report(
                method.span(),
                format!("a point has `.position()` and `.velocity()`, and no `{word}`"),
            );
        }
        self.expect_arguments(method, arguments, 0)?;
        let dimension = if word == "position" {
            Dimension::LENGTH
        } else {
            Dimension::VELOCITY
        };
        if !self.motion.has_position() && matches!(point, Point::Body(_)) {
            return self.report(method.span(), format!("the {word} of a point of the body is not known under `motion: rotation`: the motion of G is not modelled"));
        }
        let vector = match (point, word.as_str()) {
            (Point::Body(offset), "position") => Vector {
                body: offset,
                world: self.state.position,
            },
            (Point::Body(offset), _) => Vector {
                body: self.swept(offset),
                world: self.state.velocity,
            },
            (Point::World(position), "position") => self.frames.vector(Frame::World, position),
            (Point::World(_), _) => self.frames.zero_vector(),
        };
        Some(Value::Vector(vector, dimension))
    }

    /// `w x r`, body axes.
    fn swept(&mut self, offset: Components) -> Components {
        self.frames.graph.cross(self.state.angular_velocity, offset)
    }

    pub fn field(&mut self, receiver: &Expression, field: &Ident) -> Option<Value> {
        let value = self.value(receiver)?;
        let word = field.to_string();
        let axes = &["x", "y", "z"][..self.motion.axes()];
        match value {
            Value::Components(_, components, dimension) => {
                match axes.iter().position(|axis| *axis == word) {
                    Some(axis) => Some(Value::Scalar(components[axis], dimension)),
                    None => self.report(
                        field.span(),
                        format!("components are called `{}`", axes.join("`, `")),
                    ),
                }
            }
            Value::Vector(..) => self.report(
                field.span(),
                format!(
                    "a component in which axes? write `.in_body().{word}` or `.in_world().{word}`"
                ),
            ),
            Value::Attitude => {
                let Attitude::Quaternion { scalar, vector } = self.frames.attitude else {
                    return None;
                };
                match ["w", "i", "j", "k"].iter().position(|part| *part == word) {
                    Some(0) => Some(Value::Scalar(scalar, Dimension::NONE)),
                    Some(part) => Some(Value::Scalar(vector[part - 1], Dimension::NONE)),
                    None => self.report(
                        field.span(),
                        "the parts of the attitude quaternion are called `w`, `i`, `j` and `k`",
                    ),
                }
            }
            other => self.report(
                field.span(),
                format!("{} has no field `{word}`", other.kind()),
            ),
        }
    }
}
