//! Scalars that are one expression up to a number and another beyond it, with numbers of every
//! size; and scalars that are zero for a reason.

use super::body::{Key, Load, Local, Motion, What};
use super::draw::Draw;
use super::expression::{Axes, Binary, Condition, Place, Scalar, Unary, Vector};

fn apply(function: Unary, x: Scalar) -> Scalar {
    Scalar::Unary(function, Box::new(x))
}

fn both(function: Binary, x: Scalar, y: Scalar) -> Scalar {
    Scalar::Binary(function, Box::new(x), Box::new(y))
}

fn square(x: Scalar) -> Scalar {
    Scalar::Power(Box::new(x), 2)
}

fn over(x: Scalar, y: Scalar) -> Scalar {
    Scalar::Quotient(Box::new(x), Box::new(y))
}

fn whole(number: i64) -> Scalar {
    Scalar::literal(number, 0)
}

impl Draw {
    /// One of these scalars, or two of them together.
    pub fn gate(&mut self) -> Scalar {
        let quantity = self.quantity();
        let first = self.gate_of(quantity.clone());
        match self.random.u32(..12) {
            // of the same quantity, so that one may be zero where the other is not
            0 => first * self.gate_of(quantity),
            1 => {
                let other = self.quantity();
                first * self.gate_of(other)
            }
            2 => first - self.gate_of(quantity),
            _ => first,
        }
    }

    /// What a description reads, times a number, whose dimension may be any: more often than not one.
    pub fn quantity(&mut self) -> Scalar {
        let number = if self.chance(0.6) {
            whole(1)
        } else {
            Scalar::Literal(self.signed(0))
        };
        number * self.read()
    }

    fn read(&mut self) -> Scalar {
        let motion = self.body.motion.clone();
        let planar = motion.is_planar();
        let axis = self.random.usize(..self.body.axes());
        if self.is_slow {
            return match self.random.u32(..3) {
                0 => self.scalar_param().unwrap_or(Scalar::Time),
                1 => Scalar::Component(Box::new(Vector::Position), Axes::World, axis),
                _ => Scalar::Time,
            };
        }
        let of = |vector: Vector, axes: Axes| Scalar::Component(Box::new(vector), axes, axis);
        match self.random.u32(..10) {
            0 | 1 => Scalar::Time,
            2 => self.scalar_param().unwrap_or(Scalar::Time),
            3 => self.scalar_input().unwrap_or(Scalar::Time),
            4 | 5 if motion.turns() && planar => Scalar::AngularRate,
            4 | 5 if motion.turns() && !self.is_rod() => of(Vector::AngularVelocity, Axes::Body),
            4 | 5 if self.is_rod() => of(Vector::AxisRate, Axes::World),
            6 if matches!(motion, Motion::Spatial | Motion::Planar) => {
                let axes = self.pick(&[Axes::Body, Axes::World]);
                of(Vector::Velocity, axes)
            }
            6 | 7 if motion.moves() => of(Vector::Velocity, Axes::World),
            8 if motion.moves() => of(Vector::Position, Axes::World),
            9 if motion.moves() => {
                let vector = self.pick(&[Vector::Velocity, Vector::Position]);
                Scalar::Norm(Box::new(vector))
            }
            _ if motion.turns() && !self.is_rod() => self.attitude(),
            _ => Scalar::Time,
        }
    }

    /// From 1e-3 to 1e7.
    fn large(&mut self) -> Scalar {
        let order = self.random.i32(-3..=6);
        Scalar::Literal(self.positive(order))
    }

