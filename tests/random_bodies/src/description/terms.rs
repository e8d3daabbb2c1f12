//! Random expressions, with all functions and all quantities of a motion, that are defined
//! everywhere.

use super::body::{Local, Motion};
use super::draw::Draw;
use super::expression::{Axes, Binary, Condition, Place, Scalar, Unary, Vector};

impl Draw {
    /// A scalar of any size, at most so many operations deep.
    pub fn scalar(&mut self, depth: u32) -> Scalar {
        if depth == 0 || self.chance(0.2) {
            return self.scalar_leaf();
        }
        let next = |draw: &mut Self| draw.scalar(depth - 1);
        if self.body.is_rich && self.chance(0.1) {
            let inner = next(self);
            return self.rich(inner);
        }
        match self.random.u32(..10) {
            0 => next(self) + next(self),
            1 => next(self) - next(self),
            2 => next(self) * next(self),
            3 => {
                let (a, b) = (next(self), next(self));
                Scalar::Quotient(Box::new(a), Box::new(one_and_square(b)))
            }
            4 => {
                let (condition, a, b) = (self.condition(depth - 1), next(self), next(self));
                Scalar::If(Box::new(condition), Box::new(a), Box::new(b))
            }
            5 => {
                let n = self.pick(&[2, 3, -1]);
                let base = next(self);
                let base = if n < 0 { one_and_square(base) } else { base };
                Scalar::Power(Box::new(base), n)
            }
            6 => self.binary(depth - 1),
            7 => Scalar::Negative(Box::new(next(self))),
            _ => self.unary(depth - 1),
        }
    }

    fn scalar_leaf(&mut self) -> Scalar {
        if self.body.is_rich && self.chance(0.2) {
            return self.rich_leaf();
        }
        let number = Scalar::Literal(self.signed(-1));
        match self.random.u32(..9) {
            0 => self.scalar_param().unwrap_or(number),
            1 => self.scalar_input().unwrap_or(number),
            2 => number * Scalar::Time,
            3 if self.body.motion.turns() && !self.is_rod() => number * self.attitude(),
            4 => {
                let scalars = self.body.locals.iter().enumerate();
                let scalars = scalars.filter(|(_, local)| matches!(local, Local::Scalar(_)));
                let scalars: Vec<usize> = scalars.map(|(i, _)| i).collect();
                if scalars.is_empty() {
                    return number;
                }
                Scalar::Local(self.pick(&scalars))
            }
            5..8 => self.component(),
            _ => number,
        }
    }

    /// A number made of a vector.
    fn component(&mut self) -> Scalar {
        let vector = Box::new(self.vector_leaf());
        let axis = self.random.usize(..self.body.axes());
        let other = Box::new(self.vector_leaf());
        let planar = self.body.motion.is_planar();
        match self.random.u32(..6) {
            0 => Scalar::Norm(vector),
            1 => Scalar::NormSquared(vector),
            2 => Scalar::Dot(vector, other),
            3 if planar => Scalar::PlaneCross(vector, other),
            3 if !self.is_rod() => Scalar::Component(vector, Axes::Body, axis),
            _ => Scalar::Component(vector, Axes::World, axis),
        }
    }

    pub fn attitude(&mut self) -> Scalar {
        match self.body.motion {
            Motion::FixedAxis(..) => Scalar::Angle,
            _ if self.body.motion.is_planar() => self.pick(&[Scalar::Angle, Scalar::AngularRate]),
            _ => Scalar::Attitude(self.random.usize(..4)),
        }
    }

    fn unary(&mut self, depth: u32) -> Scalar {
        let inner = self.scalar(depth);
        let apply = |function: Unary, x: Scalar| Scalar::Unary(function, Box::new(x));
        let sine = |x: Scalar| apply(Unary::Sin, x);
        let nine_tenths = Scalar::literal(9, -1);
        match self.random.u32(..18) {
            0 => apply(Unary::Sqrt, one_and_square(inner)),
            1 => apply(Unary::Cbrt, Scalar::literal(2, 0) + sine(inner)),
            2 => apply(Unary::Exp, sine(inner)),
            3 => apply(Unary::Ln, one_and_square(inner)),
            4 => apply(Unary::Cos, inner),
            5 => apply(Unary::Tan, nine_tenths * sine(inner)),
            6 => apply(Unary::Asin, nine_tenths * sine(inner)),
            7 => apply(Unary::Acos, nine_tenths * sine(inner)),
            8 => apply(Unary::Atan, inner),
            9 => apply(Unary::Sinh, sine(inner)),
            10 => apply(Unary::Cosh, sine(inner)),
            11 => apply(Unary::Tanh, inner),
            12 => apply(Unary::Abs, inner),
            13 => apply(Unary::Signum, inner),
            14 => apply(Unary::Floor, inner),
            15 => apply(Unary::Ceil, inner),
            16 => apply(Unary::Recip, one_and_square(inner)),
            _ => sine(inner),
        }
    }

