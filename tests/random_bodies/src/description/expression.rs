//! Expressions of the language: scalars, vectors, conditions, and places.

use super::literal::Literal;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axes {
    Body,
    World,
}

#[derive(Clone, Debug)]
pub enum Scalar {
    Literal(Literal),
    Param(usize),
    Input(usize),
    Local(usize),
    /// A state of one's own.
    State(usize),
    /// A constant of Rust.
    Constant,
    /// A function of Rust.
    Called(Box<Scalar>),
    /// A table at a scalar: places and values.
    Table(Box<Scalar>, Vec<[Literal; 2]>, Course),
    /// A table at two scalars.
    Grid(Box<[Scalar; 2]>, Box<Grid>, Course),
    Time,
    Mass,
    /// In the plane.
    Angle,
    /// In the plane.
    AngularRate,
    /// In the plane.
    AngularAcceleration,
    /// A component of an unknown load, world axes.
    Reaction(usize, usize),
    /// One of w, i, j, k, in space.
    Attitude(usize),
    Component(Box<Vector>, Axes, usize),
    Dot(Box<Vector>, Box<Vector>),
    /// `a.cross(b)` in the plane.
    PlaneCross(Box<Vector>, Box<Vector>),
    Norm(Box<Vector>),
    NormSquared(Box<Vector>),
    Negative(Box<Scalar>),
    Sum(Box<Scalar>, Box<Scalar>),
    Difference(Box<Scalar>, Box<Scalar>),
    Product(Box<Scalar>, Box<Scalar>),
    Quotient(Box<Scalar>, Box<Scalar>),
    Unary(Unary, Box<Scalar>),
    Power(Box<Scalar>, i32),
    Binary(Binary, Box<Scalar>, Box<Scalar>),
    If(Box<Condition>, Box<Scalar>, Box<Scalar>),
}

/// How a table goes between its places and beyond them.
#[derive(Clone, Copy, Debug)]
pub struct Course {
    pub is_cubic: bool,
    pub is_extrapolated: bool,
}

/// The places of both scalars, and a row of values for each place of the first.
#[derive(Clone, Debug)]
pub struct Grid {
    pub places: [Vec<Literal>; 2],
    pub values: Vec<Vec<Literal>>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unary {
    Sqrt,
    Cbrt,
    Exp,
    Ln,
    Sin,
    Cos,
    Tan,
    Asin,
    Acos,
    Atan,
    Sinh,
    Cosh,
    Tanh,
    Abs,
    Signum,
    Floor,
    Ceil,
    Recip,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Binary {
    Atan2,
    Hypot,
    Min,
    Max,
    Powf,
}

#[derive(Clone, Debug)]
pub enum Condition {
    Less(Scalar, Scalar),
    AtLeast(Scalar, Scalar),
    And(Box<Condition>, Box<Condition>),
    Or(Box<Condition>, Box<Condition>),
    Not(Box<Condition>),
}

#[derive(Clone, Debug)]
pub enum Vector {
    /// `body(x, y, z)` or `world(x, y, z)`; in the plane z is zero and not written.
    Written(Axes, [Scalar; 3]),
    Param(usize),
    Input(usize),
    Local(usize),
    Position,
    Velocity,
    /// In space.
    AngularVelocity,
    /// Of G.
    Acceleration,
    /// In space.
    AngularAcceleration,
    PointAcceleration(Place),
    /// Of a rod.
    Axis,
    /// Of a rod.
    AxisRate,
    PointPosition(Place),
    PointVelocity(Place),
    Sum(Box<Vector>, Box<Vector>),
    Difference(Box<Vector>, Box<Vector>),
    Negative(Box<Vector>),
    Scaled(Box<Scalar>, Box<Vector>),
    Over(Box<Vector>, Box<Scalar>),
    Cross(Box<Vector>, Box<Vector>),
    /// `a.cross(v)` of a scalar along the normal of the plane.
    Turned(Box<Scalar>, Box<Vector>),
    Normalized(Box<Vector>),
    If(Box<Condition>, Box<Vector>, Box<Vector>),
}

/// A point of the body or of space.
#[derive(Clone, Debug)]
pub enum Place {
    Center,
    Named(usize),
    /// `P + vector`: the point of the body that is there at this instant.
    Shifted(Box<Place>, Box<Vector>),
}

impl Scalar {
    pub fn zero() -> Self {
        Self::Literal(Literal::new(0, 0))
    }

    pub fn is_zero(&self) -> bool {
        matches!(self, Self::Literal(literal) if literal.nearest() == 0.0)
    }

    pub fn literal(digits: i64, exponent: i32) -> Self {
        Self::Literal(Literal::new(digits, exponent))
    }
}

impl std::ops::Add for Scalar {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self::Sum(Box::new(self), Box::new(other))
    }
}

impl std::ops::Sub for Scalar {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        Self::Difference(Box::new(self), Box::new(other))
    }
}

impl std::ops::Neg for Scalar {
    type Output = Self;

    fn neg(self) -> Self {
        Self::Negative(Box::new(self))
    }
}

impl std::ops::Mul for Scalar {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        Self::Product(Box::new(self), Box::new(other))
    }
}

impl std::ops::Mul<Vector> for Scalar {
    type Output = Vector;

    fn mul(self, vector: Vector) -> Vector {
        Vector::Scaled(Box::new(self), Box::new(vector))
    }
}

impl std::ops::Add for Vector {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self::Sum(Box::new(self), Box::new(other))
    }
}

impl std::ops::Sub for Vector {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        Self::Difference(Box::new(self), Box::new(other))
    }
}