    #[allow(clippy::too_many_lines, reason = "a list")]
    pub fn gate_of(&mut self, q: Scalar) -> Scalar {
        let c = if self.chance(0.1) {
            Scalar::zero()
        } else {
            self.large()
        };
        let x = if self.random.bool() {
            q.clone() - c.clone()
        } else {
            c.clone() - q.clone()
        };
        let wide = self.large();
        let scaled = over(x.clone(), wide.clone());
        let (zero, one) = (whole(0), whole(1));
        let number = Scalar::Literal(self.signed(0));
        let less = |a: &Scalar, b: &Scalar| Condition::Less(a.clone(), b.clone());
        match self.random.u32(..40) {
            0 | 1 => both(Binary::Max, x, zero),
            2 => both(Binary::Min, x, zero),
            3 => apply(Unary::Abs, x.clone()) + x,
            4 => apply(Unary::Abs, x.clone()) - x,
            5 => apply(Unary::Sqrt, square(x.clone())) + x,
            6 => apply(Unary::Sqrt, square(x.clone())) - x,
            7 => one + apply(Unary::Tanh, scaled),
            8 => one - apply(Unary::Tanh, scaled),
            9 => one + apply(Unary::Signum, x),
            10 => apply(Unary::Exp, scaled),
            11 | 12 => Scalar::If(Box::new(less(&c, &q)), Box::new(number), Box::new(zero)),
            13 => {
                // a window
                let end = c.clone() + self.large();
                let inside = Condition::And(Box::new(less(&c, &q)), Box::new(less(&q, &end)));
                Scalar::If(Box::new(inside), Box::new(number), Box::new(zero))
            }
            14 => apply(Unary::Floor, over(q, wide)),
            15 => both(Binary::Max, apply(Unary::Floor, over(q, wide)), zero),
            16 => both(Binary::Min, both(Binary::Max, scaled, zero), one),
            17 => apply(Unary::Asin, apply(Unary::Sin, q.clone())) - q,
            18 => apply(Unary::Atan, apply(Unary::Tan, q.clone())) - q,
            19 => apply(Unary::Acos, apply(Unary::Cos, q.clone())) - q,
            20 => both(Binary::Powf, square(x.clone()), Scalar::literal(5, -1)) - x,
            21 => apply(Unary::Exp, -square(scaled)),
            22 => both(Binary::Hypot, x.clone(), zero) - x,
            23 => one.clone() - over(one.clone(), one + apply(Unary::Exp, scaled)),
            24 => {
                let other = self.quantity();
                both(Binary::Max, x.clone(), other) - x
            }
            25 => apply(Unary::Sqrt, square(x.clone())) * x.clone() - square(x),
            26 => apply(Unary::Abs, x.clone()) * apply(Unary::Sqrt, square(x.clone())) - square(x),
            27 => {
                let side = Scalar::If(
                    Box::new(less(&c, &q)),
                    Box::new(x.clone()),
                    Box::new(-x.clone()),
                );
                side - apply(Unary::Abs, x)
            }
            28 => {
                both(Binary::Atan2, x.clone(), apply(Unary::Abs, x.clone())) * whole(4)
                    - Scalar::literal(314_159_265_359, -11)
            }
            29 => x.clone() * apply(Unary::Signum, x.clone()) - x,
            // the same on each side of a pole or of a cut, and another number there
            35 => apply(Unary::Atan, apply(Unary::Recip, x.clone())) + apply(Unary::Atan, x),
            36 => {
                both(
                    Binary::Atan2,
                    apply(Unary::Sin, q.clone()),
                    apply(Unary::Cos, q.clone()),
                ) - q
            }
            37 => over(apply(Unary::Sqrt, square(x.clone())), x),
            38 => over(x.clone(), apply(Unary::Abs, x)),
            // zero for a reason
            30 => apply(Unary::Cbrt, Scalar::Power(Box::new(x.clone()), 3)) - x,
            31 => square(apply(Unary::Sin, x.clone())) + square(apply(Unary::Cos, x)) - whole(1),
            32 => {
                let (a, b) = (x, self.quantity());
                let least = both(Binary::Min, a.clone(), b.clone());
                least + both(Binary::Max, a.clone(), b.clone()) - a - b
            }
            33 => {
                // doubles hold the exponential
                let bounded = apply(Unary::Tanh, scaled);
                apply(Unary::Ln, apply(Unary::Exp, bounded.clone())) - bounded
            }
            34 => both(Binary::Max, x.clone(), zero.clone()) * both(Binary::Min, x, zero),
            _ => {
                square(apply(Unary::Cosh, scaled.clone()))
                    - square(apply(Unary::Sinh, scaled))
                    - whole(1)
            }
        }
    }

    /// Few loads, most of them with a gate: so that claims are made that these refute.
    pub fn sparse_loads(&mut self) {
        let is_constrained = self.takes_constraints() && self.chance(0.15);
        if !is_constrained && self.chance(0.2) {
            self.reactions();
        }
        if self.chance(0.25) {
            let load = self.load();
            self.body.loads.push(load);
        }
        if self.chance(0.3) {
            let weight = self.weight();
            self.body.loads.push(weight);
        }
        for _ in 0..self.random.usize(1..=2) {
            let load = self.gated_load();
            if self.chance(0.1) {
                let opposite = self.opposite(&load);
                self.body.loads.push(opposite);
            }
            self.body.loads.push(load);
        }
        if is_constrained {
            self.constraints();
        }
    }

    fn gated_load(&mut self) -> Load {
        let takes_moments = self.body.motion.turns();
        let mut factor = Scalar::Literal(self.signed(0)) * self.gate();
        if self.chance(0.3) {
            self.body.locals.push(Local::Scalar(factor));
            factor = Scalar::Local(self.body.locals.len() - 1);
        }
        if takes_moments && self.random.bool() {
            let what = if self.body.motion.is_planar() {
                What::PlaneMoment(factor)
            } else {
                let vector = self.direction();
                What::Moment(
                    factor
                        * if self.is_rod() {
                            Vector::Cross(Box::new(Vector::Axis), Box::new(vector))
                        } else {
                            vector
                        },
                )
            };
            return Load {
                key: Key::Moments,
                what,
            };
        }
        let place = if takes_moments && self.random.bool() {
            self.point_of_action()
        } else {
            Place::Center
        };
        let vector = self.direction();
        Load {
            key: Key::Forces,
            what: What::Force(factor * vector, place),
        }
    }

    /// Along an axis as often as not, or along a vector of the state.
    pub fn direction(&mut self) -> Vector {
        let motion = &self.body.motion;
        let (moves, turns) = (motion.moves(), motion.turns() && !motion.is_planar());
        match self.random.u32(..8) {
            0 if moves => self.pick(&[Vector::Velocity, Vector::Position]),
            1 if turns && !self.is_rod() => Vector::AngularVelocity,
            2 | 3 => self.written(),
            _ => {
                let axes = if self.is_rod() {
                    Axes::World
                } else {
                    self.pick(&[Axes::Body, Axes::World])
                };
                let axis = self.random.usize(..self.body.axes());
                Vector::Written(axes, [0, 1, 2].map(|i| whole(i64::from(i == axis))))
            }
        }
    }
}
