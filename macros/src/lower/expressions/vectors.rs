//! The methods of vectors and points, and the components of vectors.

use proc_macro2::Ident;

use crate::errors::{hint, vector_method_meant};
use crate::model::{Attitude, Dimension, Frame, Point, Vector};
use crate::symbolic::{Components, Function, Id};
use crate::syntax::{Expression, Kind};
use crate::units::is_unit;

use super::along_axis::UNTURNED;
use super::functions::{VECTOR_METHODS, is_function};
use super::lowering::{Lowering, OfPoint, dimension};
use super::scope::Value;
use super::unit::TOO_LARGE;
use super::written::short;

impl Lowering<'_> {
    /// In the plane: `w.cross(v)`, where the scalar `w` is about z.
    pub fn planar_rotation(
        &mut self,
        w: Id,
        of_w: Dimension,
        method: &Ident,
        arguments: &[Expression],
    ) -> Option<Value> {
        self.expect_arguments(method, arguments, 1)?;
        let (vector, of_vector) = self.vector_argument(&arguments[0])?;
        let zero = self.work.graph.zero();
        let axis = [zero, zero, w];
        let turned = self.work.map(vector, |graph, part| graph.cross(axis, part));
        let of_turned = self.multiplied(of_w, of_vector, method)?;
        Some(Value::Vector(turned, of_turned))
    }

    fn multiplied(&mut self, a: Dimension, b: Dimension, method: &Ident) -> Option<Dimension> {
        let product = a.times(b);
        product.or_else(|| self.report(method.span(), TOO_LARGE))
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

    pub fn vector_method(
        &mut self,
        value: Value,
        method: &Ident,
        arguments: &[Expression],
    ) -> Option<Value> {
        let word = method.to_string();
        let (vector, of_vector) = (self.as_vector(value)?, dimension(value)?);
        if !VECTOR_METHODS.contains(&word.as_str()) {
            if is_function(&word) && word != "abs" {
                let message = format!(
                    "`{word}` is of scalars, and this is a vector: take a component of it, its \
                     `.norm()` or `.norm_squared()`"
                );
                return self.report(method.span(), message);
            }
            let hint = match vector_method_meant(&word) {
                Some(meant) => format!("; did you mean `{meant}`?"),
                None => hint(&word, VECTOR_METHODS),
            };
            let message = format!("there is no method `{word}` of a vector{hint}");
            return self.report(method.span(), message);
        }
        let names_body =
            word == "in_body" && !self.members.bodies.is_empty() && !arguments.is_empty();
        let count = usize::from(matches!(word.as_str(), "cross" | "dot") || names_body);
        self.expect_arguments(method, arguments, count)?;
        match word.as_str() {
            "cross" => {
                let (other, of_other) = self.vector_argument(&arguments[0])?;
                let of_product = self.multiplied(of_vector, of_other, method)?;
                let product = self.work.cross(vector, other);
                Some(self.moment_value(product, of_product))
            }
            "dot" => {
                let (other, of_other) = self.vector_argument(&arguments[0])?;
                let of_product = self.multiplied(of_vector, of_other, method)?;
                Some(Value::Scalar(self.work.dot(vector, other), of_product))
            }
            "norm" => Some(Value::Scalar(self.work.norm(vector), of_vector)),
            "norm_squared" => Some(Value::Scalar(
                self.work.norm_squared(vector),
                self.multiplied(of_vector, of_vector, method)?,
            )),
            "normalize" => {
                let norm = self.work.norm(vector);
                let one = self.work.graph.one();
                let reciprocal = self.work.graph.divide(one, norm);
                let reciprocal = self.work.graph.quantity(reciprocal);
                self.scaled(reciprocal, value, Dimension::NONE)
            }
            _ => {
                let frame = self.named_frame(method, arguments)?;
                let components = self.work.components(vector, frame);
                Some(Value::Components(frame, components, of_vector))
            }
        }
    }

    /// The axes that `.in_world()`, `.in_body()` or `.in_body(upper)` name.
    fn named_frame(&mut self, method: &Ident, arguments: &[Expression]) -> Option<Frame> {
        if method == "in_world" {
            return Some(Frame::WORLD);
        }
        match arguments {
            _ if self.motion.is_line() => self.report(
                method.span(),
                format!("{UNTURNED}: write `.in_world()`, or what is along it, `.dot(axis)`"),
            ),
            [body] => self.named_body(body),
            _ if self.is_whole => self.report(
                method.span(),
                "in the axes of which body? write its name in the parentheses",
            ),
            _ => Some(self.state.body),
        }
    }

    /// A cross product; in the plane, only its component along z.
    fn moment_value(&mut self, product: Vector, dimension: Dimension) -> Value {
        if self.motion.is_planar {
            let parts: Vec<Id> = self
                .work
                .parts(product)
                .iter()
                .map(|(_, part)| part[2])
                .collect();
            let zero = self.work.graph.zero();
            let whole = parts
                .into_iter()
                .fold(zero, |sum, part| self.work.graph.add(sum, part));
            Value::Scalar(whole, dimension)
        } else {
            Value::Vector(product, dimension)
        }
    }

    pub fn point_method(
        &mut self,
        point: Point,
        method: &Ident,
        arguments: &[Expression],
    ) -> Option<Value> {
        let asked = self.of_point(method, arguments)?;
        if !self.motion.knows_position() && !matches!(point, Point::Fixed(Frame::WORLD, _)) {
            return self.report(
                method.span(),
                format!(
                    "the {method} of a point of the body is not known under `motion: rotation`: \
                     the motion of G is not modeled"
                ),
            );
        }
        self.check_support_is_read(method)?;
        let vector = match point {
            _ if asked == OfPoint::Position => self.state.place(self.work, point),
            Point::Fixed(Frame::WORLD, _) => Vector::ZERO,
            _ if asked == OfPoint::Acceleration => self.acceleration_of(point),
            Point::Fixed(_, offset) => {
                let swept = self.state.swept(self.work, offset);
                self.work.add(self.state.velocity, swept)
            }
            Point::Moving(offset) => {
                let swept = self.swept(offset, self.state.angular_velocity, self.state.axes);
                self.work.add(self.state.velocity, swept)
            }
        };
        Some(Value::Vector(vector, asked.dimension()))
    }

    /// `w x r`, with w in these axes and each part of r in its own axes. The components of w are
    /// rotated together, so that `w x w` is zero.
    pub fn swept(&mut self, offset: Vector, w: Components, axes: Frame) -> Vector {
        let mut swept = Vector::ZERO;
        let own = self.work.vector(axes, w);
        for (frame, part) in self.work.parts(offset).to_vec() {
            let mut w = w;
            if frame != axes && !self.motion.is_planar {
                w = self.work.components(own, frame);
            }
            let product = self.work.graph.cross(w, part);
            let product = self.work.vector(frame, product);
            swept = self.work.add(swept, product);
        }
        swept
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
            Value::Vector(..) if !VECTOR_METHODS.contains(&word.as_str()) => {
                self.component_without_axes(receiver, field)
            }
            Value::Point(_) if axes.contains(&&*word) && self.motion.knows_position() => {
                let point = short(receiver).unwrap_or_else(|| "P".to_owned());
                let in_world = format!("`{point}.position().in_world().{word}`");
                let of_body = format!("`({point}.position() - position).in_body().{word}`");
                let message = if self.motion.is_line() {
                    format!("a component in which axes? write {in_world}")
                } else {
                    format!("a component in which axes? write {in_world}, or from G {of_body}")
                };
                self.report(field.span(), message)
            }
            Value::Attitude => {
                let Attitude::Quaternion { scalar, vector } = self.work.attitude(self.state.body)
                else {
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
            other => {
                let word = word.trim_start_matches("r#");
                let is_method = Function::from_name(word).is_some()
                    || VECTOR_METHODS.contains(&word)
                    || ["position", "velocity", "acceleration"].contains(&word);
                self.report(
                    field.span(),
                    if matches!(other, Value::Carried(..)) {
                        "a point has `.position()`, `.velocity()` and `.acceleration()`, which are vectors"
                            .to_owned()
                    } else if is_method {
                        format!("parentheses are missing: write `.{word}()`")
                    } else if self.motion.is_planar && matches!(word, "x" | "y" | "z") {
                        format!("in the plane this is {}: leave `.{word}` out", other.kind())
                    } else if is_unit(word) {
                        format!("a unit goes in brackets: write `[{word}]`")
                    } else {
                        format!("{} has no field `{word}`", other.kind())
                    },
                )
            }
        }
    }

    /// Reports `v.x` of a vector whose axes are not chosen.
    fn component_without_axes(&mut self, receiver: &Expression, field: &Ident) -> Option<Value> {
        if self.motion.is_planar && field == "z" {
            return self.report(field.span(), "in the plane a vector has no `z`");
        }
        let message = if self.motion.is_line() {
            format!("a component in which axes? write `.in_world().{field}`")
        } else {
            format!(
                "a component in which axes? write `.in_body().{field}` or `.in_world().{field}`"
            )
        };
        // the axes of a local can be chosen where it is defined, so the error is reported once
        if let Kind::Name(name) = &receiver.kind
            && self.scope.is_local(&name.to_string())
        {
            self.scope.redefine(&name.to_string(), None);
            let message = format!("{message}, here or once at the end of the local `{name}`");
            return self.report(field.span(), message);
        }
        self.report(field.span(), message)
    }
}