    fn binary(&mut self, depth: u32) -> Scalar {
        let (a, b) = (self.scalar(depth), self.scalar(depth));
        let all = [
            Binary::Atan2,
            Binary::Hypot,
            Binary::Min,
            Binary::Max,
            Binary::Powf,
        ];
        let function = self.pick(&all);
        let (a, b) = match function {
            Binary::Atan2 => (a, one_and_square(b)),
            Binary::Powf => (
                one_and_square(a),
                Scalar::Literal(self.between(-1500, 1500)),
            ),
            _ => (a, b),
        };
        Scalar::Binary(function, Box::new(a), Box::new(b))
    }

    fn condition(&mut self, depth: u32) -> Condition {
        let (a, b) = (self.scalar(depth.min(1)), self.scalar_leaf());
        match self.random.u32(..6) {
            0 => Condition::AtLeast(a, b),
            1 => Condition::And(Box::new(Condition::Less(a, b)), Box::new(self.condition(0))),
            2 => Condition::Or(Box::new(Condition::Less(a, b)), Box::new(self.condition(0))),
            3 => Condition::Not(Box::new(Condition::Less(a, b))),
            _ => Condition::Less(a, b),
        }
    }

    pub fn is_rod(&self) -> bool {
        matches!(self.body.motion, Motion::Rod(_))
    }

    /// A vector of any size; of a rod, one that is known in world axes.
    pub fn vector(&mut self, depth: u32) -> Vector {
        if depth == 0 || self.chance(0.2) {
            return self.vector_leaf();
        }
        let planar = self.body.motion.is_planar();
        let (a, b) = (self.vector(depth - 1), self.vector(depth - 1));
        match self.random.u32(..8) {
            0 => a + b,
            1 => a - b,
            2 | 3 => self.scalar(depth - 1) * a,
            4 if planar => Vector::Turned(Box::new(self.scalar_leaf()), Box::new(a)),
            4 => Vector::Cross(Box::new(a), Box::new(b)),
            5 => {
                let divisor = one_and_square(self.scalar_leaf());
                Vector::Over(Box::new(a), Box::new(divisor))
            }
            6 => {
                let condition = self.condition(depth - 1);
                Vector::If(Box::new(condition), Box::new(a), Box::new(b))
            }
            _ => Vector::Negative(Box::new(a)),
        }
    }

    fn vector_leaf(&mut self) -> Vector {
        let number = Scalar::Literal(self.signed(0));
        let scaled = |vector: Vector| number.clone() * vector;
        match self.random.u32(..8) {
            0 => self.vector_name().unwrap_or_else(|| self.written()),
            1 if self.body.motion.moves() => scaled(Vector::Position),
            2 if self.body.motion.moves() => scaled(Vector::Velocity),
            3 if self.body.motion.moves() => {
                let place = self.place(Axes::Body);
                scaled(Vector::PointPosition(place))
            }
            4 if self.body.motion.moves() => {
                let place = self.place(Axes::Body);
                scaled(Vector::PointVelocity(place))
            }
            5 if self.is_rod() => {
                let which = self.pick(&[Vector::Axis, Vector::AxisRate]);
                scaled(which)
            }
            5 if self.body.motion.turns() && !self.body.motion.is_planar() => {
                scaled(Vector::AngularVelocity)
            }
            6 => {
                let vectors = self.body.locals.iter().enumerate();
                let vectors = vectors.filter(|(_, local)| matches!(local, Local::Vector(_)));
                let vectors: Vec<usize> = vectors.map(|(i, _)| i).collect();
                if vectors.is_empty() {
                    return self.written();
                }
                Vector::Local(self.pick(&vectors))
            }
            _ => self.written(),
        }
    }

    /// Of numbers in one set of axes.
    pub fn written(&mut self) -> Vector {
        let axes = if self.is_rod() {
            Axes::World
        } else {
            self.pick(&[Axes::Body, Axes::World])
        };
        Vector::Written(axes, self.components(0))
    }

    /// Numbers, some of them zero.
    pub fn components(&mut self, order: i32) -> [Scalar; 3] {
        let mut components = [(); 3].map(|()| {
            if self.chance(0.3) {
                Scalar::zero()
            } else {
                Scalar::Literal(self.signed(order))
            }
        });
        components[0] = Scalar::Literal(self.signed(order));
        self.random.shuffle(&mut components[..self.body.axes()]);
        if self.body.motion.is_planar() {
            components[2] = Scalar::zero();
        }
        components
    }

    /// The point of the body a load acts at: any, or one beside it at this instant.
    pub fn point_of_action(&mut self) -> Place {
        let place = match self.random.u32(..4) {
            0 => Place::Center,
            _ => self.place(Axes::Body),
        };
        // beside a rod, a force has a moment about its axis
        if self.body.motion.moves() && !self.is_rod() && self.chance(0.1) {
            let order = self.length - 1;
            let offset = Vector::Written(Axes::World, self.components(order));
            return Place::Shifted(Box::new(place), Box::new(offset));
        }
        place
    }
}

/// `1 + x²`
fn one_and_square(x: Scalar) -> Scalar {
    Scalar::literal(1, 0) + Scalar::Power(Box::new(x), 2)
}
