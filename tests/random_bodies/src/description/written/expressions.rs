//! Scalars, conditions and vectors, as they are written.

use crate::description::expression::{Binary, Condition, Course, Scalar, Unary, Vector};
use crate::description::literal::Literal;

use super::{Writer, word};

impl Writer<'_> {
    /// An expression that can stand anywhere.
    pub fn operand(&self, scalar: &Scalar) -> String {
        let text = self.scalar(scalar);
        match scalar {
            Scalar::Literal(literal) if !literal.text.starts_with('-') => text,
            Scalar::Param(_)
            | Scalar::Input(_)
            | Scalar::Local(_)
            | Scalar::State(_)
            | Scalar::Constant
            | Scalar::Time
            | Scalar::Mass => text,
            _ => format!("({text})"),
        }
    }

    pub fn scalar(&self, scalar: &Scalar) -> String {
        let pair = |a: &Scalar, sign: &str, b: &Scalar| {
            format!("{} {sign} {}", self.operand(a), self.operand(b))
        };
        match scalar {
            Scalar::Literal(Literal { text, .. }) => text.clone(),
            Scalar::Param(i) => format!("param_{i}"),
            Scalar::Input(i) => format!("input_{i}"),
            Scalar::Local(i) => format!("local_{i}"),
            Scalar::State(i) => format!("state_{i}"),
            Scalar::Constant => "constant".to_owned(),
            Scalar::Called(a) => format!("bump({})", self.scalar(a)),
            Scalar::Table(a, rows, course) => {
                let [places, values] = [0, 1].map(|i| list(rows.iter().map(|row| &row[i])));
                let words = words(*course);
                format!("table({}, {places}, {values}{words})", self.scalar(a))
            }
            Scalar::Grid(at, grid, course) => {
                let [x, y] = at.each_ref().map(|a| self.scalar(a));
                let [along, across] = grid.places.each_ref().map(|places| list(places.iter()));
                let rows = grid.values.iter().map(|row| list(row.iter()));
                let rows = rows.collect::<Vec<_>>().join(", ");
                let words = words(*course);
                format!("table({x}, {y}, {along}, {across}, [{rows}]{words})")
            }
            Scalar::Time => "t".to_owned(),
            Scalar::Mass => "mass".to_owned(),
            Scalar::Reaction(load, axis) => {
                format!("load_{load}.in_world().{}", ["x", "y", "z"][*axis])
            }
            Scalar::Angle => "attitude".to_owned(),
            Scalar::AngularRate => "angular_velocity".to_owned(),
            Scalar::AngularAcceleration => "angular_acceleration".to_owned(),
            Scalar::Attitude(i) => format!("attitude.{}", ["w", "i", "j", "k"][*i]),
            Scalar::Component(vector, axes, i) => {
                let (vector, axis) = (self.vector_operand(vector), ["x", "y", "z"][*i]);
                format!("{vector}.in_{}().{axis}", word(*axes))
            }
            Scalar::Dot(a, b) => format!("{}.dot({})", self.vector_operand(a), self.vector(b)),
            Scalar::PlaneCross(a, b) => {
                format!("{}.cross({})", self.vector_operand(a), self.vector(b))
            }
            Scalar::Norm(v) => format!("{}.norm()", self.vector_operand(v)),
            Scalar::NormSquared(v) => format!("{}.norm_squared()", self.vector_operand(v)),
            Scalar::Negative(a) => format!("-{}", self.operand(a)),
            Scalar::Sum(a, b) => pair(a, "+", b),
            Scalar::Difference(a, b) => pair(a, "-", b),
            Scalar::Product(a, b) => pair(a, "*", b),
            Scalar::Quotient(a, b) => pair(a, "/", b),
            Scalar::Unary(function, a) => format!("{}.{}()", self.operand(a), unary(*function)),
            Scalar::Power(a, n) => format!("{}.powi({n})", self.operand(a)),
            Scalar::Binary(function, a, b) => {
                format!(
                    "{}.{}({})",
                    self.operand(a),
                    binary(*function),
                    self.scalar(b)
                )
            }
            Scalar::If(condition, a, b) => {
                let (condition, a, b) = (self.condition(condition), self.scalar(a), self.scalar(b));
                format!("if {condition} {{ {a} }} else {{ {b} }}")
            }
        }
    }

    fn condition(&self, condition: &Condition) -> String {
        match condition {
            Condition::Less(a, b) => format!("{} < {}", self.operand(a), self.operand(b)),
            Condition::AtLeast(a, b) => format!("{} >= {}", self.operand(a), self.operand(b)),
            Condition::And(a, b) => format!("({}) && ({})", self.condition(a), self.condition(b)),
            Condition::Or(a, b) => format!("({}) || ({})", self.condition(a), self.condition(b)),
            Condition::Not(a) => format!("!({})", self.condition(a)),
        }
    }

    pub fn vector_operand(&self, vector: &Vector) -> String {
        let text = self.vector(vector);
        match vector {
            Vector::Sum(..)
            | Vector::Difference(..)
            | Vector::Negative(_)
            | Vector::Scaled(..)
            | Vector::Over(..)
            | Vector::If(..) => format!("({text})"),
            _ => text,
        }
    }

    pub fn vector(&self, vector: &Vector) -> String {
        let pair = |a: &Vector, sign: &str, b: &Vector| {
            format!(
                "{} {sign} {}",
                self.vector_operand(a),
                self.vector_operand(b)
            )
        };
        match vector {
            Vector::Written(axes, components) => self.written_vector(*axes, components),
            Vector::Param(i) => format!("param_{i}"),
            Vector::Input(i) => format!("input_{i}"),
            Vector::Local(i) => format!("local_{i}"),
            Vector::Position => "position".to_owned(),
            Vector::Velocity => "velocity".to_owned(),
            Vector::AngularVelocity => "angular_velocity".to_owned(),
            Vector::Acceleration => "acceleration".to_owned(),
            Vector::AngularAcceleration => "angular_acceleration".to_owned(),
            Vector::PointAcceleration(place) => format!("{}.acceleration()", self.place(place)),
            Vector::Axis => "axis".to_owned(),
            Vector::AxisRate => "axis_rate".to_owned(),
            Vector::PointPosition(place) => format!("{}.position()", self.place(place)),
            Vector::PointVelocity(place) => format!("{}.velocity()", self.place(place)),
            Vector::Sum(a, b) => pair(a, "+", b),
            Vector::Difference(a, b) => pair(a, "-", b),
            Vector::Negative(v) => format!("-{}", self.vector_operand(v)),
            Vector::Scaled(s, v) => format!("{} * {}", self.operand(s), self.vector_operand(v)),
            Vector::Over(v, s) => format!("{} / {}", self.vector_operand(v), self.operand(s)),
            Vector::Cross(a, b) => format!("{}.cross({})", self.vector_operand(a), self.vector(b)),
            Vector::Turned(s, v) => format!("{}.cross({})", self.operand(s), self.vector(v)),
            Vector::Normalized(v) => format!("{}.normalize()", self.vector_operand(v)),
            Vector::If(condition, a, b) => {
                let (condition, a, b) = (self.condition(condition), self.vector(a), self.vector(b));
                format!("if {condition} {{ {a} }} else {{ {b} }}")
            }
        }
    }
}

fn unary(function: Unary) -> String {
    format!("{function:?}").to_lowercase()
}

fn binary(function: Binary) -> String {
    format!("{function:?}").to_lowercase()
}

fn list<'a>(literals: impl Iterator<Item = &'a Literal>) -> String {
    let texts: Vec<&str> = literals.map(|literal| literal.text.as_str()).collect();
    format!("[{}]", texts.join(", "))
}

fn words(course: Course) -> &'static str {
    match (course.is_cubic, course.is_extrapolated) {
        (false, false) => "",
        (false, true) => ", extrapolated",
        (true, false) => ", cubic",
        (true, true) => ", cubic, extrapolated",
    }
}
